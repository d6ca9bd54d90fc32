// Whole processes, from command to PNG: what a user waits for.
#pragma once

#include <string>
#include <vector>

namespace kreda::tools {

struct ProcessOptions {
    std::vector<std::string> scenes;  ///< TOML files
    int rounds = 5;                   ///< how often each is drawn; they take turns
    int threads = 2;
};

/// `kreda render SCENE --time` again and again as processes of their own: medians as a Markdown table on stdout. Throws
/// UserError where a scene cannot be drawn.
void time_processes(const ProcessOptions& options);

/// Write the workload W9 into a folder: an OBJ of a million triangles with normals and uv, three textures, an image of
/// an environment, and the scene W9.toml. Throws UserError.
void write_million_triangles(const std::string& folder);

/// Write the workload W10 into a folder: the scene W10.toml, a hundred layers over the whole picture in no order.
/// Throws UserError.
void write_layers(const std::string& folder);

}  // namespace kreda::tools
