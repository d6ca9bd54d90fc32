// What fuzzing drives: each path by which bytes that somebody else made come in. A reader may refuse (UserError); it
// must not crash, hang, or read what is not there.
#pragma once

#include <string>
#include <vector>

namespace kreda::tests {

struct FuzzedReader {
    std::string name;  ///< the folder of its seeds, tests/fuzz/seeds/NAME
    void (*read)(const std::string& bytes, const std::string& folder);  ///< `folder`: its own, to write files into
};

/// scene, obj, mtl, gltf, image.
[[nodiscard]] const std::vector<FuzzedReader>& fuzzed_readers();

}  // namespace kreda::tests
