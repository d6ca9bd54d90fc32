// node pack_compiler.mjs PACKAGE SOURCES GRADE.js OUT: from the unpacked package @yowasp/clang the parts that the page
// loads: the compiler, its headers and libraries, for each assignment what is given, compiled by that very compiler, and
// the module that grades.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

import { compile, precompile } from './commands.js';
import { archive, writePart } from './parts.mjs';
import { System } from './wasi.js';

const [, , packageFolder, root, grade, out] = process.argv;
const ASSIGNMENTS = join(root, 'examples/assignments');
const BUILTIN = /^(std[a-z]+|__std\w+|float|limits|tgmath|varargs)\.h$/; // headers of clang's own that are for every processor
const LIBRARIES = /^lib\/(wasm32-wasip1\/(crt1-command\.o|lib(c|c\+\+|c\+\+abi|m)\.a)|wasm32-unknown-wasip1\/libclang_rt\.builtins\.a)$/;

/** Files of a tar archive.   POSIX ustar */
function* untar(tar) {
  const text = (from, size) => tar.subarray(from, from + size).toString().replace(/\0.*$/s, '');
  for (let at = 0; at < tar.length && tar[at] !== 0;) {
    const size = parseInt(text(at + 124, 12), 8), prefix = text(at + 345, 155);
    const name = (prefix ? `${prefix}/` : '') + text(at, 100);
    if ('0\0'.includes(String.fromCharCode(tar[at + 156]))) yield [name, tar.subarray(at + 512, at + 512 + size)];
    at += 512 + 512 * Math.ceil(size / 512);
  }
}

function isNeeded(name) {
  if (!name.startsWith('include/')) return LIBRARIES.test(name);
  const below = name.slice(8);
  if (below.startsWith('c++/v1/')) return !below.includes('/__cxx03/') && !below.includes('/experimental/') && !below.includes('/__pstl/');
  return below.startsWith('wasm32-wasip1/') ? !below.includes('/c++/') || below.includes('__config_site') : BUILTIN.test(below);
}

function systemFiles() {
  const files = new Map();
  for (const [name, bytes] of untar(readFileSync(join(packageFolder, 'gen/llvm-resources.tar')))) {
    if (isNeeded(name)) files.set(`usr/${name}`, bytes);
  }
  const glm = execFileSync('find', ['-L', '/usr/include/glm', '-type', 'f'], { encoding: 'utf8' }).trim().split('\n');
  for (const path of glm) files.set(path.replace('/usr/include/', 'libraries/'), readFileSync(path));
  return files;
}

/** The lines that include what is no file of the assignment, each once. */
function headersOf(folders) {
  const lines = new Set(['#include <algorithm>', '#include <array>', '#include <cmath>', '#include <cstdint>', '#include <vector>']);
  for (const folder of folders) {
    for (const line of readFileSync(join(ASSIGNMENTS, folder, 'assignment.hpp'), 'utf8').match(/^#include <.*>$/gm)) lines.add(line);
  }
  return Buffer.from(`${[...lines].sort().join('\n')}\n`);
}

function run(clang, args, ...files) {
  const system = new System(args, ...files);
  if (system.run(clang) !== 0) throw new Error(`${args.at(-1)}: ${system.printed}`);
  return system.written.get(args[args.indexOf('-o') + 1].slice(1)).read().slice();
}

const folders = readdirSync(ASSIGNMENTS).filter((name) => /^A\d_/.test(name)).sort();
const core = readFileSync(join(packageFolder, 'gen/llvm.core.wasm'));
const clang = new WebAssembly.Module(core);
const system = systemFiles();
writePart(out, 'clang', core);
writePart(out, 'grade', Buffer.concat([readFileSync(grade), Buffer.from([0]), readFileSync(grade.replace(/js$/, 'wasm'))]));
const given = new Map([['given/headers.hpp', headersOf(folders)], ['given/harness.hpp', readFileSync(join(ASSIGNMENTS, 'harness.hpp'))],
  ['given/main.cpp', readFileSync(join(ASSIGNMENTS, 'main.cpp'))]]);
given.set('given/headers.pch', run(clang, precompile(), system, given));
given.set('given/main.o', run(clang, compile('/given/main.cpp', '/given/main.o'), system, given));
writePart(out, 'headers', archive(new Map([...system, ...given])));

for (const folder of folders) {
  const read = (name) => readFileSync(join(ASSIGNMENTS, folder, name));
  const files = new Map(['assignment.hpp', 'stages.cpp', 'student.cpp'].map((name) => [`given/${name}`, read(name)]));
  files.set('given/stages.o', run(clang, compile('/given/stages.cpp', '/given/stages.o'), system, given, files));
  // Functions that a lesson does not show; no call is put in line, so that a reader's function is called by them.
  const solution = existsSync(join(ASSIGNMENTS, folder, 'teacher/solution.cpp')) ? 'teacher/solution.cpp' : 'student.cpp';
  const others = new Map([['given/others.cpp', read(solution)]]);
  files.set('given/others.o', run(clang, compile('/given/others.cpp', '/given/others.o', '-fno-inline'), system, given, files, others));
  for (const scene of readdirSync(join(ASSIGNMENTS, folder, 'scenes'))) files.set(`assignment/scenes/${scene}`, read(`scenes/${scene}`));
  files.set('assignment/rubric.toml', read('rubric.toml'));
  writePart(out, folder.slice(0, 2), archive(files));
  console.log(`${folder}: ready for the browser`);
}
