// node hash_scene_files.mjs KREDA_WEB.js SCENE.toml...: the lines of hash_scene_files.cpp, by the very module that pages hold.
import { readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';

const [, , module, ...scenes] = process.argv;
const kreda = await createRequire(import.meta.url)(resolve(module))({ wasmBinary: readFileSync(module.replace(/js$/, 'wasm')), print: () => {}, printErr: () => {} });
const NEEDED = /\.(toml|obj|mtl|png|jpg|hdr)$/;

function copy(folder) {
  kreda.FS.mkdirTree(`/${folder}`);
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) copy(path);
    else if (NEEDED.test(path)) kreda.FS.writeFile(`/${path}`, readFileSync(path));
  }
}

function ask(name, ...values) {
  const answer = JSON.parse(kreda.ccall(`kreda_${name}`, 'string', values.map((value) => typeof value), values));
  if (answer.error) throw new Error(answer.error);
  return answer;
}

for (const folder of new Set(scenes.map((scene) => scene.split('/')[0] === 'docs' ? 'docs/images' : dirname(scene)))) copy(folder);
for (const scene of scenes) {
  try {
    const { size, samples } = ask('open', scene, '[]');
    ask('draw', ...size, samples, '');
    console.log(`${ask('hash').hash} ${scene}`);
  } catch (error) { console.log(error.message); }
}
