// How far a long piece of work is, on the last line of a terminal. Where stderr is a file or a pipe nothing is written.
#pragma once

#include <string>

#include "lighting/environment/progress.hpp"

namespace kreda::tools {

/// Replace the line; an empty text removes it.
void show_status(const std::string& text);

/// "baking dawn.hdr [#########.....................]  31 %".   share is clamped to 0..1.
[[nodiscard]] std::string progress_text(const std::string& work, double share);

/// A bar that grows while it is told how far the work is, and goes away with the object.
class ProgressBar {
public:
    explicit ProgressBar(std::string work) : work_(std::move(work)) {}
    ~ProgressBar() {
        clear();
    }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double share);
    void clear();

    /// The object outlives it.
    [[nodiscard]] lighting::Progress progress() {
        return [this](double share) { show(share); };
    }

private:
    std::string work_;
    int shown_percent_ = -1;
};

}  // namespace kreda::tools
