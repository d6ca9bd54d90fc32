// What was dropped or chosen, as [path, file] each: files, those of whole folders, and those of .zip archives.

const MOST = 2 ** 29; // bytes of an archive's files, unpacked

/** All files of a folder, or the one file, from what Chromium has of it (the other way fails there on a page from a disk). */
async function filesOfHandle(handle, folder = '') {
  const path = folder + handle.name, files = [];
  if (handle.kind === 'file') return [[path, await handle.getFile()]];
  for await (const inner of handle.values()) files.push(...await filesOfHandle(inner, `${path}/`));
  return files;
}

/** The same from what the other browsers have. */
async function filesOfEntry(entry, folder = '') {
  const path = folder + entry.name, files = [];
  if (entry.isFile) return [[path, await new Promise((found, failed) => entry.file(found, failed))]];
  const reader = entry.createReader();
  for (;;) {
    const some = await new Promise((found, failed) => reader.readEntries(found, failed)); // a hundred at a time
    if (some.length === 0) return files;
    for (const inner of some) files.push(...await filesOfEntry(inner, `${path}/`));
  }
}

/** The stream as bytes; one that has more than `most` is not read to its end. */
async function bytesUpTo(stream, most) {
  const parts = [], reader = stream.getReader();
  for (let size = 0; ;) {
    const { done, value } = await reader.read();
    if (done) return new Blob(parts);
    if ((size += value.length) > most) throw new Error('unpacked it has more than 512 MB');
    parts.push(value);
  }
}

/** Where the list of an archive's files begins, and how many there are.   PKWARE, .ZIP File Format Specification (2022), 4.3 */
function listOf(view) {
  const END = 0x06054b50, LENGTH = 22, LONGEST_COMMENT = 65535;
  const from = view.byteLength - LENGTH;
  for (let at = from; at >= 0 && at >= from - LONGEST_COMMENT; --at) {
    if (view.getUint32(at, true) === END) return { at: view.getUint32(at + 16, true), count: view.getUint16(at + 10, true) };
  }
  throw new Error('no list of files at its end');
}

async function unzip(archive) {
  const buffer = await archive.arrayBuffer(), view = new DataView(buffer), files = [];
  let { at, count } = listOf(view), left = MOST;
  for (; count > 0; --count) {
    const method = view.getUint16(at + 10, true), packed = view.getUint32(at + 20, true), begin = view.getUint32(at + 42, true);
    const [name, extra, comment] = [28, 30, 32].map((k) => view.getUint16(at + k, true));
    const path = new TextDecoder().decode(new Uint8Array(buffer, at + 46, name));
    at += 46 + name + extra + comment;
    if (path.endsWith('/') || path.startsWith('__MACOSX/')) continue;
    if (method !== 0 && method !== 8) throw new Error(`${path} is packed in a way that is not known here`);
    const data = new Blob([new Uint8Array(buffer, begin + 30 + view.getUint16(begin + 26, true) + view.getUint16(begin + 28, true), packed)]);
    const stream = method === 0 ? data.stream() : data.stream().pipeThrough(new DecompressionStream('deflate-raw'));
    const bytes = await bytesUpTo(stream, left);
    left -= bytes.size;
    files.push([path, bytes]);
  }
  return files;
}

/** The files of a list, an archive's in place of it. */
async function unpacked(list) {
  const files = [];
  for (const [path, file] of list) {
    if (!/\.zip$/i.test(path)) {
      files.push([path, file]);
      continue;
    }
    try {
      files.push(...await unzip(file));
    } catch (error) {
      throw new Error(`${path}: cannot be unpacked: ${error instanceof RangeError ? 'the file is damaged' : error.message}`);
    }
  }
  return files;
}

/** Of an <input>. */
export const chosenFiles = (list) => unpacked([...list].map((file) => [file.name, file]));

/** Of a drop. All that it holds is asked for before any wait: afterwards it is empty. */
export async function droppedFiles(transfer) {
  const items = [...transfer.items], entries = items.map((item) => item.webkitGetAsEntry?.());
  if (!entries.some((entry) => entry?.isDirectory)) return chosenFiles(transfer.files);
  const found = items[0].getAsFileSystemHandle ? items.map(async (item) => filesOfHandle(await item.getAsFileSystemHandle())) : entries.map((entry) => filesOfEntry(entry));
  return unpacked((await Promise.all(found)).flat());
}
