// Workers that answer by number, and the parts that are loaded when they are asked for.
import { unpackPart } from './archive.js';

export class Helper {
  constructor(source) {
    this.worker = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));
    this.waiting = new Map();
    this.last = 0;
    this.worker.onmessage = ({ data: { id, answer } }) => {
      const { resolve, reject } = this.waiting.get(id);
      this.waiting.delete(id);
      if (answer.error) reject(new Error(answer.error));
      else resolve(answer);
    };
    this.worker.onerror = (event) => {
      for (const { reject } of this.waiting.values()) reject(new Error(`a worker failed: ${event.message}`));
      this.waiting.clear();
    };
  }

  call(name, ...values) {
    const id = (this.last += 1);
    this.worker.postMessage({ id, name, values });
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }
}

const MISSING = 'The compiler is not part of this copy of the site: run ./course compiler (27 MB from npm, once), then ./course docs.';

/** Bytes of a part of the folder of the compiler; a script, for that is what a page from a disk may load. */
export async function loadPart(folder, name) {
  const script = document.createElement('script');
  script.src = `${folder}/${name}.js`;
  await new Promise((resolve, reject) => {
    script.onload = resolve;
    script.onerror = () => reject(new Error(MISSING));
    document.head.append(script);
  });
  const text = self.kredaParts[name];
  delete self.kredaParts[name];
  script.remove();
  return unpackPart(text);
}

/** Run a program in a worker of its own for at most `limit` milliseconds: {outputs, why it ended early or ""}. */
export function runProgram(source, module, args, inputs, limit) {
  const worker = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));
  return new Promise((resolve) => {
    const end = (answer) => { worker.terminate(); resolve({ outputs: new Uint8Array(0), ...answer }); };
    worker.onmessage = ({ data }) => {
      if (!data.begun) return end(data);
      setTimeout(() => end({ why: `was stopped after ${limit / 1000} s: does a loop not end?` }), limit);
    };
    worker.onerror = (event) => end({ why: `crashed (${event.message})` });
    worker.postMessage({ module, args, inputs });
  });
}
