// A system for one program: arguments and files in memory, after wasi_snapshot_preview1. It has no clock to wait for, no
// network and no directory to list; what a program asks for beyond that is answered with "not supported".
const SUCCESS = 0, BAD_FILE = 8, EXISTS = 20, INVALID = 28, NO_ENTRY = 44, NOT_SUPPORTED = 58;
const KIND = { device: 2, directory: 3, file: 4 };
const ROOT = 3; // the descriptor of "/"

/** How a program ended that called exit(). */
export class Exit extends Error {
  constructor(code) {
    super(`exit ${code}`);
    this.code = code;
  }
}

/** "a/./b/../c" as "a/c"; leading strokes fall away. */
function plain(path) {
  const parts = [];
  for (const part of path.split('/')) {
    if (part === '..') parts.pop();
    else if (part && part !== '.') parts.push(part);
  }
  return parts.join('/');
}

/** Bytes that grow while a program writes them. */
class Growing {
  constructor(bytes) {
    this.bytes = bytes;
    this.size = bytes.length;
  }

  write(at, more) {
    const end = at + more.length;
    if (end > this.bytes.length) {
      const larger = new Uint8Array(Math.max(end, 2 * this.bytes.length));
      larger.set(this.bytes.subarray(0, this.size));
      this.bytes = larger;
    }
    this.bytes.set(more, at);
    this.size = Math.max(this.size, end);
  }

  read() {
    return this.bytes.subarray(0, this.size);
  }
}

export class System {
  /** `files`: Maps of path to bytes, looked through in turn; what the program writes goes to `written`. */
  constructor(args, ...files) {
    this.args = args;
    this.files = files;
    this.written = new Map();
    this.folders = new Set(['']);
    for (const path of files.flatMap((map) => [...map.keys()])) this.addFolders(path);
    this.open = [null, null, null, { folder: '' }];
    this.printed = '';
    this.decoder = new TextDecoder();
  }

  addFolders(path) {
    for (let at = path.lastIndexOf('/'); at > 0; at = path.lastIndexOf('/', at - 1)) this.folders.add(path.slice(0, at));
  }

  find(path) {
    if (this.written.has(path)) return this.written.get(path);
    for (const map of this.files) if (map.has(path)) return new Growing(map.get(path));
    return null;
  }

  /** Run _start of the module to its end; the code that it ended with. */
  run(module) {
    const { exports } = new WebAssembly.Instance(module, { wasi_snapshot_preview1: this.calls() });
    this.memory = exports.memory;
    try {
      exports._start();
    } catch (error) {
      if (error instanceof Exit) return error.code;
      throw error;
    }
    return 0;
  }

  view() { return new DataView(this.memory.buffer); }
  bytes(at, size) { return new Uint8Array(this.memory.buffer, at, size); }
  text(at, size) { return this.decoder.decode(this.bytes(at, size).slice()); }

  /** The buffers of an array of (address, size). */
  buffers(at, count) {
    const view = this.view();
    return Array.from({ length: count }, (_, i) => this.bytes(view.getUint32(at + 8 * i, true), view.getUint32(at + 8 * i + 4, true)));
  }

  putStrings(list, pointers, at) {
    const view = this.view();
    list.forEach((text, i) => {
      const bytes = new TextEncoder().encode(`${text}\0`);
      view.setUint32(pointers + 4 * i, at, true);
      this.bytes(at, bytes.length).set(bytes);
      at += bytes.length;
    });
    return SUCCESS;
  }

  putStat(at, kind, size, number) {
    this.bytes(at, 64).fill(0);
    const view = this.view();
    view.setBigUint64(at + 8, BigInt(number), true);
    this.bytes(at, 64)[16] = kind;
    view.setBigUint64(at + 24, 1n, true);
    view.setBigUint64(at + 32, BigInt(size), true);
    return SUCCESS;
  }

  /** A number for a path, the same for the same path. */
  number(path) {
    this.numbers ??= new Map();
    if (!this.numbers.has(path)) this.numbers.set(path, this.numbers.size + 1);
    return this.numbers.get(path);
  }

  readAt(file, at, from, count) {
    let done = 0;
    for (const buffer of this.buffers(from, count)) {
      const part = file.read().subarray(at + done, at + done + buffer.length);
      buffer.set(part);
      done += part.length;
    }
    return done;
  }

  openFile(folder, path, flags, result) {
    const whole = plain(`${folder}/${path}`);
    let file = this.find(whole);
    const [create, wantsFolder, isNew, empty] = [1, 2, 4, 8].map((bit) => (flags & bit) !== 0);
    if (file && create && isNew) return EXISTS;
    if (!file && this.folders.has(whole)) this.open.push({ folder: whole });
    else {
      if (wantsFolder || (!file && !create)) return NO_ENTRY;
      if (!file || empty) file = new Growing(new Uint8Array(0));
      if (create || empty) this.written.set(whole, file);
      this.addFolders(whole);
      this.open.push({ file, path: whole, at: 0 });
    }
    this.view().setUint32(result, this.open.length - 1, true);
    return SUCCESS;
  }

  seek(opened, offset, whence, result) {
    const from = [0, opened.at, opened.file.size][whence];
    opened.at = from + Number(offset);
    this.view().setBigUint64(result, BigInt(opened.at), true);
    return SUCCESS;
  }

