//! Cortex-M: the vectors, semihosting (ARM's "Semihosting for AArch32 and AArch64") and the tick counter.

use core::arch::{asm, global_asm};
use core::fmt::{self, Write};

global_asm!(
    ".section .first, \"a\"",
    ".word _stack_top, _start",
    ".rept 14",
    ".word fault",
    ".endr",
    ".section .text._start, \"ax\"",
    ".global _start",
    ".thumb_func",
    "_start:",
);

// The float unit is off after a reset: full access to coprocessors 10 and 11.
#[cfg(target_abi = "eabihf")]
global_asm!("ldr r0, =0xe000ed88", "ldr r1, [r0]", "orr r1, r1, #0xf00000", "str r1, [r0]", "dsb", "isb",);

global_asm!("bl main_on_metal", ".pool");

struct Host;

impl Write for Host {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.bytes().for_each(|byte| call(0x03, &raw const byte as usize)); // SYS_WRITEC
        Ok(())
    }
}

fn call(operation: usize, argument: usize) {
    // SAFETY: the host reads what the argument points to, and returns a word.
    unsafe { asm!("bkpt 0xab", inout("r0") operation => _, in("r1") argument) };
}

pub(crate) fn print(line: fmt::Arguments<'_>) {
    let _ = writeln!(Host, "{line}");
}

pub(crate) fn exit(passed: bool) -> ! {
    // SYS_EXIT: the application's own, or an error at run time.
    call(0x18, if passed { 0x2_0026 } else { 0x2_0023 });
    loop {}
}

#[unsafe(no_mangle)]
extern "C" fn fault() -> ! {
    print(format_args!("fault"));
    exit(false)
}

/// SysTick: under `-icount shift=10` an instruction is 25.6 ticks of 25 MHz.
pub(crate) fn ticks(work: impl FnOnce()) -> Option<u32> {
    const CONTROL: *mut u32 = 0xe000_e010 as *mut u32;
    const RELOAD: *mut u32 = 0xe000_e014 as *mut u32;
    const CURRENT: *mut u32 = 0xe000_e018 as *mut u32;
    // SAFETY: registers of every Cortex-M that has the counter; the others read as 0.
    unsafe {
        RELOAD.write_volatile(0x00ff_ffff);
        CURRENT.write_volatile(0);
        CONTROL.write_volatile(0b101);
        let start = CURRENT.read_volatile();
        work();
        Some(start.wrapping_sub(CURRENT.read_volatile()) & 0x00ff_ffff).filter(|&ticks| ticks > 0)
    }
}
