// How the pages of grading look, on top of the style of all pages.
#pragma once

namespace kreda::tools {

inline constexpr const char* kReportStyle = R"css(
:root { --good: #3c7d4b; --bad: #b3322a; }
@media (prefers-color-scheme: dark) { :root { --good: #86c795; --bad: #f08a80; } }
header h1 { font-size: 2.2rem; }
header p { margin-bottom: .7rem; }
.total { font-size: 1.5rem; color: var(--ink); font-variant-numeric: tabular-nums; }
.total b { color: var(--accent); }
.good { color: var(--good); } .bad { color: var(--bad); }
header .first { border-left: 5px solid var(--accent); padding: .2rem 1rem; white-space: pre-wrap; max-width: none;
               color: var(--ink); font-size: 1rem; }
.first b { font-weight: 600; }
h2 { margin: 2.2rem 0 .8rem; }
article h3 { display: flex; gap: .7rem; align-items: baseline; }
article h3 .points { margin-left: auto; font-weight: 600; white-space: nowrap; }
article.failed { border-left: 5px solid var(--bad); }
article.passed { border-left: 5px solid var(--good); }
article .teaches { color: var(--soft); margin: 0 0 .8rem; }
article pre { white-space: pre-wrap; margin: .6rem 0; }
table { margin: .6rem 0; font-variant-numeric: tabular-nums; }
td.number, th.number { text-align: right; }
tr.wrong td { color: var(--bad); font-weight: 600; }
.slide { position: relative; max-width: 44rem; --at: 50%; }
.slide img { display: block; width: 100%; height: auto; image-rendering: pixelated; border-radius: 7px; }
.slide img + img { position: absolute; top: 0; left: 0; clip-path: inset(0 calc(100% - var(--at)) 0 0); }
.slide input { width: 100%; margin: .5rem 0 0; accent-color: var(--accent); }
.slide .line { position: absolute; top: 0; bottom: 2rem; left: var(--at); border-left: 2px solid var(--accent); }
.sides { display: flex; justify-content: space-between; color: var(--soft); font-size: .9rem; }
.pair { display: grid; gap: 1.2rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 22rem), 1fr)); }
.pair img { image-rendering: pixelated; border-radius: 7px; }
.again { font-size: .9rem; color: var(--soft); }
summary { cursor: pointer; padding: .3rem 0; }
.bars { display: grid; grid-template-columns: minmax(0, max-content) minmax(5rem, 1fr); gap: .25rem .8rem; align-items: center; }
.bars i { display: block; height: 1.15rem; min-width: 2px; background: var(--accent); border-radius: 3px; }
.bars div { display: flex; gap: .5rem; align-items: center; }
.bars span { font-variant-numeric: tabular-nums; }
.bars div span { white-space: nowrap; }
)css";

}  // namespace kreda::tools
