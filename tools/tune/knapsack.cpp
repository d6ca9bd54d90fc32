#include "tools/tune/knapsack.hpp"

#include <algorithm>
#include <utility>

#include "raster/platform.hpp"

namespace kreda::tools {

std::vector<KnapsackChoice> front_of(std::vector<KnapsackChoice> choices) {
    std::stable_sort(choices.begin(), choices.end(), [](const KnapsackChoice& a, const KnapsackChoice& b) {
        return std::pair(a.error, a.cost) < std::pair(b.error, b.cost);
    });
    std::vector<KnapsackChoice> front;
    for (KnapsackChoice& choice : choices) {
        if (front.empty() || choice.cost < front.back().cost) front.push_back(std::move(choice));
    }
    return front;
}

std::vector<KnapsackChoice> pareto_front(const std::vector<std::vector<KnapsackOption>>& classes, double most_error) {
    std::vector<KnapsackChoice> front = {{}};
    for (const std::vector<KnapsackOption>& options : classes) {
        KREDA_EXPECT(!options.empty());
        std::vector<KnapsackChoice> merged;
        for (const KnapsackChoice& part : front) {
            for (std::size_t o = 0; o < options.size(); ++o) {
                if (part.error + options[o].error > most_error) continue;
                KnapsackChoice choice = part;
                choice.cost += options[o].cost;
                choice.error += options[o].error;
                choice.chosen.push_back(static_cast<int>(o));
                merged.push_back(std::move(choice));
            }
        }
        front = front_of(std::move(merged));
    }
    return front;
}

double hypervolume(const std::vector<KnapsackChoice>& choices, double corner_cost, double corner_error) {
    double volume = 0.0, cost = corner_cost;
    for (const KnapsackChoice& choice : front_of(choices)) {
        if (choice.error >= corner_error || choice.cost >= cost) continue;
        volume += (corner_error - choice.error) * (cost - choice.cost);
        cost = choice.cost;
    }
    return volume;
}

}  // namespace kreda::tools
