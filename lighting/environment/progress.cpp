#include "lighting/environment/progress.hpp"

namespace kreda::lighting {

std::vector<Progress> progress_of_steps(const Progress& whole, const std::vector<double>& work) {
    if (!whole) return std::vector<Progress>(work.size());
    double all = 0.0;
    for (const double part : work) all += part;
    if (all <= 0.0) all = 1.0;
    std::vector<Progress> steps;
    double before = 0.0;
    for (const double part : work) {
        const double from = before / all;
        const double to = (before + part) / all;
        steps.emplace_back([whole, from, to](double share) { whole(from + share * (to - from)); });
        before += part;
    }
    return steps;
}

void WorkCounter::add(double work) {
    if (!progress_) return;
#pragma omp critical(kreda_progress)
    {
        done_ += work;
        progress_(done_ / all_work_);
    }
}

}  // namespace kreda::lighting
