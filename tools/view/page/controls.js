// Controls made of the table of keys: what `kreda keys` lists, a field a key, for every table of the scene file.

const FIRST = ['material', 'light', 'ambient', 'shading', 'shadow', 'fog', 'environment', 'image', 'object', 'camera'];
const OPEN = new Set(['material', 'light']);
const WIDEST = 1000; // a range of numbers that is wider than this is no good for a slider as it stands

let named = 0;

function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Ends of a slider: those of the key where they are near, else some times what stands there. */
export function sliderRange(key, value) {
  const size = 4 * (Math.max(Math.abs(value), Math.abs(typeof key.default === 'number' ? key.default : 0)) || 0.5);
  const least = key.least > -WIDEST ? key.least : -size;
  const greatest = key.greatest < WIDEST ? key.greatest : size;
  return { least, greatest: Math.max(greatest, value), step: key.type.startsWith('whole') ? 1 : (greatest - least) / 1000 };
}

const short = (x) => (Number.isInteger(x) ? x : Number(x.toPrecision(6)));

function numberField(key, value, label, tell) {
  const number = element('input', { type: 'number', value: short(value), step: 'any', ariaLabel: label });
  number.onchange = () => number.value !== '' && tell(Number(number.value));
  return number;
}

function slider(key, value, label, tell) {
  const { least, greatest, step } = sliderRange(key, value);
  const range = element('input', { type: 'range', min: least, max: greatest, step, value, ariaLabel: `${label}, slider` });
  const number = numberField(key, value, label, (x) => { range.value = x; tell(x); });
  range.oninput = () => { number.value = short(Number(range.value)); tell(Number(range.value)); };
  return element('span', { className: 'slide' }, range, number);
}

function vector(key, value, label, tell) {
  const now = [...value];
  return element('span', { className: 'row' }, ...now.map((x, i) =>
    numberField(key, x, `${label}, number ${i + 1}`, (y) => { now[i] = y; tell([...now]); })));
}

function choice(key, value, label, tell) {
  const select = element('select', { ariaLabel: label });
  const words = key.words.includes(value) ? key.words : ['', ...key.words];
  select.append(...words.map((word) => element('option', { value: word, textContent: word || 'not set' })));
  select.value = key.words.includes(value) ? value : '';
  select.onchange = () => select.value && tell(select.value);
  return select;
}

function checkbox(key, value, label, tell) {
  const box = element('input', { type: 'checkbox', checked: value, ariaLabel: label });
  box.onchange = () => tell(box.checked);
  return box;
}

function text(key, value, label, tell) {
  const field = element('input', { type: 'text', value: value ?? '', ariaLabel: label, spellcheck: false });
  field.onchange = () => field.value && tell(field.value);
  return field;
}

/** What is shown where neither the file nor the table of keys has a value. */
function something(key) {
  if (key.example !== null) return key.example;
  return { boolean: false, number: 0, whole: 0, number_pair: [0, 0], vector: [0, 0, 0], number_or_vector: 1 }[key.type] ?? '';
}

function fieldFor(key, value, label, tell) {
  switch (key.type) {
    case 'boolean': return checkbox(key, value, label, tell);
    case 'word': return choice(key, value, label, tell);
    case 'number': case 'whole': return slider(key, value, label, tell);
    case 'texts': return null;
    case 'text': return text(key, value, label, tell);
    default:
      if (Array.isArray(value)) return vector(key, value, label, tell);
      return typeof value === 'number' ? slider(key, value, label, tell) : choice(key, value, label, tell);
  }
}

/** A value as a change of the scene file wants it. */
export function written(value) {
  return JSON.stringify(value);
}

function row(key, given, path, tell) {
  if (key.key === 'name') return null; // other tables say it
  const value = given ?? key.default ?? something(key);
  const field = fieldFor(key, value, path, (next) => { line.classList.add('set'); tell(`${path}=${written(next)}`, path); });
  if (!field) return null;
  named += 1;
  const hint = element('small', { id: `hint${named}`, textContent: `${key.meaning} (${key.expects})` });
  const line = element('div', { className: given === undefined ? 'key' : 'key set' },
    element('span', { className: 'name', textContent: key.key }), field, hint);
  line.dataset.path = path;
  for (const input of line.querySelectorAll('input, select')) input.setAttribute('aria-describedby', hint.id);
  return line;
}

/** The row of "fog.density" or "material.0.roughness", named by its whole path. */
function firstRow(keys, tables, path, tell) {
  const [table, ...rest] = path.split('.');
  const key = keys.find((k) => k.table === table && k.key === rest[rest.length - 1]);
  const given = rest.length > 1 ? tables[table]?.[Number(rest[0])] : tables[table];
  const made = key && row(key, given?.[key.key], path, tell);
  if (made) made.querySelector('.name').textContent = path;
  return made;
}

function group(title, keys, given, path, tell) {
  const rows = keys.map((key) => row(key, given[key.key], `${path}.${key.key}`, tell)).filter(Boolean);
  const summary = element('summary', { textContent: title });
  return element('details', {}, summary, ...rows);
}

function titleOf(table, item, i) {
  const called = item.name ?? item.mesh ?? item.type ?? '';
  return `${table} ${i}${called ? `: ${String(called).split('/').pop()}` : ''}`;
}

/**
 * Fill `parent` anew. `keys`: the table; `tables`: the scene file as it was read; `tell(change, path)` hears every change.
 * What was open stays open. `first`: paths of keys that get a group of their own on top.
 */
export function makeControls(parent, keys, tables, tell, first = []) {
  const before = new Map([...parent.querySelectorAll('details')].map((d) => [d.dataset.path, d.open]));
  const names = [...new Set(keys.map((key) => key.table))];
  names.sort((a, b) => (FIRST.indexOf(a) + 1 || 99) - (FIRST.indexOf(b) + 1 || 99));
  const groups = [];
  for (const table of names) {
    const own = keys.filter((key) => key.table === table);
    const items = own[0].repeated ? tables[table] ?? [] : [tables[table] ?? {}];
    items.forEach((item, i) => {
      const path = own[0].repeated ? `${table}.${i}` : table;
      const made = group(own[0].repeated ? titleOf(table, item, i) : table, own, item, path, tell);
      made.dataset.path = path;
      made.open = before.get(path) ?? (first.length === 0 && OPEN.has(table) && i === 0);
      groups.push(made);
    });
  }
  const chosen = first.map((path) => firstRow(keys, tables, path, tell)).filter(Boolean);
  if (chosen.length) groups.unshift(element('div', { className: 'first' }, ...chosen));
  parent.replaceChildren(...groups);
}
