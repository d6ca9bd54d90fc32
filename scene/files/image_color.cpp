#include "scene/files/image_color.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

#include "scene/files/toml_tree.hpp"

namespace kreda::scene {

namespace {

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// The channel of any of these names, in lower case; -1 without one.
int find_channel(const std::vector<std::string>& names, std::initializer_list<const char*> wanted) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string name = lower_case(names[i]);
        if (std::find(wanted.begin(), wanted.end(), name) != wanted.end()) return static_cast<int>(i);
    }
    return -1;
}

/// "the channel Z alone", "the channels R and G", "the channels a, b and c".
std::string list_text(const std::vector<std::string>& names, const std::vector<int>& chosen) {
    if (chosen.size() == 1) return "the channel " + on_one_line(names[std::size_t(chosen[0])]) + " alone";
    constexpr std::size_t kMostNamed = 8;
    const std::size_t named = std::min(chosen.size(), kMostNamed);
    std::string text = "the channels ";
    for (std::size_t i = 0; i < named; ++i) {
        const bool is_last = i + 1 == chosen.size();
        text += (i == 0 ? "" : is_last ? " and " : ", ") + on_one_line(names[std::size_t(chosen[i])]);
    }
    return text + (named < chosen.size() ? " and others" : "");
}

std::string name_of(const std::vector<std::string>& names, int channel) {
    return on_one_line(names[static_cast<std::size_t>(channel)]);
}

/// Neither red, green and blue nor a plain grey: say so.
ColorChannels odd_channels(const std::vector<std::string>& names, const std::vector<int>& chosen) {
    ColorChannels channels;
    channels.found = "has " + list_text(names, chosen);
    if (chosen.size() < 3) {
        channels.count = 1;
        channels.index = {chosen[0], chosen[0], chosen[0]};
        channels.made = chosen.size() == 1 ? "it is taken as grey" : name_of(names, chosen[0]) + " is taken as grey";
        return channels;
    }
    channels.index = {chosen[0], chosen[1], chosen[2]};
    channels.made = name_of(names, chosen[0]) + ", " + name_of(names, chosen[1]) + " and " + name_of(names, chosen[2]) +
                    " are taken as red, green and blue";
    return channels;
}

}  // namespace

ColorChannels color_channels(const std::vector<std::string>& names, int alpha) {
    ColorChannels channels;
    channels.index = {find_channel(names, {"r", "red"}), find_channel(names, {"g", "green"}),
                      find_channel(names, {"b", "blue"})};
    const auto [r, g, b] = channels.index;
    if (r >= 0 && g >= 0 && b >= 0) return channels;
    std::vector<int> chosen;
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        if (i != alpha) chosen.push_back(i);
    }
    if (chosen.empty()) chosen.push_back(0);
    if (r >= 0 && g >= 0) {
        channels.found = "has " + list_text(names, chosen) + " and no blue one";
        channels.made = "its colours are without blue";
        return channels;
    }
    const int grey = find_channel(names, {"y", "i", "l", "grey", "gray", "luminance", "intensity"});
    if (grey < 0) return odd_channels(names, chosen);
    channels.count = 1;
    channels.index = {grey, grey, grey};
    if (chosen.size() == 1) return channels;
    channels.found = "has " + list_text(names, chosen);
    channels.made = name_of(names, grey) + " is taken as grey";
    return channels;
}

std::string encoding_remark(const StoredImage& image) {
    const std::string bits = std::to_string(image.bits) + " bits";
    if (!image.unknown_space.empty()) {
        return "says that its colours are " + in_quotes(image.unknown_space) + "; they are decoded as sRGB";
    }
    if (image.encoding == Encoding::linear && image.bits > 0) {
        return "says that its colours of " + bits + " are linear; they are not decoded";
    }
    if (image.encoding != Encoding::power) return "";
    char gamma[32];
    std::snprintf(gamma, sizeof gamma, "%g", static_cast<double>(image.gamma));
    return std::string("says that its gamma is ") + gamma + "; its colours are decoded by that power instead of sRGB";
}

raster::Image linear_colors(StoredImage stored, const ColorChannels& channels) {
    const bool is_plain = channels.count == stored.image.channels && channels.index[0] == 0 &&
                          (channels.count == 1 || (channels.index[1] == 1 && channels.index[2] == 2));
    if (stored.encoding == Encoding::linear && is_plain) return std::move(stored.image);
    raster::Image colors = raster::make_image(stored.image.width, stored.image.height, channels.count);
    const auto decode = [&](float value) { return linear_from_stored(value, stored); };
    for (int c = 0; c < channels.count; ++c) {
        const int from = channels.index[static_cast<std::size_t>(c)];
        if (from < 0) continue;
        decode_plane(stored.image.plane(from), colors.plane_size(), stored.levels(), decode, colors.plane(c));
    }
    return colors;
}

void divide_by_alpha(raster::Image& image, const ColorChannels& channels, int alpha) {
    const float* opacity = image.plane(alpha);
    for (int c = 0; c < channels.count; ++c) {
        const int channel = channels.index[static_cast<std::size_t>(c)];
        if (channel < 0 || channel == alpha) continue;
        float* color = image.plane(channel);
        for (std::size_t i = 0; i < image.plane_size(); ++i) {
            const bool is_partial = opacity[i] > 0.0f && opacity[i] < 1.0f;
            color[i] /= is_partial ? opacity[i] : 1.0f;
        }
    }
}

}  // namespace kreda::scene
