// Drawing again whenever something changes that a picture is made of.
#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "scene/files/loaded_files.hpp"

namespace kreda::tools {

/// Calls draw() now, and again when the scene or anything that it reads has changed; `files` knows what that is. Errors
/// of the user are a line on stderr each, and the next change may mend them. Ctrl-C ends the program at any time, with
/// exit code 0, but not while draw() holds `writing`. `output` is what draw() writes: its changes mean nothing.
[[noreturn]] void watch(const std::string& output, scene::LoadedFiles& files, std::mutex& writing,
                        const std::function<void()>& draw);

}  // namespace kreda::tools
