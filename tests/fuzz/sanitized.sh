#!/usr/bin/env bash
# sanitized.sh build TARGET...: build with clang's address and undefined-behaviour sanitizers (preset `fuzz`).
# sanitized.sh ROOM [DOCTEST OPTION...]: the tests of a room, built so, in their quick form.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
if ! command -v clang++ >/dev/null; then
    echo "SKIPPED: clang is not installed"
    exit 0
fi
if [[ $1 == build ]]; then
    cmake --preset fuzz >/dev/null
    exec cmake --build --preset fuzz --target "${@:2}"
fi
# Extremes of random scenes and formulas are other runs' matter.
export KREDA_SWEEP_INPUTS=100 KREDA_EXTREME_SCENES=10
exec "build/fuzz/bin/test_$1" --minimal "${@:2}"
