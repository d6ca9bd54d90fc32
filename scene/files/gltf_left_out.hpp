// What a glTF file asks for and Kreda does not model: named in one warning, each thing once.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace kreda::scene {

struct LeftOut {
    std::vector<std::string> things;  ///< "animations", in the order in which they were met

    void add(const std::string& thing) {
        if (std::find(things.begin(), things.end(), thing) == things.end()) things.push_back(thing);
    }
};

}  // namespace kreda::scene
