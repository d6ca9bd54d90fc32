// How far a long piece of work is: told to whoever shows it, e.g. as a bar in a terminal.
#pragma once

#include <functional>
#include <vector>

namespace kreda::lighting {

/// Called now and then with the share of the work that is done, 0..1, by one thread at a time.
using Progress = std::function<void(double share)>;

/// The progress of each of several steps that follow one another: step i moves `whole` on by its part of the work.
/// Empty functions when `whole` is empty.
[[nodiscard]] std::vector<Progress> progress_of_steps(const Progress& whole, const std::vector<double>& work);

/// Adds up what several threads have done.
class WorkCounter {
public:
    /// `all_work`: operations until the bar is full.
    WorkCounter(double all_work, const Progress& progress) : all_work_(all_work), progress_(progress) {}
    WorkCounter(const WorkCounter&) = delete;
    WorkCounter& operator=(const WorkCounter&) = delete;

    /// From any thread.
    void add(double work);

private:
    double all_work_;
    double done_ = 0.0;
    const Progress& progress_;
};

}  // namespace kreda::lighting
