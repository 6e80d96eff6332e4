//! Where a machine's memory lies.

use std::path::Path;

fn main() {
    let target = std::env::var("TARGET").unwrap_or_default();
    let out = std::env::var("OUT_DIR").unwrap_or_default();
    // QEMU's microbit, lm3s6965evb, mps2-an386 and virt.
    let (file, text) = match target.as_str() {
        "thumbv6m-none-eabi" => ("memory.x", memory("256K", "16K")),
        "thumbv7m-none-eabi" => ("memory.x", memory("256K", "64K")),
        "thumbv7em-none-eabihf" => ("memory.x", memory("4M", "4M")),
        "riscv32imac-unknown-none-elf" => ("virt.x", VIRT.to_string()),
        _ => return,
    };
    if let Err(error) = std::fs::write(Path::new(&out).join(file), text) {
        println!("cargo::error={file} cannot be written ({error})");
    }
    println!("cargo::rustc-link-search={out}");
    let script = if file == "memory.x" { "link.x" } else { file };
    println!("cargo::rustc-link-arg-bins=-T{script}");
    println!("cargo::rerun-if-changed=build.rs");
}

fn memory(flash: &str, ram: &str) -> String {
    format!("MEMORY {{ FLASH : ORIGIN = 0, LENGTH = {flash}  RAM : ORIGIN = 0x20000000, LENGTH = {ram} }}\n")
}

const VIRT: &str = "ENTRY(_start)
SECTIONS {
  . = 0x80000000;
  .text : { KEEP(*(.init)) *(.text .text.*) }
  .rodata : { *(.rodata .rodata.*) }
  .data : { *(.data .data.* .sdata .sdata.*) }
  .bss (NOLOAD) : { *(.bss .bss.* .sbss .sbss.*) }
  . = ALIGN(16);
  . += 0x10000;
  _stack_top = .;
  /DISCARD/ : { *(.eh_frame .eh_frame.*) }
}
";
