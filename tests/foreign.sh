#!/usr/bin/env bash
# Runs the tests on two machines that are not this one, under QEMU: 32-bit ARM, and s390x, whose byte order is the other.
# Without --all only the tests of bits and structure that take seconds: the statistics of pictures, and the optimisers,
# would judge the same bits again. Test files that are named run alone: `rebake` bakes every table there.
# Missing packages are installed, for which it has to be root on Debian.
set -euo pipefail
cd "$(dirname "$0")/.."
root=${CARGO_TARGET_DIR:-$PWD/target}/foreign
mkdir -p "$root"
tests/packages.sh foreign

features=bytemuck,float,gamma,keys-64,lattice-64,offset-1d-64,offset-2d-64,pattern,seed-permutation,sobol-16,sobol-64
features+=,threshold-16,threshold-32,threshold-64,threshold-over-time-32,warp
dropped='clap|embedded-graphics|glam|image|indicatif|png'
files=(bad_input casts controls directions dither hash keys_2019 lattice linear mask pattern rank1 sizes sobol torus unit
    warp zorder)
if [ "${1:-}" = --all ]; then
    features+=,embedded-graphics,wgsl
    dropped='clap|image|indicatif|png'
    # All but one, whose masks are larger than an emulated machine should bake.
    mapfile -t files < <(ls tests/*.rs tests/*/main.rs | sed 's|/main.rs$||; s|\.rs$||; s|.*/||' | grep -vx over_time)
elif [ $# -gt 0 ]; then
    files=("$@")
fi

# A copy without the examples and what they depend on: that is most of what would be built.
copy=$root/crate
rm -rf "$copy" && mkdir -p "$copy/tests"
cp -rp Cargo.toml Cargo.lock build.rs src tables README.md "$copy"
cp -rp tests/*.rs tests/analysis tests/bad_input tests/common tests/dither "$copy/tests"
mkdir -p "$copy/examples/render" && cp -p examples/render/paths.rs "$copy/examples/render" # a test's
sed -i -E "/^\[dev-dependencies\]/,/^\[/ { /^($dropped) = /d }; /^members = /d; /^default-members = /d" "$copy/Cargo.toml"
awk '/^\[\[example\]\]/ { skip = 1; next } /^\[/ { skip = 0 } !skip' "$copy/Cargo.toml" >"$root/Cargo.toml"
mv "$root/Cargo.toml" "$copy/Cargo.toml"
cd "$copy"

# The standard library of these machines is built from source, by the compiler that its source is of.
export RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1 CARGO_TARGET_DIR=$root BLUEDITHER_EFFORT=quick
export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER=s390x-linux-gnu-gcc
export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_RUNNER="qemu-s390x-static -L /usr/s390x-linux-gnu"
export CARGO_TARGET_ARMV7_UNKNOWN_LINUX_GNUEABIHF_LINKER=arm-linux-gnueabihf-gcc
export CARGO_TARGET_ARMV7_UNKNOWN_LINUX_GNUEABIHF_RUNNER="qemu-arm-static -L /usr/arm-linux-gnueabihf"
targets=(armv7-unknown-linux-gnueabihf s390x-unknown-linux-gnu)
options=(--quiet --release --no-default-features --features "$features" -Zbuild-std=std,panic_unwind,test "${files[@]/#/--test=}")
/usr/bin/cargo test "${options[@]}" --no-run "${targets[@]/#/--target=}"
running=()
for target in "${targets[@]}"; do
    /usr/bin/cargo test "${options[@]}" --no-fail-fast --target="$target" >"$root/$target.txt" 2>&1 &
    running+=($!)
done
status=0
for k in 0 1; do
    wait "${running[$k]}" || status=1
    passed=$(sed -n 's/^test result: .* \([0-9]*\) passed.*/\1/p' "$root/${targets[$k]}.txt" | paste -sd+ | sed 's/^$/0/')
    echo "${targets[$k]}: $((passed)) tests passed"
done
[ "$status" = 0 ] || { grep -h -A 3 -E '^(error|failures:|thread .* panicked)' "$root"/*.txt; exit 1; }
