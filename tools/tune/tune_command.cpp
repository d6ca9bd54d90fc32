#include <CLI/CLI.hpp>

#include "tools/commands.hpp"

namespace kreda::tools {

void add_tune_command(CLI::App&) {}

}  // namespace kreda::tools
