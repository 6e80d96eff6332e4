#!/usr/bin/env bash
# Runs the checksums on this machine and, under QEMU, on four processors, and compares.
# Needs the packages rustc-web cargo-web rust-web-src rust-web-llvm lld-22 qemu-system-arm qemu-system-misc.
set -euo pipefail
cd "$(dirname "$0")"
export BLUEDITHER_EFFORT=quick # the same tables on both sides
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-../../target}/firmware

cargo build --quiet --release --bin host
host=$("$CARGO_TARGET_DIR/release/host")

# The standard library of these targets is built from source, by the compiler that its source is of.
export RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1
semihosting=(-nographic -semihosting-config enable=on,target=native)
targets=(thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabihf riscv32imac-unknown-none-elf)
/usr/bin/cargo build --quiet --release --bin metal -Zbuild-std=core,compiler_builtins "${targets[@]/#/--target=}"

run() {
    local name=$1 target=$2 stack
    shift 2
    output=$(timeout 60 "$@" -kernel "$CARGO_TARGET_DIR/$target/release/metal") || { echo "$name failed: $output"; return 1; }
    diff <(echo "$host") <(grep -v '^#' <<<"$output" | tr -d '\r') || { echo "$name differs from this machine"; return 1; }
    stack=$(sed -n 's/^# deepest stack \([0-9]*\).*/\1/p' <<<"$output")
    echo "$name: as on this machine; deepest stack, of the tests' own rows as well, $stack bytes"
    [ "$stack" -le 9000 ] || { echo "$name: that is more stack than the 9000 bytes that were enough"; return 1; }
}

run "Cortex-M0" thumbv6m-none-eabi qemu-system-arm -machine microbit "${semihosting[@]}"
run "Cortex-M3" thumbv7m-none-eabi qemu-system-arm -machine lm3s6965evb "${semihosting[@]}"
run "Cortex-M4" thumbv7em-none-eabihf qemu-system-arm -cpu cortex-m4 -machine mps2-an386 -icount shift=10 "${semihosting[@]}" # repeats exactly
hundredths=$(sed -n 's/^# ticks [0-9]*: \([0-9]*\).*/\1/p' <<<"$output")
echo "Cortex-M4: $hundredths hundredths of an instruction a pixel of grey to 1 bit"
[ "$hundredths" -le 1200 ] || { echo "Cortex-M4: more than 12 instructions a pixel"; exit 1; }
run "RISC-V" riscv32imac-unknown-none-elf qemu-system-riscv32 -M virt -nographic -bios none
