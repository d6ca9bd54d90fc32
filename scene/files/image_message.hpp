// What a child process that decodes an image says to its parent: the size first, which is checked before any memory is
// asked for, then what is known of the image, and its values.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/files/image_file.hpp"

namespace kreda::scene {

/// An image, or the bytes of a file, or why there is none.
struct ImageMessage {
    StoredImage stored;
    std::vector<unsigned char> bytes;
    std::string complaint;  ///< the whole line; "": there is an image
};

/// Write a message into a pipe. False when nobody reads it.
bool send_message(int pipe, const ImageMessage& message);

/// Read a message from a pipe. False when it is cut off, or promises more values than `options` allow.
[[nodiscard]] bool receive_message(int pipe, const ImageReadOptions& options, ImageMessage& message);

}  // namespace kreda::scene
