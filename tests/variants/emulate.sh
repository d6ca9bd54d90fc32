#!/usr/bin/env bash
# emulate.sh PROGRAM HASHES: hash_scenes on a processor without AVX, of which every third scene must have the hash that is kept.
set -euo pipefail
if ! command -v qemu-x86_64 >/dev/null; then
    echo "SKIPPED: qemu-x86_64 is not installed (qemu-user)"
    exit 0
fi
drawn=$(qemu-x86_64 -cpu Nehalem "$1" 1 third)
missing=$(grep -vxFf "$2" <<<"$drawn" || true)
if [[ -z $drawn || -n $missing ]]; then
    printf 'other bits than those that are kept:\n%s\n' "$missing"
    exit 1
fi
echo "$(wc -l <<<"$drawn") scenes, the same bits"
