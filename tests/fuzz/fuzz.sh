#!/usr/bin/env bash
# fuzz.sh SECONDS FOLDER: fuzz each reader for its share of the time. What it learned goes to FOLDER/READER/corpus, so that the next
# run goes on there; an input that ends the program to FOLDER/READER/crash-..., and the exit code is 1 then.
set -euo pipefail
seconds=$1 folder=$(mkdir -p "$2" && cd "$2" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if ! command -v clang++ >/dev/null; then
    echo "SKIPPED: clang is not installed"
    exit 0
fi
if [[ -z ${KREDA_FUZZ_PROGRAM:-} ]]; then
    "$root/tests/fuzz/sanitized.sh" build fuzz >"$folder/build.txt" || { tail -n 30 "$folder/build.txt"; exit 1; }
fi
program=${KREDA_FUZZ_PROGRAM:-$root/build/fuzz/bin/fuzz}
readers=(scene obj mtl gltf image)
failed=0
for reader in "${readers[@]}"; do
    here=$folder/$reader
    mkdir -p "$here/corpus" "$here/files"
    seeds=("$root/tests/fuzz/seeds/$reader")
    # OpenImageIO runs in a child process, which libFuzzer cannot see; a crash there is not ours, the exit code says which is.
    if ! (cd "$here" && OMP_NUM_THREADS=1 KREDA_FUZZED=$reader KREDA_FUZZ_FOLDER=$here/files ASAN_OPTIONS=detect_leaks=0 \
          "$program" -max_total_time=$(( seconds / ${#readers[@]} )) -max_len=6000 -timeout=25 -rss_limit_mb=4096 -print_final_stats=1 \
          -verbosity=0 "$here/corpus" "${seeds[@]}" >"$here/log.txt" 2>&1); then
        echo "$reader: an input ends the program; see $here"
        grep -aE 'ERROR|SUMMARY|runtime error|Test unit written' "$here/log.txt" | head -n 20
        failed=1
    fi
    echo "$reader: $(grep -a 'number_of_executed_units' "$here/log.txt" | grep -oE '[0-9]+$' || echo 0) executions," \
         "$(find "$here/corpus" -type f | wc -l) inputs in the corpus"
done
exit $failed
