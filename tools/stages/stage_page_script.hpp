// What the stages' page looks like and does: plain HTML, CSS and JavaScript, nothing from the network.
#pragma once

namespace kreda::tools {

inline constexpr const char* kStagePageStyle = R"css(
:root { color-scheme: dark; --ground: #171b1e; --board: #20262b; --line: #3b464e; --ink: #f2eee4; --soft: #9aa5ab; --accent: #f0a35e; }
* { box-sizing: border-box; }
html, body { height: 100%; margin: 0; }
body { display: grid; grid-template-columns: 15.5rem 1fr; background: var(--ground); color: var(--ink);
       font: 16px/1.45 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif; }
nav { overflow-y: auto; border-right: 1px solid var(--line); background: var(--board); padding: .9rem 0; }
nav h1 { font-size: 1.05rem; margin: 0 1rem .7rem; overflow-wrap: anywhere; }
nav button { display: block; width: 100%; padding: .22rem 1rem; border: 0; background: none; color: var(--soft); font: inherit;
             font-size: .92rem; text-align: left; cursor: pointer; }
nav button:hover { color: var(--ink); }
nav button[aria-current] { background: var(--line); color: var(--ink); box-shadow: inset 3px 0 var(--accent); }
nav b { display: inline-block; width: 1.7rem; color: var(--accent); font-weight: 600; font-variant-numeric: tabular-nums; }
#passes { margin: .9rem 1rem 0; color: var(--soft); font-size: .82rem; }
#passes summary { cursor: pointer; } #passes ol { padding-left: 1.4rem; } #passes b { display: inline; width: auto; color: var(--ink); }
main { display: grid; grid-template-rows: auto 1fr auto; min-width: 0; min-height: 0; padding: .9rem 1.2rem; gap: .7rem; }
header { display: flex; align-items: baseline; gap: .9rem; flex-wrap: wrap; }
header h2 { font-size: 1.7rem; margin: 0; letter-spacing: -.01em; }
header p { margin: 0; color: var(--soft); }
#stage { position: relative; min-height: 0; min-width: 0; display: grid; place-items: center; }
#frame { position: relative; line-height: 0; cursor: crosshair; }
#frame img { display: block; border-radius: 4px; }
#mark { position: absolute; border: 2px solid var(--accent); pointer-events: none; min-width: 8px; min-height: 8px; display: none;
        box-shadow: 0 0 0 1px #000a; }
footer { display: flex; gap: 1.6rem; align-items: baseline; flex-wrap: wrap; min-height: 1.7rem; }
#numbers { font: 1rem/1.4 ui-monospace, "Cascadia Mono", "DejaVu Sans Mono", Menlo, monospace; white-space: pre-wrap; }
#legend, #keys { color: var(--soft); font-size: .88rem; }
#keys { margin-left: auto; }
kbd { border: 1px solid var(--line); border-radius: 4px; padding: 0 .3rem; font: .82rem ui-monospace, monospace; }
body.bare { grid-template-columns: 1fr; } body.bare nav { display: none; }
)css";

inline constexpr const char* kStagePageBody = R"html(<main>
<header><h2 id="title"></h2><p id="meaning"></p></header>
<div id="stage"><div id="frame"><img id="picture" alt=""><div id="mark"></div></div></div>
<footer><div id="numbers"></div><div id="legend"></div>
<div id="keys"><kbd>&larr;</kbd> <kbd>&rarr;</kbd> step &nbsp; click: hold a pixel &nbsp; <kbd>Esc</kbd> let go &nbsp; <kbd>F</kbd> list on and off</div></footer>
</main>
)html";

inline constexpr const char* kStagePageScript = R"js("use strict";
const byId = id => document.getElementById(id);
const picture = byId("picture"), frame = byId("frame"), mark = byId("mark"), list = byId("list");
let current = 0, pointed = null, held = null;

