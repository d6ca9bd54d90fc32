#include "layout.hpp"

#include <fstream>
#include <sstream>

namespace kreda::tests {

namespace {

bool overlap(const PlacedText& a, const PlacedText& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

std::vector<PlacedText> read_layout(const std::string& file) {
    std::vector<PlacedText> texts;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        PlacedText t;
        std::istringstream words(line);
        words >> t.picture >> t.width >> t.height >> t.left >> t.top >> t.right >> t.bottom >> t.size;
        std::getline(words >> std::ws, t.text);
        texts.push_back(t);
    }
    return texts;
}

std::vector<std::string> layout_faults(const std::vector<PlacedText>& texts) {
    std::vector<std::string> faults;
    const auto add = [&](const PlacedText& t, const std::string& fault) {
        faults.push_back(t.picture + ": '" + t.text + "' " + fault);
    };
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const PlacedText& t = texts[i];
        if (t.left < 0.0f || t.top < 0.0f || t.right > t.width || t.bottom > t.height) add(t, "leaves the picture");
        if (t.size < 0.999f * t.height / 30.0f) add(t, "is too small");  // the file has six digits
        for (std::size_t k = 0; k < i; ++k) {
            if (t.picture == texts[k].picture && overlap(t, texts[k])) add(t, "lies over '" + texts[k].text + "'");
        }
    }
    return faults;
}

}  // namespace kreda::tests
