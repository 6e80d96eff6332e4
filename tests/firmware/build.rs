//! Where a machine's memory lies: code at the first address, then the stack's place, which ends where QEMU's machine
//! does.

use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = std::env::var("TARGET").unwrap_or_default();
    let out = std::env::var("OUT_DIR").unwrap_or_default();
    // Code, memory, and bytes of memory of microbit, mps2-an385, mps2-an386 and virt.
    let [code, memory, bytes] = match target.as_str() {
        "thumbv6m-none-eabi" => [0, 0x2000_0000, 16 << 10],
        "thumbv7m-none-eabi" | "thumbv7em-none-eabihf" => [0, 0x2000_0000, 64 << 10],
        "riscv32imac-unknown-none-elf" => [0x8000_0000u32, 0x8040_0000, 64 << 10],
        _ => return,
    };
    let script = format!(
        "ENTRY(_start)
SECTIONS {{
  . = {code};
  .text : {{ KEEP(*(.first)) *(.text .text.*) }}
  .rodata : {{ *(.rodata .rodata.*) }}
  . = {memory};
  .data : {{ *(.data .data.* .sdata .sdata.*) }}
  .bss (NOLOAD) : {{ *(.bss .bss.* .sbss .sbss.*) }}
  _stack_lowest = ALIGN(16);
  _stack_top = {memory} + {bytes};
  /DISCARD/ : {{ *(.eh_frame .eh_frame.* .ARM.exidx .ARM.exidx.*) }}
}}
"
    );
    if let Err(error) = std::fs::write(Path::new(&out).join("machine.x"), script) {
        println!("cargo::error=machine.x cannot be written ({error})");
    }
    println!("cargo::rustc-link-search={out}");
    println!("cargo::rustc-link-arg-bin=metal=-Tmachine.x");
}
