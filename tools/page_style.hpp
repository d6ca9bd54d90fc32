// How the pages of measuring and grading look: dark or light as the browser asks.
#pragma once

namespace kreda::tools {

inline constexpr const char* kPageStyle = R"css(
:root { color-scheme: light dark; --ground: #f7f5f0; --card: #fffefb; --ink: #23282b; --soft: #667077;
        --line: #e0dcd2; --accent: #a8481f; --code: #efece4; }
@media (prefers-color-scheme: dark) {
  :root { --ground: #171b1a; --card: #1f2523; --ink: #ebe8e0; --soft: #9aa5a0; --line: #333b38; --accent: #f0a878;
          --code: #29302d; } }
* { box-sizing: border-box; }
html { scroll-behavior: smooth; scroll-padding-top: 4rem; }
body { margin: 0; background: var(--ground); color: var(--ink); overflow-wrap: break-word;
       font: 17px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; }
a { color: var(--accent); text-decoration-thickness: 1px; text-underline-offset: .18em; }
a:focus-visible { outline: 3px solid var(--accent); outline-offset: 3px; border-radius: 3px; }
header, main, footer { max-width: 76rem; margin: 0 auto; padding: 0 1.25rem; }
header { padding-top: 3rem; }
header h1 { font-size: 3.2rem; letter-spacing: -.03em; line-height: 1; margin: 0 0 .8rem; }
header p { font-size: 1.15rem; color: var(--soft); max-width: 44rem; margin: 0 0 1.6rem; }
nav { position: sticky; top: 0; z-index: 1; background: var(--ground); border-bottom: 1px solid var(--line); }
nav div { max-width: 76rem; margin: 0 auto; padding: .65rem 1.25rem; display: flex; flex-wrap: wrap; gap: .3rem 1.3rem; }
nav a { color: var(--ink); text-decoration: none; font-size: .95rem; }
nav a:hover { color: var(--accent); }
nav b { color: var(--accent); font-weight: 600; margin-right: .3rem; }
section > h2 { font-size: 1.9rem; letter-spacing: -.02em; margin: 3rem 0 1rem; }
section > h2 b { color: var(--accent); font-weight: 600; margin-right: .45rem; }
article { background: var(--card); border: 1px solid var(--line); border-radius: 12px; padding: 1.3rem 1.4rem 1.5rem;
          margin: 0 0 1.3rem; }
article h3 { margin: 0 0 .35rem; font-size: 1.3rem; line-height: 1.25; }
article h3 a { color: inherit; text-decoration: none; }
article h3 a:hover { color: var(--accent); }
article h3 span { color: var(--soft); font-weight: 400; margin-right: .45rem; font-variant-numeric: tabular-nums; }
article > p { margin: 0 0 1rem; max-width: 52rem; }
figure { margin: 0; }
figure a { display: block; background: #0002; border-radius: 7px; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; transition: opacity .15s; }
figure a:hover img { opacity: .86; }
figcaption { color: var(--soft); font-size: .87rem; line-height: 1.35; margin-top: .4rem; }
code, pre { font: .88em/1.5 ui-monospace, "Cascadia Mono", "DejaVu Sans Mono", Menlo, monospace; }
code { background: var(--code); padding: .1em .32em; border-radius: 4px; }
pre { background: var(--code); padding: .9rem 1.1rem; border-radius: 8px; overflow-x: auto; }
pre code { background: none; padding: 0; font-size: 1em; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .95rem; }
th, td { text-align: left; vertical-align: top; padding: .4rem 1rem .4rem 0; border-bottom: 1px solid var(--line); }
footer { color: var(--soft); font-size: .9rem; padding-top: 2.5rem; padding-bottom: 3rem; }
)css";

}  // namespace kreda::tools
