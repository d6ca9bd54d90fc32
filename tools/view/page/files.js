// Files in and out: dropped ones become part of the scene, the scene file and the picture can be saved.

const IMAGES = /\.(png|jpe?g|tga|bmp)$/i;

/** {name: bytes} of files that were dropped or chosen. */
export async function bytesOf(list) {
  const files = {};
  for (const file of list) files[file.name.replace(/[\\/]/g, '_')] = new Uint8Array(await file.arrayBuffer());
  return files;
}

/**
 * What these files mean for the scene: {open: path} for a scene or a mesh, {changes: [...]} for an environment or a map.
 * `material`: the first one of the scene file, or undefined.
 */
export function meaningOf(names, material) {
  const named = (ending) => names.find((name) => ending.test(name));
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
  throw new Error(`${names[0]}: not a file for a scene (expected .toml, .obj, .mtl, .png, .jpg or .hdr)`);
}

export function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
