// An experiment: a question about speed and accuracy, and the function that answers it.
#pragma once

#include <string_view>
#include <vector>

#include "lighting/environment/progress.hpp"
#include "tools/measure/finding.hpp"

namespace kreda::tools {

struct Effort {
    bool quick = false;  ///< fewer angles, samples and rounds: all experiments within ten minutes on two cores
    int threads = 0;     ///< of what is rendered; 0: one a core
    lighting::Progress progress;

    /// How many, of a thing that takes time.
    [[nodiscard]] int count(int when_quick, int else_) const {
        return quick ? when_quick : else_;
    }
    void show(double share) const {
        if (progress) progress(share);
    }
};

struct Experiment {
    std::string_view name;  ///< of its files
    std::string_view asks;  ///< the question
    Finding (*run)(const Effort& effort) = nullptr;
};

/// All experiments, in the order of the pipeline.
[[nodiscard]] const std::vector<Experiment>& experiments();

/// The experiment of that name, or nullptr.
[[nodiscard]] const Experiment* find_experiment(std::string_view name);

}  // namespace kreda::tools
