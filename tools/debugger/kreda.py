# gdb for the course:  gdb -x tools/debugger/kreda.py --args build/debug/bin/22_phong_terms      (docs/debugging.md)
import os
import sys

import gdb

sys.dont_write_bytecode = True
# __file__ is another script's when that one sources this.
sys.path.insert(0, os.path.dirname(os.path.abspath(sys._getframe().f_code.co_filename)))

import kreda_commands
import kreda_printers

kreda_printers.register()
kreda_commands.register()

# `step` goes into the lecture's functions, not into these.
for nothing_to_see in ("^glm::", "^std::", "^__gnu_cxx::", "^kreda::raster::Channel3?::", "^kreda::raster::lanes_for"):
    gdb.execute("skip -rfunction " + nothing_to_see, to_string=True)

for setting in ("confirm off", "pagination off", "print pretty on", "print elements 32",
                "print thread-events off", "startup-with-shell off"):
    gdb.execute("set " + setting)
gdb.execute("set environment OMP_NUM_THREADS 1")  # one thread: nothing else moves while you look


# Reading the symbols of all libraries (OpenImageIO brings 200) takes seconds. These few are enough.
LIBRARIES = r"/(libc|libm|libpthread|libstdc\+\+|libgomp|libomp)[.-]"


def read_symbols_of_libraries(_):
    gdb.execute("sharedlibrary " + LIBRARIES, to_string=True)


gdb.execute("set auto-solib-add off")
gdb.events.stop.connect(read_symbols_of_libraries)
