// The compiler in its worker: start it once, then a text becomes a program or a list of complaints.
let clang = null, parts = [];

function run(args, files) {
  const system = new System(args, ...files);
  const code = system.run(clang);
  return { code, printed: system.printed, written: system.written };
}

const work = {
  start(module, headers, assignment) {
    clang = module;
    parts = [filesOf(headers), filesOf(assignment)];
    return {};
  },
  /** `isWhole`: the text has all functions; otherwise those that it has not are given. */
  compile(text, isWhole) {
    const source = new Map([['given/reader.cpp', new TextEncoder().encode(text)]]);
    const compiled = run(compile('/given/reader.cpp', '/given/reader.o'), [source, ...parts]);
    if (compiled.code !== 0) return { printed: compiled.printed };
    source.set('given/reader.o', compiled.written.get('given/reader.o').read());
    const objects = ['reader', 'stages', 'main', ...(isWhole ? [] : ['others'])].map((name) => `/given/${name}.o`);
    const linked = run(link(objects, '/given/program'), [source, ...parts]);
    if (linked.code !== 0) return { printed: compiled.printed + linked.printed };
    return { printed: compiled.printed, program: linked.written.get('given/program').read().slice() };
  },
};

self.onmessage = ({ data: { id, name, values } }) => {
  try {
    self.postMessage({ id, answer: work[name](...values) });
  } catch (trap) {
    self.postMessage({ id, answer: { error: `the compiler failed: ${trap.message}` } });
  }
};
