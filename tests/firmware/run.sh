#!/usr/bin/env bash
# Runs the checksums on this machine and, under QEMU, on four processors, and compares; then measures what calls cost
# the smallest of them and compares with the README (with --write: writes it there).
# Missing packages are installed, for which it has to be root on Debian.
set -euo pipefail
shopt -s inherit_errexit # what fails inside $(…) stops all of it
cd "$(dirname "$0")"
export BLUEDITHER_EFFORT=quick # the same tables on both sides
CARGO_TARGET_DIR=$(realpath -m "${CARGO_TARGET_DIR:-../../target}")/firmware
export CARGO_TARGET_DIR
../packages.sh firmware

# The standard library of these targets is built from source, by the compiler that its source is of.
export RUSTC=/usr/bin/rustc RUSTDOC=/usr/bin/rustdoc RUSTC_BOOTSTRAP=1
targets=(thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabihf riscv32imac-unknown-none-elf)
/usr/bin/cargo build --quiet --release --bin metal -Zbuild-std=core,compiler_builtins "${targets[@]/#/--target=}"
/usr/bin/cargo build --quiet --release --bin host --bin cost
/usr/bin/cargo test --quiet --release --bin cost >/dev/null
host=$("$CARGO_TARGET_DIR/release/host")

run() {
    local name=$1 target=$2 expected stack
    shift 2
    output=$(timeout 300 "$@" -nographic -semihosting-config enable=on,target=native \
        -kernel "$CARGO_TARGET_DIR/$target/release/metal" 2>&1 | tr -d '\r') || { echo "$name failed: $output"; return 1; }
    expected=$host
    diff <(echo "$expected") <(grep -v '^#' <<<"$output") || { echo "$name differs from this machine"; return 1; }
    stack=$(sed -n 's/^# deepest stack \([0-9]*\).*/\1/p' <<<"$output")
    echo "$name: $(wc -l <<<"$expected") families as on this machine; deepest stack, of their own rows as well, $stack bytes"
    [ "$stack" -le 9000 ] || { echo "$name: that is more stack than the 9000 bytes that were enough"; return 1; }
}

# The code, constants, stack and functions of floating point of a program of one call, as small as it gets.
program() {
    local program=$CARGO_TARGET_DIR/call
    CALL=$1 /usr/bin/cargo build --quiet --release --no-default-features --example call \
        -Zbuild-std=core,compiler_builtins --target=thumbv6m-none-eabi
    ld.lld-22 --gc-sections --entry=call -o "$program" "$CARGO_TARGET_DIR/thumbv6m-none-eabi/release/examples/libcall.a"
    llvm-size-22 -A "$program" |
        awk '$1 ~ /^\.text/ { code += $2 } $1 ~ /^\.rodata/ { constants += $2 } END { printf "%d %d", code, constants }'
    echo " ${stacks[$1]:-0} $(llvm-nm-22 "$program" | grep -Ec 'compiler_builtins5float|__aeabi_(f|d|u?[il]2)')"
}

run Cortex-M3 thumbv7m-none-eabi qemu-system-arm -machine mps2-an385
run RISC-V riscv32imac-unknown-none-elf qemu-system-riscv32 -M virt -bios none
run Cortex-M4 thumbv7em-none-eabihf qemu-system-arm -cpu cortex-m4 -machine mps2-an386 -icount shift=10 # repeats exactly
hundredths=$(sed -n 's/^# ticks [0-9]*: \([0-9]*\).*/\1/p' <<<"$output")
echo "Cortex-M4: $hundredths hundredths of an instruction a pixel of grey to 1 bit"
[ "$hundredths" -le 1200 ] || { echo "Cortex-M4: more than 12 instructions a pixel"; exit 1; }
run Cortex-M0 thumbv6m-none-eabi qemu-system-arm -machine microbit

declare -A stacks
while read -r key stack; do stacks[$key]=$stack; done < <(sed -n 's/^# stack //p' <<<"$output")
for key in $("$CARGO_TARGET_DIR/release/cost"); do
    cost=$(program "$key")
    echo "$key $cost"
done | "$CARGO_TARGET_DIR/release/cost" ../../README.md "$@"
