// node bundle.mjs MODULE.js MODULE.wasm PAGE.html: the page with everything in it but a scene. The modules of the page
// become one: lines that import are left out, and so is the word export; their names are unlike.
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

/** For the module: a fifth smaller than gzip. emcc needs Python, whose library has LZMA where it was built with it. */
const LZMA = `import lzma, struct, sys
bytes = open(sys.argv[1], 'rb').read()
best = {'id': lzma.FILTER_LZMA1, 'preset': 9 | lzma.PRESET_EXTREME, 'dict_size': 1 << 22, 'lc': 3, 'lp': 0, 'pb': 0}
packed = lzma.compress(bytes, format=lzma.FORMAT_ALONE, filters=[best])
sys.stdout.buffer.write(packed[:5] + struct.pack('<Q', len(bytes)) + packed[13:])`;

function packed(path) {
  const done = spawnSync('python3', ['-c', LZMA, path], { maxBuffer: 1 << 26 });
  if (done.status === 0) return `lzma ${done.stdout.toString('base64')}`;
  return gzipSync(readFileSync(path), { level: 9 }).toString('base64');
}

/** Without comments that fill their lines, and without what lines begin with. */
const slim = (text) => text.replace(/^ *\/\*\*.*?\*\/\n/gms, '').replace(/^ *\/\/.*\n/gm, '').replace(/^ +/gm, '');

const folder = join(dirname(fileURLToPath(import.meta.url)), 'page');
const read = (name) => readFileSync(join(folder, name), 'utf8');
const modules = ['camera.js', 'controls.js', 'lzma.js', 'engine.js', 'explain.js', 'dropped.js', 'files.js', 'input.js', 'main.js'];

/** Each module in a scope of its own, so that helpers may have the same names. */
function scoped(name) {
  const text = read(name).replace(/^import .*\n/gm, '');
  const shown = [...text.matchAll(/^export (?:async )?(?:function|class|const) (\w+)/gm)].map((match) => match[1]);
  const body = text.replace(/^export /gm, '');
  if (shown.length === 0) return body;
  return `const { ${shown.join(', ')} } = (() => {\n${body}\nreturn { ${shown.join(', ')} };\n})();`;
}

const [, , gluePath, wasmPath, pagePath] = process.argv;
const parts = {
  '/*STYLE*/': read('style.css'),
  '/*WASM*/': packed(wasmPath),
  '/*GLUE*/': readFileSync(gluePath, 'utf8'),
  '/*WORKER*/': slim(read('worker.js')),
  '/*MAIN*/': slim(modules.map(scoped).join('\n')),
};
let page = read('index.html');
for (const [mark, text] of Object.entries(parts)) {
  if (mark !== '/*STYLE*/' && /<\/script/i.test(text)) throw new Error(`${mark} holds an end of a script`);
  page = page.replace(mark, () => text);
}
writeFileSync(pagePath, page);
