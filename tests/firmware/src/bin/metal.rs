//! Prints the checksums, the deepest stack of each, that of every call, and on a Cortex-M with a counter the
//! instructions of a row.
#![no_std]
#![no_main]

#[cfg(target_arch = "arm")]
#[path = "../machine/cortex_m.rs"]
mod machine;
#[cfg(target_arch = "riscv32")]
#[path = "../machine/riscv.rs"]
mod machine;

use firmware::calls::{CALLS, Room};
use firmware::{FLOATS, INTEGERS, one_row};
use machine::print;

const PAINT: u32 = 0x5a5a_a5a5;

unsafe extern "C" {
    static _stack_lowest: u8;
}

/// Paints what lies below the stack, works, and finds the lowest word that has changed.
#[inline(never)]
fn stack_of<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let here = 0u32;
    let top = (&raw const here) as usize & !3;
    // The first words belong to this function itself.
    let lowest = (&raw const _stack_lowest) as usize;
    let mut at = lowest;
    while at < top - 128 {
        // SAFETY: between the statics and the stack there is nothing.
        unsafe { (at as *mut u32).write_volatile(PAINT) };
        at += 4;
    }
    let done = work();
    at = lowest;
    // SAFETY: as above.
    while at < top && unsafe { (at as *const u32).read_volatile() } == PAINT {
        at += 4;
    }
    (done, top - at)
}

#[unsafe(no_mangle)]
extern "C" fn main_on_metal() -> ! {
    let mut deepest = 0;
    for &(name, work) in INTEGERS.iter().chain(FLOATS) {
        let (sum, stack) = stack_of(work);
        print(format_args!("{name}: {sum:08x}"));
        deepest = deepest.max(stack);
    }
    print(format_args!("# deepest stack {deepest} bytes"));
    let mut room = Room::new();
    for call in CALLS {
        let ((), stack) = stack_of(|| (call.work)(&mut room, 1));
        print(format_args!("# stack {} {stack}", call.key));
    }
    let source: [u8; 400] = core::array::from_fn(|x| (x * 7) as u8);
    let mut bits = [0; 50];
    let ticks = machine::ticks(|| {
        for y in 0..4 {
            core::hint::black_box(one_row(y, core::hint::black_box(&source), &mut bits));
        }
    });
    if let Some(ticks) = ticks {
        // 25.6 ticks an instruction.
        let hundredths = u64::from(ticks) * 1000 / (256 * 4 * 400);
        print(format_args!("# ticks {ticks}: {hundredths} hundredths of an instruction a pixel, grey to 1 bit"));
    }
    machine::exit(true)
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    print(format_args!("{info}"));
    machine::exit(false)
}
