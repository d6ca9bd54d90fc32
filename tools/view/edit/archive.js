// Parts and their archives, read: see parts.mjs.

/** Bytes of text in base 64. */
function fromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** The part's bytes. */
export async function unpackPart(text) {
  const stream = new Blob([fromBase64(text)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A Map of path to bytes. */
export function filesOf(archive) {
  const decoder = new TextDecoder();
  let at = 0;
  const line = () => {
    const end = archive.indexOf(10, at), text = decoder.decode(archive.subarray(at, end));
    at = end + 1;
    return text;
  };
  const heads = Array.from({ length: Number(line()) }, () => line().match(/^(\d+) (.*)$/));
  return new Map(heads.map(([, size, name]) => {
    const bytes = archive.subarray(at, at + Number(size));
    at += Number(size);
    return [name, bytes];
  }));
}
