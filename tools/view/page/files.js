// Files in and out: dropped ones become part of the scene, the scene file and the picture can be saved.

const UNREAD = [[/\.exr$/i, 'EXR', 'write it as .hdr: oiiotool in.exr -o out.hdr']];
const IMAGES = /\.(png|jpe?g|tga|bmp)$/i;

/** WebP is read by the browser and handed on as PNG, values as they stand in the file. */
async function pngOf(path, file) {
  try {
    const picture = await createImageBitmap(file, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    canvas.getContext('2d').drawImage(picture, 0, 0);
    return await canvas.convertToBlob({ type: 'image/png' });
  } catch {
    throw new Error(`${path}: cannot be read; the file is damaged or no WebP`);
  }
}

/** {path: bytes} of [path, file]s; x.webp becomes x.png. A path stays below the scene's folder. */
export async function bytesOf(list) {
  const files = {};
  for (const [path, file] of list) {
    const isWebp = /\.webp$/i.test(path);
    const parts = path.replace(/\.webp$/i, '.png').split(/[\\/]/).filter((part) => !/^\.{0,2}$/.test(part));
    files[parts.join('/')] = new Uint8Array(await (isWebp ? await pngOf(path, file) : file).arrayBuffer());
  }
  return files;
}

/**
 * What these files mean for the scene: {open: path} for a scene or a mesh, {changes: [...]} for an environment or a map.
 * `material`: the first one of the scene file, or undefined.
 */
export function meaningOf(names, material) {
  const named = (ending) => names.filter((name) => ending.test(name)).sort((a, b) => a.split('/').length - b.split('/').length)[0];
  if (names.length === 0) throw new Error('no files are in it');
  for (const [ending, kind, remedy] of UNREAD) {
    const name = named(ending);
    if (name) throw new Error(`${name}: ${kind} is not read in the browser; ${remedy}`);
  }
  const scene = named(/\.toml$/i) ?? named(/\.(obj|stl|ply|glb|gltf|fbx)$/i);
  if (scene) return { open: scene };
  const light = named(/\.(hdr|exr)$/i);
  if (light) return { changes: [`environment.file=${JSON.stringify(light)}`, 'image.background="environment"'] };
  const map = named(IMAGES);
  if (map && material) {
    const key = material.model === 'cook_torrance' ? 'albedo_map' : 'diffuse_map';
    return { changes: [`material.0.${key}=${JSON.stringify(map)}`] };
  }
  if (map) throw new Error(`${map}: there is no [[material]] in the scene file that could wear it`);
  const mtl = named(/\.mtl$/i);
  if (mtl) return { changes: [] };
  throw new Error(`${names[0]}: not a file for a scene (expected .toml, .obj, .mtl, .glb, .gltf, .png, .jpg, .webp, .hdr, or a folder or .zip with some)`);
}

export function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
