#include "scene/files/image_message.hpp"

#include <cstdint>

#include "scene/files/child_process.hpp"

namespace kreda::scene {

namespace {

/// Numbers that go as they lie in memory: both ends are the same program.
struct Numbers {
    std::int32_t width = 0, height = 0, channels = 0;
    std::int32_t bits = 0, encoding = 0, is_divided = 0, alpha = 0;
    float gamma = 0.0f;
    std::uint64_t channel_names = 0, remarks = 0, bytes = 0;
};

Numbers numbers_of(const ImageMessage& message) {
    const StoredImage& stored = message.stored;
    return {.width = stored.image.width,
            .height = stored.image.height,
            .channels = stored.image.channels,
            .bits = stored.bits,
            .encoding = static_cast<std::int32_t>(stored.encoding),
            .is_divided = stored.is_divided ? 1 : 0,
            .alpha = stored.alpha,
            .gamma = stored.gamma,
            .channel_names = stored.channels.size(),
            .remarks = stored.remarks.size(),
            .bytes = message.bytes.size()};
}

/// Whether memory of this size may be asked for.
bool is_allowed(const Numbers& numbers, const ImageReadOptions& options) {
    constexpr std::uint64_t kMostTexts = 1 << 16, kMostBytes = std::uint64_t(1) << 40;
    const auto is_side = [&](std::int32_t side) { return side >= 0 && side <= options.max_side; };
    if (!is_side(numbers.width) || !is_side(numbers.height) || numbers.channels < 0) return false;
    const std::int64_t pixels = std::int64_t(numbers.width) * numbers.height;
    if (pixels > 0 && numbers.channels > options.max_values / pixels) return false;
    return numbers.channel_names <= kMostTexts && numbers.remarks <= kMostTexts && numbers.bytes <= kMostBytes;
}

bool send_text(int pipe, const std::string& text) {
    const std::uint64_t size = text.size();
    return write_all(pipe, &size, sizeof size) && write_all(pipe, text.data(), text.size());
}

bool receive_text(int pipe, std::string& text) {
    constexpr std::uint64_t kMost = 1 << 24;
    std::uint64_t size = 0;
    if (!read_all(pipe, &size, sizeof size) || size > kMost) return false;
    text.resize(size);
    return read_all(pipe, text.data(), size);
}

bool receive_texts(int pipe, std::uint64_t count, std::vector<std::string>& texts) {
    texts.resize(count);
    for (std::string& text : texts) {
        if (!receive_text(pipe, text)) return false;
    }
    return true;
}

}  // namespace

bool send_message(int pipe, const ImageMessage& message) {
    const StoredImage& stored = message.stored;
    const Numbers numbers = numbers_of(message);
    bool is_sent = write_all(pipe, &numbers, sizeof numbers) && send_text(pipe, message.complaint) &&
                   send_text(pipe, stored.unknown_space);
    for (const std::string& name : stored.channels) is_sent = is_sent && send_text(pipe, name);
    for (const std::string& remark : stored.remarks) is_sent = is_sent && send_text(pipe, remark);
    return is_sent && write_all(pipe, stored.image.values.data(), stored.image.values.size() * sizeof(float)) &&
           write_all(pipe, message.bytes.data(), message.bytes.size());
}

bool receive_message(int pipe, const ImageReadOptions& options, ImageMessage& message) {
    Numbers numbers;
    StoredImage& stored = message.stored;
    if (!read_all(pipe, &numbers, sizeof numbers) || !is_allowed(numbers, options)) return false;
    if (!receive_text(pipe, message.complaint) || !receive_text(pipe, stored.unknown_space)) return false;
    if (!receive_texts(pipe, numbers.channel_names, stored.channels)) return false;
    if (!receive_texts(pipe, numbers.remarks, stored.remarks)) return false;
    stored.bits = numbers.bits;
    stored.encoding = static_cast<Encoding>(numbers.encoding);
    stored.is_divided = numbers.is_divided != 0;
    stored.alpha = numbers.alpha;
    stored.gamma = numbers.gamma;
    stored.image = raster::make_image(numbers.width, numbers.height, numbers.channels);
    message.bytes.resize(numbers.bytes);
    return read_all(pipe, stored.image.values.data(), stored.image.values.size() * sizeof(float)) &&
           read_all(pipe, message.bytes.data(), message.bytes.size());
}

}  // namespace kreda::scene
