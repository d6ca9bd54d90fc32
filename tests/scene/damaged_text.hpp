// Texts with a few bytes changed, put in, taken out or repeated: what a parser must survive.
#pragma once

#include <cstddef>
#include <random>
#include <string>

namespace kreda::tests {

class DamagedText {
public:
    explicit DamagedText(unsigned seed) : random_(seed) {}

    [[nodiscard]] std::string of(std::string text) {
        const std::string spice = "0123456789 \t\r\n\\/.,-+#eEvnfgostunail\xff\x01";
        for (std::size_t edits = 1 + below(4); edits > 0 && !text.empty(); --edits) {
            const std::size_t at = below(text.size());
            const std::size_t kind = below(4);
            if (kind == 0) text[at] = spice[below(spice.size())];
            if (kind == 1) text.insert(at, 1, spice[below(spice.size())]);
            if (kind == 2) text.erase(at, 1 + below(8));
            if (kind == 3) text.insert(at, text.substr(below(text.size()), below(30)));
        }
        return below(20) == 0 ? text.substr(0, below(text.size() + 1)) : text;
    }

private:
    std::size_t below(std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
    }
    std::mt19937 random_;
};

}  // namespace kreda::tests
