#!/usr/bin/env bash
# Runs the checksums of tests/firmware as WebAssembly in node and on this machine, and compares. Missing packages are
# installed, for which it has to be root on Debian.
set -euo pipefail
cd "$(dirname "$0")"
export BLUEDITHER_EFFORT=quick # the same tables on both sides
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-../../target}")/firmware
export CARGO_TARGET_DIR
../packages.sh wasm

# The standard library is built from source, by the compiler that its source is of.
export RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld-22
(cd ../firmware && /usr/bin/cargo build --quiet --release --bin host)
/usr/bin/cargo build --quiet --release -Zbuild-std=core,compiler_builtins --target wasm32-unknown-unknown
here=$("$CARGO_TARGET_DIR/release/host")
there=$(node run.mjs "$CARGO_TARGET_DIR/wasm32-unknown-unknown/release/wasm.wasm")
diff <(echo "$here") <(echo "$there") || { echo "WebAssembly differs from this machine"; exit 1; }
[ "$(wc -l <<<"$here")" -gt 20 ] || { echo "the checksums are missing"; exit 1; }
echo "WebAssembly: $(wc -l <<<"$here") families as on this machine"
