// The assignment in its worker: scenes in, rows of numbers out, points back.
let kreda = null;

function ask(name, ...values) {
  const types = values.map((value) => (typeof value === 'string' ? 'string' : 'number'));
  return JSON.parse(kreda.ccall(`kreda_${name}`, 'string', types, values));
}

const work = {
  async start(glue, wasmBinary, assignment) {
    (0, eval)(`${glue};self.makeKreda = makeKreda;`);
    kreda = await self.makeKreda({ wasmBinary, print: () => {}, printErr: () => {} });
    for (const [path, bytes] of filesOf(assignment)) {
      kreda.FS.mkdirTree(`/${path.slice(0, path.lastIndexOf('/'))}`);
      kreda.FS.writeFile(`/${path}`, bytes);
    }
    return ask('assignment', '/assignment/rubric.toml');
  },
  inputs() {
    const { at, size, error } = ask('submission');
    return error ? { error } : { inputs: kreda.HEAPU8.slice(at, at + size) };
  },
  answers(outputs, stage, why) {
    kreda.FS.writeFile('/outputs.bin', outputs);
    return ask('answers', '/outputs.bin', stage, why);
  },
  result: (name, error, seconds) => ask('result', name, error, seconds),
};

self.onmessage = async ({ data: { id, name, values } }) => {
  try {
    self.postMessage({ id, answer: await work[name](...values) });
  } catch (trap) {
    self.postMessage({ id, answer: { error: `the module failed: ${trap.message}` } });
  }
};
