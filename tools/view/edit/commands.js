// The compiler's commands: the flags with which `kreda grade` compiles, for the one version of the compiler that is used.

const FLAGS = ['-triple', 'wasm32-unknown-wasip1', '-O1', '-disable-free', '-mrelocation-model', 'static', '-mframe-pointer=none',
  '-ffp-contract=off', '-target-cpu', 'generic', '-fvisibility=hidden', '-resource-dir', '/usr', '-isysroot', '/usr', '-I', '/given',
  '-internal-isystem', '/usr/include/c++/v1', '-internal-isystem', '/usr/include', '-internal-isystem', '/usr/include/wasm32-wasip1',
  '-internal-isystem', '/libraries', '-std=c++20', '-DGLM_FORCE_XYZW_ONLY', '-fdeprecated-macro', '-ferror-limit', '19',
  '-fgnuc-version=4.2.1', '-fno-implicit-modules', '-fmessage-length=0'];

export const HEADERS = '/given/headers.hpp';
const PACKED = '/given/headers.pch';

/** What students' files include, read once. */
export const precompile = () => ['clang++', '-cc1', '-emit-pch', ...FLAGS, '-o', PACKED, '-x', 'c++-header', HEADERS];

/** `more`: further flags. */
export const compile = (source, object, ...more) => ['clang++', '-cc1', '-emit-obj', ...FLAGS, ...more, '-include-pch', PACKED,
  '-fno-validate-pch', '-o', object, '-x', 'c++', source];

/** Of two functions of one name the first file's is taken. */
export const link = (objects, program) => ['wasm-ld', '-L/usr/lib/wasm32-wasip1', '/usr/lib/wasm32-wasip1/crt1-command.o', ...objects,
  '-lc++', '-lc++abi', '-lc', '/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a', '--allow-multiple-definition', '-O0',
  '--strip-all', '-o', program];
