// Files of the page that compiles: a part is a script that hands over one name and its bytes, packed and in base 64, for
// a page from a disk may load scripts and nothing else.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

export function writePart(folder, name, bytes) {
  mkdirSync(folder, { recursive: true });
  const text = gzipSync(bytes, { level: 9 }).toString('base64');
  writeFileSync(join(folder, `${name}.js`), `(self.kredaParts ??= {})[${JSON.stringify(name)}] = "${text}";\n`);
}

/** Files in one block: their number, then name and size of each, a line each, then their bytes. */
export function archive(files) {
  const head = [...files].map(([name, bytes]) => `${bytes.length} ${name}\n`).join('');
  return Buffer.concat([Buffer.from(`${files.size}\n${head}`), ...files.values()]);
}