// ---- numbers: float32 without the last byte, most significant bytes first, differences, deflate, base64
const numbers = new Map();                       // stage -> "loading" | "none" | { channels, at(c, x, y) }
async function inflate(base64) {
  const bytes = Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
async function kredaValues(stage, channels, base64) {
  try {
    const bytes = await inflate(base64), size = page.width * page.height;
    for (let plane = 0; plane < 3 * channels; ++plane)
      for (let i = plane * size + 1; i < (plane + 1) * size; ++i) bytes[i] = (bytes[i] + bytes[i - 1]) & 255;
    const view = new DataView(new ArrayBuffer(4));
    numbers.set(stage, { channels, at(c, x, y) {
      for (let k = 0; k < 3; ++k) view.setUint8(k, bytes[(3 * c + k) * size + y * page.width + x]);
      view.setUint8(3, 0);
      return view.getFloat32(0);
    } });
  } catch { numbers.set(stage, "none"); }
  tell();
}
function load(stage) {
  if (numbers.has(stage) || !page.stages[stage].values) return;
  numbers.set(stage, "loading");
  const script = document.createElement("script");
  script.src = page.stages[stage].values;
  script.onerror = () => { numbers.set(stage, "none"); tell(); };
  document.head.append(script);
}
function spell(x) { return Number.isNaN(x) ? "-" : Number.isInteger(x) ? String(x) : String(Number(x.toPrecision(5))); }

// ---- what is said below the picture
function tell() {
  const pixel = held || pointed, stage = page.stages[current], known = numbers.get(current);
  let text = "";
  if (pixel) {
    text = `pixel ${pixel.x}, ${pixel.y}   `;
    if (known && known.at)
      text += stage.components.map((name, c) => `${name} = ${spell(known.at(c, pixel.x, pixel.y))}`).join("   ");
    else if (known === "none") text += "(this browser cannot unpack the numbers)";
    if (held) text += `\nkreda explain ${page.scene ? page.scene + " " : ""}--pixel ${pixel.x},${pixel.y}`;
  } else if (page.hasPixels) text = "Point at a pixel.";
  byId("numbers").textContent = text;
  place();
}
function scale() { return picture.clientWidth / page.pictureWidth; }
function place() {
  mark.style.display = held ? "block" : "none";
  if (!held) return;
  const s = scale();
  mark.style.left = (page.left + held.x + .5) * s + "px";
  mark.style.top = (page.top + held.y + .5) * s + "px";
  mark.style.width = mark.style.height = Math.max(8, s) + "px";
  mark.style.transform = "translate(-50%, -50%)";
}
function pixelAt(event) {
  const box = picture.getBoundingClientRect(), s = scale();
  const x = Math.floor((event.clientX - box.left) / s) - page.left, y = Math.floor((event.clientY - box.top) / s) - page.top;
  return page.hasPixels && x >= 0 && y >= 0 && x < page.width && y < page.height ? { x, y } : null;
}

// ---- stepping
function fit() {
  const room = byId("stage"), s = Math.min(room.clientWidth / page.pictureWidth, room.clientHeight / page.pictureHeight);
  const factor = s > 1 ? Math.max(1, Math.floor(s * 2) / 2) : s;
  picture.style.width = page.pictureWidth * factor + "px";
  picture.style.height = page.pictureHeight * factor + "px";
  picture.style.imageRendering = factor >= 1 ? "pixelated" : "auto";
  place();
}
function show(stage) {
  current = Math.max(0, Math.min(page.stages.length - 1, stage));
  const entry = page.stages[current];
  picture.src = entry.picture;
  picture.alt = entry.meaning;
  byId("title").textContent = entry.title;
  byId("meaning").textContent = entry.meaning;
  byId("legend").textContent = entry.legend;
  list.querySelectorAll("button").forEach((button, i) => {
    if (i === current) { button.setAttribute("aria-current", "true"); button.scrollIntoView({ block: "nearest" }); }
    else button.removeAttribute("aria-current");
  });
  history.replaceState(null, "", "#" + (current + 1));
  load(current);
  tell();
}
page.stages.forEach((entry, i) => {
  const button = document.createElement("button"), number = document.createElement("b");
  number.textContent = String(i + 1).padStart(2, "0");
  button.append(number, entry.title);
  button.onclick = () => { show(i); button.blur(); };
  list.insertBefore(button, byId("passes"));
});
addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const steps = { ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1 };
  if (event.key in steps) show(current + steps[event.key]);
  else if (event.key === "Home") show(0);
  else if (event.key === "End") show(page.stages.length - 1);
  else if (event.key === "Escape") { held = null; tell(); }
  else if (event.key === "f" || event.key === "F") { document.body.classList.toggle("bare"); fit(); }
  else return;
  event.preventDefault();
});
frame.onmousemove = event => { pointed = pixelAt(event); tell(); };
frame.onmouseleave = () => { pointed = null; tell(); };
frame.onclick = event => { held = pixelAt(event); tell(); };
addEventListener("resize", fit);
addEventListener("hashchange", () => show((parseInt(location.hash.slice(1)) || 1) - 1));
show((parseInt(location.hash.slice(1)) || 1) - 1);
fit();
)js";

}  // namespace kreda::tools
