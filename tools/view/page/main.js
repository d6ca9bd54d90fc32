// The page: a scene in the module, its picture on the canvas, controls beside it.
import { CameraHand } from './camera.js';
import { makeControls } from './controls.js';
import { Engine } from './engine.js';
import { unpack } from './unpack.js';
import { drawCross, drawVectors } from './explain.js';
import { chosenFiles, droppedFiles } from './dropped.js';
import { bytesOf, meaningOf, save } from './files.js';
import { listen } from './input.js';

const LONG = 300; // milliseconds: what takes longer is named
const SLOW = 90; // milliseconds: while something moves, a picture that takes longer is drawn coarser
const COARSER = [{ samples: 0, divide: 1 }, { samples: 1, divide: 1 }, { samples: 1, divide: 2 }, { samples: 1, divide: 4 }];
const SIZES = [[320, 180], [480, 270], [640, 360], [960, 540], [1280, 720]];
const TURN_SPEED = 0.5; // radians a second

const $ = (id) => document.getElementById(id);
const source = (id) => $(id).textContent;
const canvas = $('picture');
const screen = canvas.getContext('2d', { alpha: false });
const say = (line) => { $('message').textContent = line; };

const page = { path: '', changes: new Map(), keys: [], scene: null, dirty: true, drawing: null, coarse: 0, moved: 0, list: null, crashes: 0, drawn: 0 };
const hand = new CameraHand({ position: [0, 0, 1], target: [0, 0, 0], up: [0, 1, 0] });
const frames = [];
const mark = { x: 0, y: 0, shown: false };

// ---- scene -----------------------------------------------------------------------------------------------------------

function showViews() {
  const chosen = $('view').value;
  const options = page.scene.views.map(({ name, meaning, requires }) => {
    const option = new Option(name, name);
    option.disabled = Boolean(requires);
    option.title = requires ? `${meaning}; it needs ${requires}` : meaning;
    return option;
  });
  $('view').replaceChildren(new Option('the picture', ''), ...options);
  $('view').value = options.some((o) => o.value === chosen && !o.disabled) ? chosen : '';
}

function showSizes() {
  const sizes = [page.scene.size, ...SIZES].map(([w, h], i) => new Option(`${w} × ${h}${i === 0 ? ' (scene)' : ''}`, `${w} ${h}`));
  const chosen = $('size').selectedIndex;
  $('size').replaceChildren(...sizes);
  $('size').selectedIndex = Math.max(0, chosen);
}

/** Names what is waited for where it takes long: baking an environment takes a second or two. */
async function waited(work, line) {
  const timer = setTimeout(() => { $('numbers').textContent = line; }, LONG);
  try {
    return await work;
  } finally { clearTimeout(timer); }
}

/** Read the scene with these changes; where that fails everything stays as it was. */
async function open(path, changes) {
  const scene = await waited(engine.call('open', path, [...changes.values()]), 'Reading the scene …');
  const isOther = path !== page.path;
  Object.assign(page, { path, changes, scene, dirty: true });
  const camera = [...changes.keys()].some((key) => key.startsWith('camera.')) || !hand.moved;
  if (isOther || camera) hand.begin(scene.camera);
  showViews();
  showSizes();
  say(scene.warnings.length ? `warning: ${scene.warnings.join('; ')}` : '');
  return isOther;
}

function showControls() {
  makeControls($('controls'), page.keys, page.scene.tables, change, page.first);
  $('title').textContent = page.path || 'Kreda, the built-in scene';
  page.list = $('controls').querySelector('[data-path="material.0.model"] select') ?? $('view');
}

/** Changes with more of them, the newest last: of two keys that exclude each other the last one counts. */
function changed(changes, more) {
  const all = new Map(changes);
  for (const text of more) {
    const path = text.split('=')[0].trim();
    all.delete(path);
    all.set(path, text);
  }
  return all;
}

let wanted = null;
/** A control was turned. Of many turns in a row the last counts. */
async function change(text) {
  const isFirst = wanted === null;
  wanted = changed(wanted ?? page.changes, [text]);
  if (!isFirst) return;
  while (wanted !== null) {
    const trying = wanted;
    try {
      await open(page.path, trying);
    } catch (error) { say(error.message); }
    if (wanted === trying) wanted = null;
  }
}

async function openNew(path, changes = new Map()) {
  try {
    await open(path, changes);
    showControls();
  } catch (error) { say(error.message); }
}

// ---- picture ---------------------------------------------------------------------------------------------------------

