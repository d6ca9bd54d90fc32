// node bundle.mjs MODULE.js MODULE.wasm PAGE.html: the page with everything in it but a scene. The modules of the page
// become one: lines that import are left out, and so is the word export; their names are unlike.
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const folder = join(dirname(fileURLToPath(import.meta.url)), 'page');
const read = (name) => readFileSync(join(folder, name), 'utf8');
const modules = ['camera.js', 'controls.js', 'engine.js', 'explain.js', 'files.js', 'input.js', 'main.js'];

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
  '/*WASM*/': gzipSync(readFileSync(wasmPath), { level: 9 }).toString('base64'),
  '/*GLUE*/': readFileSync(gluePath, 'utf8'),
  '/*WORKER*/': read('worker.js'),
  '/*MAIN*/': modules.map(scoped).join('\n'),
};
let page = read('index.html');
for (const [mark, text] of Object.entries(parts)) {
  if (mark !== '/*STYLE*/' && /<\/script/i.test(text)) throw new Error(`${mark} holds an end of a script`);
  page = page.replace(mark, () => text);
}
writeFileSync(pagePath, page);
