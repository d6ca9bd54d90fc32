#!/usr/bin/env bash
# coverage.sh [ROOM...]: which lines of raster, lighting, shadows and scene the unit tests run. Says the share of each room, and
# writes the lines that no test runs to build/coverage/missing.txt. Exit code 1 where a room has less than 95 %. Needs gcc and gcov.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
rooms=("$@")
(( ${#rooms[@]} )) || rooms=(raster lighting shadows scene)
tests=() images=()
for room in "${rooms[@]}"; do tests+=("test_$room"); done
[[ " ${rooms[*]} " != *" scene "* ]] || { tests+=(test_plan test_stability); images=(kreda_images); }

cmake --preset coverage >/dev/null
cmake --build --preset coverage --target "${tests[@]}" ${images[@]+"${images[@]}"}
find build/coverage -name '*.gcda' -delete
for test in "${tests[@]}"; do
    # Extremes of random scenes and formulas are other tests' matter: fewer of them run the same lines. Two threads would wait for each
    # other at every counter.
    KREDA_SWEEP_INPUTS=100 KREDA_EXTREME_SCENES=20 KREDA_CHANGED_SCENES=10 OMP_NUM_THREADS=1 "build/coverage/bin/$test" -m >"build/coverage/$test.txt" ||
        { tail -n 30 "build/coverage/$test.txt"; exit 1; }
done
python3 tests/coverage.py build/coverage "${rooms[@]}"
