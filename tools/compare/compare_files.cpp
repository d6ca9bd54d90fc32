#include "tools/compare/compare_files.hpp"

#include <optional>

namespace kreda::tools {

namespace {

using scene::StoredImage;

std::string names_text(const StoredImage& image) {
    std::string text;
    for (const std::string& name : image.channels) text += (text.empty() ? "" : " ") + name;
    return text;
}

void add_gate(Comparison& result, const std::string& name, const std::string& found, const std::string& expected) {
    const bool ok = found == expected;
    result.checks.push_back({name, ok ? 0.0 : 1.0, 0.0, ok ? found : found + ", expected " + expected, ok});
    result.passed = result.passed && ok;
}

}  // namespace

std::string numbers_text(const StoredImage& image) {
    const std::string kind = image.bits > 0 ? std::to_string(image.bits) + " bits" : "floating point";
    if (image.encoding == scene::Encoding::linear) return kind + ", linear";
    if (image.encoding == scene::Encoding::srgb) return kind + ", sRGB";
    return kind + ", gamma " + values_text({double(image.gamma)});
}

ComparedFiles compare_files(const std::string& actual, const std::string& expected, const std::string& mask,
                            const CompareLimits& limits) {
    ComparedFiles files{scene::read_stored_image(actual), scene::read_stored_image(expected), {}, {}};
    std::optional<raster::Image> mask_image;
    if (!mask.empty()) mask_image = scene::read_image(mask);
    files.numbers.levels = files.expected.levels();
    files.result =
        compare(files.actual.image, files.expected.image, files.numbers, limits, mask_image ? &*mask_image : nullptr);
    add_gate(files.result, "kind of numbers", numbers_text(files.actual), numbers_text(files.expected));
    if (files.actual.channels.size() == files.expected.channels.size())
        add_gate(files.result, "names of channels", names_text(files.actual), names_text(files.expected));
    return files;
}

}  // namespace kreda::tools
