// How every plot looks. Okabe and Ito's colours, which are told apart without red and green; each has a dash and a
// marker of its own, so that paper in black and white is enough.
#pragma once

namespace kreda::tools {

inline constexpr const char* kPlotStyle = R"(set encoding utf8
set grid linecolor rgb frame linewidth 0.5 dashtype 3
set border 3 linecolor rgb ink
set tics nomirror textcolor rgb ink
set title textcolor rgb ink
set key textcolor rgb ink
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set for [i=1:8] linetype i linecolor rgb word(colors, i) linewidth 2.5
set linetype 1 dashtype 1 pointtype 7
set linetype 2 dashtype (8,4) pointtype 5
set linetype 3 dashtype (3,3) pointtype 9
set linetype 4 dashtype (10,3,2,3) pointtype 13
set linetype 5 dashtype (14,4) pointtype 6
set linetype 6 dashtype (2,5) pointtype 4
set linetype 7 dashtype (10,3,2,3,2,3) pointtype 8
set linetype 8 dashtype (5,2) pointtype 12
)";

inline constexpr const char* kLightPlot = R"(ink = '#20262b'; frame = '#8a949b'; paper = '#fbf9f3'
colors = "#0072b2 #d55e00 #007a5e #000000 #b5568c #3d8fc4 #9a6700 #5a656c"
)";

inline constexpr const char* kDarkPlot = R"(ink = '#f2eee4'; frame = '#5d6971'; paper = '#20262b'
colors = "#f0e442 #56b4e9 #e69f00 #f2eee4 #2fc79b #f08fc0 #ff8a50 #8a949b"
)";

}  // namespace kreda::tools
