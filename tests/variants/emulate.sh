#!/usr/bin/env bash
# emulate.sh PROGRAM HASHES PROCESSOR: hash_scenes on an emulated x86 processor (qemu-x86_64 -cpu help lists them); every third scene
# must have the hash that is kept.
set -euo pipefail
if ! command -v qemu-x86_64 >/dev/null; then
    echo "SKIPPED: qemu-x86_64 is not installed (qemu-user)"
    exit 0
fi
# qemu says which instructions of the processor it leaves out: a line for each.
drawn=$(qemu-x86_64 -cpu "$3" "$1" 1 third 2>/dev/null)
missing=$(grep -vxFf "$2" <<<"$drawn" || true)
if [[ -z $drawn || -n $missing ]]; then
    printf 'other bits than those that are kept:\n%s\n' "$missing"
    exit 1
fi
echo "$(wc -l <<<"$drawn") scenes, the same bits"
