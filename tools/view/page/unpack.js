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
      for (let done = 0; done < count;) {
        done = Math.min(done + (count >> 5) + 1, count);
        unpack(done);
        self.postMessage({ share: done / count });
      }
      const plain = new Uint8Array(memory.buffer, plain_bytes(), count).slice();
      self.postMessage({ plain }, [plain.buffer]);
    } catch (error) {
      self.postMessage({ failed: error.message });
    }
  };
}

/** The same, of a packed module of so many bytes. It takes seconds: a worker's work. hear(share): of it that is done. */
async function unpackInWorker(unpacker, packed, count, hear) {
  const address = URL.createObjectURL(new Blob([`(${unpackHere})()`], { type: 'text/javascript' }));
  const worker = new Worker(address);
  try {
    worker.postMessage({ unpacker: await unpack(unpacker), packed: bytesOf(packed), count });
    return await new Promise((resolve, reject) => {
      const fail = (reason) => reject(new Error(`the module cannot be unpacked: ${reason}`));
      worker.onmessage = ({ data: { share, plain, failed } }) => (share ? hear(share) : plain ? resolve(plain) : fail(failed));
      worker.onerror = (event) => fail(event.message);
    });
  } finally {
    worker.terminate();
    URL.revokeObjectURL(address);
  }
}

/** What a browser answers to a request to its store. */
const answerTo = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

const aSecond = () => new Promise((resolve) => setTimeout(resolve, 1000));

/** use(store), where the browser keeps modules from one page to the next; undefined where it keeps nothing, or is slow to say so. */
const inStore = (mode, use) => Promise.race([inOpenStore(mode, use), aSecond()]);

async function inOpenStore(mode, use) {
  try {
    const request = indexedDB.open('kreda', 1);
    request.onupgradeneeded = () => request.result.createObjectStore('modules');
    const base = await answerTo(request);
    try {
      return await answerTo(use(base.transaction('modules', mode).objectStore('modules')));
    } finally {
      base.close();
    }
  } catch {
    return undefined;
  }
}

/** The same again: unpacked once by each browser. The end of what is packed depends on all of it. */
async function unpackOnce(unpacker, packed, count, hear) {
  const name = `${count} ${packed.length} ${packed.slice(-64)}`;
  const kept = await inStore('readonly', (store) => store.get(name));
  if (kept?.length === count) return kept;
  const plain = await unpackInWorker(unpacker, packed, count, hear);
  await inStore('readwrite', (store) => (store.clear(), store.put(plain, name)));
  return plain;
}

/** The renderer's {wasm, glue}, module and script, from what tools/view/bundle.mjs wrote. hear(share): of the work that is done. */
export async function unpackModule(text, hear) {
  const [count, script, unpacker, packed] = text.split(' ');
  if (!packed) throw new Error('the module of this page is missing');
  const plain = unpacker === 'gzip' ? await unpack(packed) : await unpackOnce(unpacker, packed, Number(count), hear);
  return { wasm: plain, glue: new TextDecoder().decode(plain.subarray(plain.length - script)) }; // the module's last section
}
