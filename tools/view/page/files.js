// Files in and out: dropped ones become part of the scene, the scene file and the picture can be saved.

const UNREAD = [[/\.exr$/i, 'EXR', 'write it as .hdr: oiiotool in.exr -o out.hdr']];
const IMAGES = /\.(png|jpe?g|tga|bmp)$/i;

/** WebP is read by the browser and handed on as PNG, values as they stand in the file. */
async function pngOf(file) {
  try {
    const picture = await createImageBitmap(file, { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    canvas.getContext('2d').drawImage(picture, 0, 0);
    return await canvas.convertToBlob({ type: 'image/png' });
  } catch {
    throw new Error(`${file.name}: cannot be read; the file is damaged or no WebP`);
  }
}

/** {name: bytes} of files that were dropped or chosen; x.webp becomes x.png. */
export async function bytesOf(list) {
  const files = {};
  for (const file of list) {
    const isWebp = /\.webp$/i.test(file.name);
    const name = file.name.replace(/[\\/]/g, '_').replace(/\.webp$/i, '.png');
    files[name] = new Uint8Array(await (isWebp ? await pngOf(file) : file).arrayBuffer());
  }
  return files;
}

/**
 * What these files mean for the scene: {open: path} for a scene or a mesh, {changes: [...]} for an environment or a map.
 * `material`: the first one of the scene file, or undefined.
 */
export function meaningOf(names, material) {
  const named = (ending) => names.find((name) => ending.test(name));
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
  throw new Error(`${names[0]}: not a file for a scene (expected .toml, .obj, .mtl, .glb, .gltf, .png, .jpg, .webp or .hdr)`);
}

export function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
