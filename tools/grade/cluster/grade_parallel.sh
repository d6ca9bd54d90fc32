#!/usr/bin/env bash
# Grade a class with GNU parallel, on this machine or on several.
#
#   grade_parallel.sh CLASS RUBRIC OUT [OPTION OF kreda grade...]
#
# Every submission is a command of its own that keeps nothing but its result: run this again after a failure, and it goes
# on. Variables: KREDA, the program (default: kreda); KREDA_MACHINES, as parallel's --sshlogin takes them
# ("4/first,8/second,:"). All machines see the folders and the program under the same names.
set -euo pipefail
(( $# >= 3 )) || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
kreda=${KREDA:-kreda}
class=$(realpath "$1") rubric=$(realpath "$2") out=$(realpath -m "$3")
shift 3
command -v parallel >/dev/null || { echo "GNU parallel is missing: apt-get install parallel" >&2; exit 2; }
mkdir -p "$out"
find "$class" -mindepth 1 -maxdepth 1 -type d -not -name '.*' -printf '%f\0' | sort -z |
    parallel --null --will-cite ${KREDA_MACHINES:+--sshlogin "$KREDA_MACHINES"} --joblog "$out/parallel.log" \
        "$kreda" grade "$class"/{} --rubric "$rubric" -o "$out"/{} --resume "$@" '>' /dev/null ||
    echo "some submissions have no result yet: they are graded here now" >&2
exec "$kreda" grade --class "$class" --rubric "$rubric" -o "$out" "$@"
