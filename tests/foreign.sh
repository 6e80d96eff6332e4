#!/usr/bin/env bash
# Machines that are not this one, under QEMU. Without arguments: the checksums of tests/firmware on s390x, whose byte order
# is the other, against this machine's (32 bits are what tests/firmware/run.sh has). `foreign.sh --all` runs `cargo test`
# on s390x and on 32-bit ARM, `foreign.sh NAME …` the tests whose names have one of these parts.
# Missing packages are installed, for which it has to be root on Debian 12.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$(realpath -m "${CARGO_TARGET_DIR:-target}")/foreign
mkdir -p "$root"
tests/packages.sh foreign

# The standard library of these machines is built from source, by the compiler that its source is of.
export RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR=$root
export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER=s390x-linux-gnu-gcc
export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_RUNNER="qemu-s390x-static -L /usr/s390x-linux-gnu"
export CARGO_TARGET_ARMV7_UNKNOWN_LINUX_GNUEABIHF_LINKER=arm-linux-gnueabihf-gcc
export CARGO_TARGET_ARMV7_UNKNOWN_LINUX_GNUEABIHF_RUNNER="qemu-arm-static -L /usr/arm-linux-gnueabihf"
targets=(armv7-unknown-linux-gnueabihf s390x-unknown-linux-gnu)

if [ $# -eq 0 ]; then
    cd tests/firmware
    export BLUEDITHER_EFFORT=quick # the same tables on both sides
    options=(--quiet --release --bin host --target-dir "$root/../firmware")
    /usr/bin/cargo build "${options[@]}"
    # Building takes all the time.
    export CARGO_PROFILE_RELEASE_OPT_LEVEL=1 CARGO_PROFILE_RELEASE_LTO=false CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16
    /usr/bin/cargo build "${options[@]}" -Zbuild-std=std,panic_abort --target=s390x-unknown-linux-gnu
    here=$("$root/../firmware/release/host")
    there=$(qemu-s390x-static -L /usr/s390x-linux-gnu "$root/../firmware/s390x-unknown-linux-gnu/release/host")
    diff <(echo "$here") <(echo "$there") || { echo "s390x differs from this machine"; exit 1; }
    [ "$(wc -l <<<"$here")" -gt 20 ] || { echo "the checksums are missing"; exit 1; }
    echo "s390x: $(wc -l <<<"$here") families as on this machine"
    exit
fi

# Of every kind one or two tables, baked on this machine; `over_time`, which compares all, is left out by that.
features=bytemuck,embedded-graphics,float,gamma,keys-64,lattice-64,offset-1d-64,offset-2d-64,pattern,seed-permutation
features+=,sobol-16,sobol-64,threshold-16,threshold-32,threshold-64,threshold-over-time-32,warp,wgsl
filters=("$@")
[ "$1" != --all ] || filters=("${@:2}")

# A copy without the examples and what they depend on: that is most of what would be built.
copy=$root/crate
rm -rf "$copy" && mkdir -p "$copy/tests"
cp -rp Cargo.toml Cargo.lock build.rs src tables README.md "$copy"
cp -rp tests/analysis tests/api tests/bake "$copy/tests"
mkdir -p "$copy/examples/render" && cp -p examples/render/paths.rs "$copy/examples/render" # a test's
sed -i -E "/^\[dev-dependencies\]/,/^\[/ { /^(clap|image|indicatif|png) = /d }; /^members = /d; /^default-members = /d" "$copy/Cargo.toml"
awk '/^\[\[example\]\]/ { skip = 1; next } /^\[/ { skip = 0 } !skip' "$copy/Cargo.toml" >"$root/Cargo.toml"
mv "$root/Cargo.toml" "$copy/Cargo.toml"
cd "$copy"

options=(--quiet --release --no-default-features --features "$features" -Zbuild-std=std,panic_unwind,test --tests)
/usr/bin/cargo test "${options[@]}" --no-run "${targets[@]/#/--target=}"
running=()
for target in "${targets[@]}"; do
    /usr/bin/cargo test "${options[@]}" --no-fail-fast --target="$target" -- ${filters[@]+"${filters[@]}"} >"$root/$target.txt" 2>&1 &
    running+=($!)
done
status=0
for k in 0 1; do
    wait "${running[$k]}" || status=1
    passed=$(sed -n 's/^test result: .* \([0-9]*\) passed.*/\1/p' "$root/${targets[$k]}.txt" | paste -sd+ | sed 's/^$/0/')
    echo "${targets[$k]}: $((passed)) tests passed"
    [ $((passed)) -gt 0 ] || status=1
done
[ "$status" = 0 ] || { grep -h -A 3 -E '^(error|failures:|thread .* panicked)' "$root"/*.txt; exit 1; }