async function draw() {
  const [width, height] = ($('size').value || '640 360').split(' ').map(Number);
  const isMoving = performance.now() - page.moved < 250;
  const { samples, divide } = COARSER[isMoving ? page.coarse : 0];
  page.dirty = isMoving && page.coarse > 0;
  const size = [Math.max(1, Math.round(width / divide)), Math.max(1, Math.round(height / divide))];
  const drawing = engine.call('draw', hand.pose(), ...size, samples, $('view').value);
  const answer = await waited(drawing, page.drawn === 0 ? 'Drawing the first picture …' : 'Drawing …');
  if (isMoving && answer.whole_ms > SLOW && page.coarse < COARSER.length - 1) page.coarse += 1;
  if (canvas.width !== answer.width) canvas.width = answer.width;
  if (canvas.height !== answer.height) canvas.height = answer.height;
  $('frame').style.setProperty('--aspect', answer.width / answer.height);
  screen.putImageData(new ImageData(new Uint8ClampedArray(answer.rgba), answer.width, answer.height), 0, 0);
  page.drawn += 1;
  $('poster')?.remove(); // the site's picture of this scene, shown until here
  page.crashes = 0;
  showNumbers(answer);
  if (!document.documentElement.dataset.film && !$('view').value) {
    document.documentElement.dataset.film = (await engine.call('hash')).hash;
  }
}

function showNumbers({ ms, whole_ms: whole, width, height }) {
  const now = performance.now();
  frames.push(now);
  while (frames.length > 1 && now - frames[0] > 1000) frames.shift();
  const rate = frames.length > 3 ? `${((frames.length - 1) * 1000 / (now - frames[0])).toFixed(0)} frames a second, ` : '';
  const threads = engine.threads > 1 ? `, ${engine.threads} threads` : '';
  $('numbers').textContent = `${rate}${ms.toFixed(1)} ms the passes, ${whole.toFixed(1)} ms with the way to the screen, ${width} × ${height}${threads}`;
}

function touched() {
  page.dirty = true;
  page.moved = performance.now();
  drawVectors($('overlay'), [], canvas.width, canvas.height);
  mark.shown = false;
}

let before = performance.now();
function tick(now) {
  const seconds = Math.min(0.1, (now - before) / 1000);
  before = now;
  if (step(seconds)) touched();
  if ($('turn').ariaPressed === 'true') {
    hand.turn(TURN_SPEED * seconds, 0);
    touched();
  }
  if (page.dirty && !page.drawing && page.scene) {
    page.drawing = draw().catch((error) => say(error.message)).finally(() => { page.drawing = null; });
  }
  requestAnimationFrame(tick);
}

// ---- what is clicked and typed ---------------------------------------------------------------------------------------

async function explain(x, y) {
  if ($('view').value === 'light_depth') return say('this picture is what a light sees; choose another view to explain a pixel');
  page.moved = 0;
  page.dirty = true;
  while (page.dirty || page.drawing) await (page.drawing ?? new Promise(requestAnimationFrame));
  try {
    const told = await engine.call('explain', x, y);
    $('explained').textContent = told.text;
    $('told').hidden = false;
    drawVectors($('overlay'), told.vectors, canvas.width, canvas.height);
  } catch (error) { say(error.message); }
}

function clicked(event) {
  const box = canvas.getBoundingClientRect();
  const at = (along, size, pixels) => Math.min(pixels - 1, Math.max(0, Math.floor(along / size * pixels)));
  explain(at(event.clientX - box.left, box.width, canvas.width), at(event.clientY - box.top, box.height, canvas.height));
}

function moveMark(key) {
  if (!mark.shown) Object.assign(mark, { x: canvas.width >> 1, y: canvas.height >> 1, shown: true });
  const way = Math.max(1, canvas.height >> 6);
  mark.x += way * ((key === 'arrowright') - (key === 'arrowleft'));
  mark.y += way * ((key === 'arrowdown') - (key === 'arrowup'));
  mark.x = Math.min(canvas.width - 1, Math.max(0, mark.x));
  mark.y = Math.min(canvas.height - 1, Math.max(0, mark.y));
  drawCross($('overlay'), mark.x, mark.y, canvas.width, canvas.height);
}

function stepList(way) {
  const list = page.list?.isConnected ? page.list : $('view');
  let next = list.selectedIndex;
  do next = (next + way + list.length) % list.length; while (list.options[next].disabled || (!list.options[next].value && list.id !== 'view'));
  list.selectedIndex = next;
  list.dispatchEvent(new Event('change', { bubbles: true }));
  $('numbers').textContent = `${list.ariaLabel ?? 'view'}: ${list.options[next].text}`;
}

function fly(on) {
  hand.flies = on;
  $('fly').ariaPressed = on;
  if (on) canvas.requestPointerLock?.()?.catch?.(() => {});
  else document.exitPointerLock?.();
}

function press(id) {
  $(id).ariaPressed = $(id).ariaPressed !== 'true';
  page.moved = performance.now();
}

