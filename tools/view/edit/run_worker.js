// Runs in a worker of its own, which the page ends when it takes too long: one program, once.
self.onmessage = ({ data: { module, args, inputs } }) => {
  const system = new System(args, new Map([['inputs.bin', inputs]]));
  let why = '';
  self.postMessage({ begun: true });
  try {
    const code = system.run(module);
    if (code !== 0) why = `ended with exit code ${code}`;
  } catch (error) {
    why = `crashed (${error.message})`;
  }
  const outputs = system.written.get('outputs.bin')?.read().slice() ?? new Uint8Array(0);
  self.postMessage({ why, outputs, printed: system.printed }, [outputs.buffer]);
};
