#!/usr/bin/env bash
# Feeds the calls of tests/api/bad_input from libFuzzer, which sees which branches they take, for so many seconds (60).
# Needs g++, and nothing of cargo-fuzz: what it passes to rustc is below. A call that fails stops it, and its
# bytes are kept in target/fuzz: `run.sh FILE` repeats it.
set -euo pipefail
[ ! -f "${1:-}" ] || set -- "$(realpath "$1")"
[ -f "${1:-}" ] || [[ ${1:-60} =~ ^[1-9][0-9]*$ ]] || { echo "'$1' is neither a file nor a number of seconds" >&2; exit 1; }
cd "$(dirname "$0")"
command -v c++ >/dev/null || ../packages.sh fuzz
target=$(realpath -m "${CARGO_TARGET_DIR:-../../target}")/fuzz
host=$(rustc -vV | sed -n 's/^host: //p') # named, so that the flags below are not those of build scripts
cover=(level=4 inline-8bit-counters pc-table trace-compares)
export RUSTFLAGS="--cfg fuzzing -Cdebug-assertions -Coverflow-checks -Cpasses=sancov-module ${cover[*]/#/-Cllvm-args=-sanitizer-coverage-}"
BLUEDITHER_EFFORT=quick cargo build --quiet --locked --release --target "$host" --target-dir "$target"
program=$target/$host/release/bad_input
if [ -f "${1:-}" ]; then
    exec "$program" "$1"
fi
mkdir -p "$target/corpus"
log=$target/log.txt
"$program" -max_total_time="${1:-60}" -max_len=1024 -artifact_prefix="$target/" -print_final_stats=1 "$target/corpus" >"$log" 2>&1 ||
    { tail -n 40 "$log"; exit 1; }
calls=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
[ "${calls:-0}" -gt 0 ] || { tail -n 40 "$log"; exit 1; }
echo "fuzz: $calls calls, errors or defined values; $(find "$target/corpus" -type f | wc -l) that took a branch of their own"
