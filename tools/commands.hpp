// The commands of `kreda`: each adds itself, with its options and what it does, to the command line.
#pragma once

namespace CLI {
class App;
}

namespace kreda::tools {

void add_render_command(CLI::App& app);
void add_plan_command(CLI::App& app);
void add_explain_command(CLI::App& app);
void add_stages_command(CLI::App& app);
void add_sweep_command(CLI::App& app);
void add_bake_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_grade_command(CLI::App& app);
void add_hidden_command(CLI::App& app);
void add_keys_command(CLI::App& app);
void add_bench_command(CLI::App& app);
void add_measure_command(CLI::App& app);
void add_brdf_command(CLI::App& app);
void add_tune_command(CLI::App& app);
void add_view_command(CLI::App& app);

}  // namespace kreda::tools
