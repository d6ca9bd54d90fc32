// Runs in a worker: the module behind one function, call(name, ...). What the module answers is JSON; pixels come as
// bytes. A trap (a bug of ours) is told to the page, which starts a new worker.
let kreda = null;

/** Files of the scene in the module's own memory: {"meshes/teapot.obj": bytes}; `folder` is where paths start. */
function writeFiles(files, folder) {
  const inScene = (path) => (path.startsWith('/') ? path : `/scene/${path}`);
  for (const [path, bytes] of Object.entries(files)) {
    const whole = inScene(path);
    kreda.FS.mkdirTree(whole.slice(0, whole.lastIndexOf('/')));
    if (kreda.FS.analyzePath(whole).exists) kreda.FS.unlink(whole); // another file, whatever its time: none of it is kept
    kreda.FS.writeFile(whole, bytes);
  }
  kreda.FS.mkdirTree(inScene(folder));
  kreda.FS.chdir(inScene(folder));
}

function ask(name, ...values) {
  const types = values.map((value) => (typeof value === 'string' ? 'string' : 'number'));
  return JSON.parse(kreda.ccall(`kreda_${name}`, 'string', types, values));
}

const work = {
  /** `threads`: the address of the folder with the module that uses all cores; empty: the one that the page holds. */
  async start(module, threads) {
    const quiet = { print: () => {}, printErr: () => {} };
    if (threads) {
      const mainScriptUrlOrBlob = `${threads}kreda_web.js`;
      importScripts(mainScriptUrlOrBlob);
      const several = { threads: navigator.hardwareConcurrency, mainScriptUrlOrBlob, locateFile: (name) => threads + name };
      kreda = await self.makeKreda({ ...quiet, ...several });
    } else {
      (0, eval)(`${module.glue};self.makeKreda = makeKreda;`);
      kreda = await self.makeKreda({ ...quiet, wasmBinary: module.wasm });
    }
    return { keys: ask('keys'), threads: threads ? navigator.hardwareConcurrency : 1 };
  },
  write(files, folder) {
    writeFiles(files, folder);
    return {};
  },
  open: (path, overrides) => ask('open', path, JSON.stringify(overrides)),
  reads: () => ask('reads'),
  threads: () => ask('threads'),
  text: (overrides) => ask('text', JSON.stringify(overrides)),
  explain: (x, y) => ask('explain', x, y),
  hash: () => ask('hash'),
  /** `pose`: nine numbers, position, target and up. */
  draw(pose, width, height, samples, view) {
    const begin = performance.now();
    kreda.ccall('kreda_camera', null, pose.map(() => 'number'), pose);
    const answer = ask('draw', width, height, samples, view);
    if (answer.error) return answer;
    const bytes = kreda.HEAPU8.slice(answer.pixels, answer.pixels + 4 * answer.width * answer.height);
    return { ...answer, rgba: bytes.buffer, whole_ms: performance.now() - begin };
  },
};

self.onmessage = async ({ data: { id, name, values } }) => {
  try {
    const answer = await work[name](...values);
    self.postMessage({ id, answer }, answer.rgba ? [answer.rgba] : []);
  } catch (trap) {
    self.postMessage({ id, crash: String(trap && trap.message ? trap.message : trap) });
  }
};