const SINGLE = {
  r: () => { hand.reset(); touched(); },
  p: () => fly(false),
  f: () => fly(!hand.flies),
  t: () => press('turn'),
  n: () => stepList(1),
  b: () => stepList(-1),
  enter: () => explain(mark.shown ? mark.x : canvas.width >> 1, mark.shown ? mark.y : canvas.height >> 1),
};

function key(name, isCross) {
  if (isCross) moveMark(name);
  else if (SINGLE[name]) SINGLE[name]();
  else return false;
  return true;
}

async function takeFiles(coming) {
  try {
    const files = await bytesOf(await coming);
    const meaning = meaningOf(Object.keys(files), page.scene.tables.material?.[0]);
    await engine.add(files);
    if (meaning.open) return openNew(meaning.open);
    await openNew(page.path, changed(page.changes, meaning.changes));
  } catch (error) { say(error.message); }
}

async function saveScene() {
  try {
    const { text } = await engine.call('text', [...page.changes.values(), ...hand.overrides()]);
    save(new Blob([text], { type: 'application/toml' }), `${(page.path || 'built_in').replace(/.*\/|\.\w+$/g, '')}.toml`);
  } catch (error) { say(error.message); }
}

function wire() {
  $('view').onchange = $('size').onchange = () => { page.dirty = true; frames.length = 0; };
  $('turn').onclick = SINGLE.t;
  $('fly').onclick = () => { fly(!hand.flies); canvas.focus(); };
  $('reset').onclick = SINGLE.r;
  $('undo').onclick = () => openNew(page.path);
  $('save-scene').onclick = saveScene;
  $('save-png').onclick = () => canvas.toBlob((png) => save(png, `${(page.path || 'built_in').replace(/.*\/|\.\w+$/g, '')}.png`));
  $('files').onchange = (event) => takeFiles(chosenFiles(event.target.files));
  $('close').onclick = () => { $('told').hidden = true; drawVectors($('overlay'), [], 1, 1); canvas.focus(); };
  document.addEventListener('change', ({ target }) => { if (target.tagName === 'SELECT' && target.id !== 'size') page.list = target; });
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => { event.preventDefault(); takeFiles(droppedFiles(event.dataTransfer)); });
  document.addEventListener('pointerlockchange', () => {
    if (!document.pointerLockElement) { hand.flies = false; $('fly').ariaPressed = false; }
  });
  document.addEventListener('visibilitychange', () => {  // a hidden page draws nothing: the browser calls no tick
    if (!document.hidden) page.dirty = true;
    frames.length = 0;
  });
  document.addEventListener('keydown', (event) => {  // where nothing has the focus, keys are the picture's
    if (event.target === document.body && !event.ctrlKey && !event.metaKey) { canvas.focus({ preventScroll: true }); canvas.dispatchEvent(new KeyboardEvent('keydown', event)); }
  });
}

/** The same scene again; where that crashes, too, without the changes, and then the built-in one. */
async function afterCrash(line) {
  const tries = [[page.path, page.changes], [page.path], ['']];
  const again = tries[page.crashes];
  page.crashes += 1;
  page.scene = null;
  if (again) await openNew(...again);
  say(again ? line : 'the module crashes again and again; load the page anew');
}

// ---- the beginning ---------------------------------------------------------------------------------------------------

/** The scene in the page, or in its address: view.html#scene=TOML. */
async function givenScene() {
  const address = new URLSearchParams(location.hash.slice(1)).get('scene');
  if (address) return { path: 'scene.toml', folder: '', overrides: [], files: { 'scene.toml': new TextEncoder().encode(address) } };
  const given = JSON.parse(source('scene').startsWith('{') ? source('scene') : '{"path": "", "folder": "", "overrides": [], "files": {}}');
  for (const [name, packed] of Object.entries(given.files)) given.files[name] = await unpack(packed);
  return given;
}

await new Promise((resolve) => setTimeout(resolve)); // what the page holds so far is seen before it is busy
const unpacked = (share) => { $('numbers').textContent = `Unpacking the module, once in this browser: ${Math.round(100 * share)} %`; };
const engine = new Engine(source('worker'), source('wasm'), afterCrash, unpacked);
globalThis.kreda = { engine, page, hand }; // for whoever looks with the browser's tools
const step = listen(canvas, hand, { changed: touched, clicked, key });
wire();
if (window !== top) document.body.classList.add('embedded'); // beside a text, whose scrolling is not taken away
const given = await givenScene();
Object.assign(engine, { files: given.files, folder: given.folder });
page.first = given.controls ?? [];
page.keys = await engine.start().then((keys) => keys, (error) => { say(error.message); return []; });
await openNew(given.path, changed([], given.overrides));
if (!page.scene) await openNew('');
requestAnimationFrame(tick);
