// node check_pack.mjs PACKER.wasm UNPACKER.wasm MODULE.wasm: what the one packs, the other unpacks to the same bytes, whatever they are.
import { readFileSync } from 'node:fs';

const [packer, unpacker, module] = process.argv.slice(2).map((path) => readFileSync(path));

/** A new instance each time: it holds what was learnt. */
async function started(bytes) {
  const { exports } = (await WebAssembly.instantiate(bytes)).instance;
  exports._initialize();
  return { ...exports, bytes: new Uint8Array(exports.memory.buffer) };
}

async function check(name, plain, most) {
  const one = await started(packer);
  one.bytes.set(plain, one.plain_bytes());
  const packed = one.bytes.slice(one.packed_bytes(), one.packed_bytes() + one.pack(plain.length));
  const other = await started(unpacker);
  other.bytes.set(packed, other.packed_bytes());
  for (let part = 1; part <= 3; ++part) other.unpack(Math.floor((plain.length * part) / 3));
  const same = Buffer.compare(Buffer.from(plain), Buffer.from(other.bytes.buffer, other.plain_bytes(), plain.length)) === 0;
  console.log(`${name}: ${plain.length} bytes, packed ${packed.length}, ${same ? 'the same' : 'NOT the same'} afterwards`);
  if (!same || packed.length > most) process.exitCode = 1;
}

let seed = 1;
const chance = () => (seed = Math.imul(seed, 1664525) + 1013904223) >>> 24;
await check('nothing', new Uint8Array(0), 4);
await check('one byte', new Uint8Array([255]), 8);
await check('chance, which cannot be packed', Uint8Array.from({ length: 20000 }, chance), 21000);
await check('a module with wrong bytes', module.subarray(0, 60000).map((byte, i) => (i % 997 === 500 ? chance() : byte)), 60000);
await check('the head of a module, then nothing of one', Uint8Array.from({ length: 5000 }, (_, i) => (i < 9 ? module[i] : 10)), 200);
await check('a stretch of the module', module.subarray(200000, 260000), 60000 * 0.35);