  writeTo(fd, from, count, result) {
    let done = 0;
    for (const buffer of this.buffers(from, count)) {
      if (fd < ROOT) this.printed += this.decoder.decode(buffer.slice(), { stream: true });
      else {
        const opened = this.open[fd];
        opened.file.write(opened.at, buffer);
        opened.at += buffer.length;
      }
      done += buffer.length;
    }
    this.view().setUint32(result, done, true);
    return SUCCESS;
  }

  folderCalls() {
    const at = (fd) => this.open[fd]?.folder ?? '';
    return {
      path_open: (fd, _, path, size, flags, ...rest) => this.openFile(at(fd), this.text(path, size), flags, rest.at(-1)),
      path_filestat_get: (fd, _, path, size, result) => {
        const whole = plain(`${at(fd)}/${this.text(path, size)}`), file = this.find(whole);
        if (file) return this.putStat(result, KIND.file, file.size, this.number(whole));
        return this.folders.has(whole) ? this.putStat(result, KIND.directory, 0, this.number(whole)) : NO_ENTRY;
      },
      path_create_directory: (fd, path, size) => {
        this.folders.add(plain(`${at(fd)}/${this.text(path, size)}`));
        return SUCCESS;
      },
      path_unlink_file: (fd, path, size) => (this.written.delete(plain(`${at(fd)}/${this.text(path, size)}`)) ? SUCCESS : NO_ENTRY),
      path_rename: (fd, path, size, toFd, to, toSize) => {
        const from = plain(`${at(fd)}/${this.text(path, size)}`), file = this.written.get(from);
        if (!file) return NO_ENTRY;
        this.written.delete(from);
        this.written.set(plain(`${at(toFd)}/${this.text(to, toSize)}`), file);
        return SUCCESS;
      },
      path_readlink: () => INVALID,
      fd_prestat_get: (fd, result) => {
        if (fd !== ROOT) return BAD_FILE;
        this.view().setUint32(result, 0, true);
        this.view().setUint32(result + 4, 1, true);
        return SUCCESS;
      },
      fd_prestat_dir_name: (fd, result) => {
        this.bytes(result, 1)[0] = 0x2f;
        return SUCCESS;
      },
    };
  }

  fileCalls() {
    const opened = (fd, work) => (this.open[fd]?.file ? work(this.open[fd]) : BAD_FILE);
    const read = (file, at, from, count, result) => {
      const done = this.readAt(file, at, from, count);
      this.view().setUint32(result, done, true);
      return done;
    };
    return {
      fd_read: (fd, from, count, result) => {
        if (fd < ROOT) return this.view().setUint32(result, 0, true) ?? SUCCESS;
        return opened(fd, (o) => { o.at += read(o.file, o.at, from, count, result); return SUCCESS; });
      },
      fd_pread: (fd, from, count, at, result) => opened(fd, (o) => { read(o.file, Number(at), from, count, result); return SUCCESS; }),
      fd_write: (fd, from, count, result) => (fd < ROOT ? this.writeTo(fd, from, count, result) : opened(fd, () => this.writeTo(fd, from, count, result))),
      fd_seek: (fd, offset, whence, result) => opened(fd, (o) => this.seek(o, offset, whence, result)),
      fd_close: (fd) => { this.open[fd] = null; return SUCCESS; },
      fd_filestat_get: (fd, result) => {
        const o = this.open[fd];
        if (o?.file) return this.putStat(result, KIND.file, o.file.size, this.number(o.path));
        return this.putStat(result, o ? KIND.directory : KIND.device, 0, 0);
      },
      fd_fdstat_get: (fd, result) => {
        this.bytes(result, 24).fill(0);
        this.bytes(result, 1)[0] = fd < ROOT ? KIND.device : this.open[fd]?.file ? KIND.file : KIND.directory;
        this.bytes(result + 8, 16).fill(0xff); // all rights
        return this.open[fd] || fd < ROOT ? SUCCESS : BAD_FILE;
      },
      fd_filestat_set_size: (fd, size) => opened(fd, (o) => { o.file.size = Number(size); return SUCCESS; }),
    };
  }

  /** What the program imports. */
  calls() {
    const known = {
      ...this.folderCalls(),
      ...this.fileCalls(),
      args_sizes_get: (count, size) => {
        this.view().setUint32(count, this.args.length, true);
        this.view().setUint32(size, new TextEncoder().encode(this.args.join('\0')).length + 1, true);
        return SUCCESS;
      },
      args_get: (pointers, at) => this.putStrings(this.args, pointers, at),
      environ_sizes_get: (count, size) => { this.view().setUint32(count, 0, true); this.view().setUint32(size, 0, true); return SUCCESS; },
      environ_get: () => SUCCESS,
      clock_time_get: (id, precision, result) => {
        this.view().setBigUint64(result, BigInt(Math.round(1e6 * performance.now())), true);
        return SUCCESS;
      },
      random_get: (at, size) => { this.bytes(at, size).fill(7); return SUCCESS; },
      proc_exit: (code) => { throw new Exit(code); },
    };
    return new Proxy(known, { get: (calls, name) => calls[name] ?? (() => NOT_SUPPORTED), has: () => true });
  }
}
