// Hidden scenes: the public ones with another camera, other lights, other numbers, from a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/grade/assignment/rubric.hpp"

namespace kreda::tools {

/// The text of a scene with its places, directions, colours and constants moved: what it shows stays, no number of it
/// can be learnt by heart. The same seed gives the same text. Scenes that are seen without perspective have their
/// corners on pixel centres on purpose: their objects are moved by whole pixels, all else stays.
[[nodiscard]] std::string vary_scene(const std::string& text, std::uint32_t seed);

/// One file for each of the rubric's scenes, "two_lamps_17.toml", and its picture beside it, to look at. Every function
/// of the assignment is called by them. Throws UserError. Returns the scene files.
std::vector<std::filesystem::path> write_hidden_scenes(const Rubric& rubric, std::uint32_t seed,
                                                       const std::filesystem::path& folder);

/// The golden pictures of the public scenes, golden/NAME.png beside the rubric. Returns the files. Throws UserError.
std::vector<std::filesystem::path> write_golden_pictures(const Rubric& rubric);

}  // namespace kreda::tools
