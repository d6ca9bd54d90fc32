// The module in its worker: calls wait their turn; after a crash a new worker takes over with the same files.
import { unpackModule } from './unpack.js';

/**
 * The address of the module that uses all cores, where the page says that one lies beside it (data-threads) and its
 * server sends the headers without which browsers share no memory between threads; else nothing.
 */
function moduleWithThreads() {
  const { threads } = document.documentElement.dataset;
  return threads && self.crossOriginIsolated ? new URL(threads, document.baseURI).href : '';
}

export class Engine {
  /** `source`: of the worker, a string; `packed`: the module for one thread. `told`: hears one line when something went wrong;
   * `unpacked`: how much of the module is unpacked, 0 to 1, where that takes a while. */
  constructor(source, packed, told, unpacked) {
    this.source = source;
    this.packed = packed;
    this.told = told;
    this.unpacked = unpacked;
    this.several = moduleWithThreads();
    this.threads = 1;
    this.files = {};
    this.folder = '';
    this.last = 0;
  }

  async start() {
    this.waiting = new Map();
    try {
      if (!this.several) this.module ??= await unpackModule(this.packed, this.unpacked);
    } catch (error) {
      this.failed = error.message;
      throw error;
    }
    const address = URL.createObjectURL(new Blob([this.source], { type: 'text/javascript' }));
    this.worker = new Worker(address);
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = (event) => this.crashed(event.message);
    const { keys, threads } = await this.call('start', this.module, this.several);
    this.threads = threads;
    await this.call('write', this.files, this.folder);
    return keys;
  }

  /** Ask the worker; what it answers, or throws an Error with the line that kreda would print. */
  call(name, ...values) {
    if (this.failed) return Promise.reject(new Error(this.failed));
    const id = (this.last += 1);
    this.worker.postMessage({ id, name, values });
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  hear({ id, answer, crash }) {
    const caller = this.waiting.get(id);
    this.waiting.delete(id);
    if (crash !== undefined) this.crashed(crash, caller);
    else if (answer.error !== undefined) caller?.reject(new Error(answer.error));
    else caller?.resolve(answer);
  }

  async crashed(reason, caller) {
    this.worker.terminate();
    const restarting = new Error(`the module crashed (${reason}) and was started again`);
    for (const other of [caller, ...this.waiting.values()]) other?.reject(restarting);
    await this.start();
    this.told(restarting.message);
  }

  /** More files for the scene, {path: bytes}; `folder` is where their paths and those of the scene start. */
  async add(files, folder = this.folder) {
    Object.assign(this.files, files);
    this.folder = folder;
    await this.call('write', files, folder);
  }
}
