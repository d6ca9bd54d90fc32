// The machine's limits on one core, and how near to them the shading loops come.
#pragma once

namespace kreda::tools {

/// Measure arithmetic and bandwidth with small loops, then lighting a batch with Phong and with Cook-Torrance; a
/// Markdown table on stdout.
void measure_peak();

}  // namespace kreda::tools
