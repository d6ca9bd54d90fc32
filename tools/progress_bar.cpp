#include "tools/progress_bar.hpp"

#include <algorithm>
#include <iostream>

#include <unistd.h>

namespace kreda::tools {

namespace {

int percent_of(double share) {
    return static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
}

}  // namespace

void show_status(const std::string& text) {
    if (isatty(STDERR_FILENO)) std::cerr << "\r\x1b[K" << text << std::flush;
}

std::string progress_text(const std::string& work, double share) {
    constexpr int kWidth = 30;
    const int percent = percent_of(share);
    const auto filled = static_cast<std::size_t>(percent * kWidth / 100);
    std::string number = std::to_string(percent);
    number.insert(0, 4 - number.size(), ' ');
    return work + " [" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "]" + number + " %";
}

void ProgressBar::clear() {
    if (shown_percent_ >= 0) show_status("");
    shown_percent_ = -1;
}

void ProgressBar::show(double share) {
    const int percent = percent_of(share);
    if (percent == shown_percent_) return;
    shown_percent_ = percent;
    show_status(progress_text(work_, share));
}

}  // namespace kreda::tools
