// node bundle.mjs MODULE.js MODULE.wasm PACKER.wasm UNPACKER.wasm PAGE.html: the page with everything in it but a scene. The modules of the page
// become one: lines that import are left out, and so is the word export; their names are unlike. Beside it, for pages that share a module:
// view_module.txt, the module in the form that starts at once.
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

/** A number in LEB128. */
const numberBytes = (n) => (n < 128 ? [n] : [n & 127 | 128, ...numberBytes(n >>> 7)]);

const gzipped = (bytes) => gzipSync(bytes, { level: 9 }).toString('base64');

/** The module with the script as its last section, and how long the script is. */
function moduleAndScript(wasmPath, gluePath) {
  const script = readFileSync(gluePath);
  const section = Buffer.from([0, ...numberBytes(script.length + 1), 0]); // of the module, for others' use, without a name
  return { plain: Buffer.concat([readFileSync(wasmPath), section, script]), script: script.length };
}

/** "COUNT SCRIPT UNPACKER PACKED": the bytes of module and script, those of the script, what unpacks both (gzip, base 64), and both (base 64). */
async function packed({ plain, script }, packerPath, unpackerPath) {
  const { memory, _initialize, plain_bytes, most_bytes, packed_bytes, pack } = (await WebAssembly.instantiate(readFileSync(packerPath))).instance.exports;
  if (plain.length > most_bytes()) throw new Error(`the module has more bytes than tools/view/pack/prediction.hpp takes`);
  _initialize();
  new Uint8Array(memory.buffer).set(plain, plain_bytes());
  const bytes = Buffer.from(memory.buffer, packed_bytes(), pack(plain.length));
  return [plain.length, script, gzipped(readFileSync(unpackerPath)), bytes.toString('base64')].join(' ');
}

/** Without comments that fill their lines, and without what lines begin with. */
const slim = (text) => text.replace(/^ *\/\*\*.*?\*\/\n/gms, '').replace(/^ *\/\/.*\n/gm, '').replace(/^ +/gm, '');

const folder = join(dirname(fileURLToPath(import.meta.url)), 'page');
const read = (name) => readFileSync(join(folder, name), 'utf8');
const modules = ['camera.js', 'controls.js', 'unpack.js', 'engine.js', 'explain.js', 'dropped.js', 'files.js', 'input.js', 'main.js'];

/** Each module in a scope of its own, so that helpers may have the same names. */
function scoped(name) {
  const text = read(name).replace(/^import .*\n/gm, '');
  const shown = [...text.matchAll(/^export (?:async )?(?:function|class|const) (\w+)/gm)].map((match) => match[1]);
  const body = text.replace(/^export /gm, '');
  if (shown.length === 0) return body;
  return `const { ${shown.join(', ')} } = (() => {\n${body}\nreturn { ${shown.join(', ')} };\n})();`;
}

const [, , gluePath, wasmPath, packerPath, unpackerPath, pagePath] = process.argv;
const module = moduleAndScript(wasmPath, gluePath);
writeFileSync(join(dirname(pagePath), 'view_module.txt'), [module.plain.length, module.script, 'gzip', gzipped(module.plain)].join(' '));
const parts = {
  '/*STYLE*/': read('style.css'),
  '/*WASM*/': await packed(module, packerPath, unpackerPath),
  '/*WORKER*/': slim(read('worker.js')),
  '/*MAIN*/': slim(modules.map(scoped).join('\n')),
};
let page = read('index.html');
for (const [mark, text] of Object.entries(parts)) {
  if (mark !== '/*STYLE*/' && /<\/script/i.test(text)) throw new Error(`${mark} holds an end of a script`);
  page = page.replace(mark, () => text);
}
writeFileSync(pagePath, page);
