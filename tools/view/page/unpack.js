// What was packed to be short in the page, unpacked.

const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

/** Bytes from base 64, unpacked where they were packed with gzip. */
export async function unpack(base64) {
  const bytes = bytesOf(base64);
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A worker's whole source: `unpacker` is the module that tools/view/pack/web_packer.cpp becomes. */
function unpackHere() {
  self.onmessage = async ({ data: { unpacker, packed, count } }) => {
    try {
      const { memory, _initialize, plain_bytes, packed_bytes, unpack } = (await WebAssembly.instantiate(unpacker)).instance.exports;
      _initialize();
      new Uint8Array(memory.buffer).set(packed, packed_bytes());
      unpack(count);
      const plain = new Uint8Array(memory.buffer, plain_bytes(), count).slice();
      self.postMessage({ plain }, [plain.buffer]);
    } catch (error) {
      self.postMessage({ failed: error.message });
    }
  };
}

/** The renderer's {wasm, glue}, module and script, from what tools/view/bundle.mjs wrote. It takes seconds: a worker's work. */
export async function unpackModule(text) {
  const [count, script, unpacker, packed] = text.split(' ');
  if (!packed) throw new Error('the module of this page is missing');
  const address = URL.createObjectURL(new Blob([`(${unpackHere})()`], { type: 'text/javascript' }));
  const worker = new Worker(address);
  try {
    worker.postMessage({ unpacker: await unpack(unpacker), packed: bytesOf(packed), count: Number(count) });
    const plain = await new Promise((resolve, reject) => {
      const fail = (reason) => reject(new Error(`the module cannot be unpacked: ${reason}`));
      worker.onmessage = ({ data: { plain, failed } }) => (plain ? resolve(plain) : fail(failed));
      worker.onerror = (event) => fail(event.message);
    });
    return { wasm: plain, glue: new TextDecoder().decode(plain.subarray(plain.length - script)) }; // the module's last section
  } finally {
    worker.terminate();
    URL.revokeObjectURL(address);
  }
}
