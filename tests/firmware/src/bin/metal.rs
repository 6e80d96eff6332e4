//! Prints the checksums, the deepest stack of each, and on Cortex-M with a counter the instructions of a row.
#![no_std]
#![no_main]

#[cfg(target_arch = "arm")]
mod machine {
    use cortex_m_semihosting::{debug, hprintln};

    pub fn print(line: core::fmt::Arguments<'_>) {
        hprintln!("{}", line);
    }

    pub fn exit(passed: bool) -> ! {
        debug::exit(if passed { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
        loop {}
    }

    #[cortex_m_rt::entry]
    fn main() -> ! {
        super::run()
    }

    /// The lowest address that the stack may reach.
    pub fn lowest() -> usize {
        cortex_m_rt::heap_start() as usize
    }

    /// SysTick: instructions under `-icount shift=10` are 25.6 ticks of 25 MHz each.
    pub fn ticks(work: impl FnOnce()) -> Option<u32> {
        let mut core = cortex_m::Peripherals::take()?;
        core.SYST.set_clock_source(cortex_m::peripheral::syst::SystClkSource::Core);
        core.SYST.set_reload(0x00ff_ffff);
        core.SYST.clear_current();
        core.SYST.enable_counter();
        let start = cortex_m::peripheral::SYST::get_current();
        work();
        Some(start.wrapping_sub(cortex_m::peripheral::SYST::get_current()) & 0x00ff_ffff)
    }
}

#[cfg(target_arch = "riscv32")]
mod machine {
    use core::fmt::Write;

    core::arch::global_asm!(".section .init", ".global _start", "_start:", "la sp, _stack_top", "call main_on_metal");

    struct Uart;

    impl Write for Uart {
        fn write_str(&mut self, text: &str) -> core::fmt::Result {
            for byte in text.bytes() {
                // SAFETY: the transmit register of QEMU's virt machine.
                unsafe { (0x1000_0000 as *mut u8).write_volatile(byte) };
            }
            Ok(())
        }
    }

    pub fn print(line: core::fmt::Arguments<'_>) {
        let _ = writeln!(Uart, "{line}");
    }

    pub fn exit(passed: bool) -> ! {
        // SAFETY: the finisher of QEMU's virt machine.
        unsafe { (0x10_0000 as *mut u32).write_volatile(if passed { 0x5555 } else { 0x1_3333 }) };
        loop {}
    }

    #[unsafe(no_mangle)]
    extern "C" fn main_on_metal() -> ! {
        super::run()
    }

    unsafe extern "C" {
        static _stack_top: u8;
    }

    pub fn lowest() -> usize {
        // The script leaves 64 KiB.
        (&raw const _stack_top) as usize - 0xf000
    }

    pub fn ticks(_: impl FnOnce()) -> Option<u32> {
        None
    }
}

const PAINT: u32 = 0x5a5a_a5a5;

/// Paints what lies below the stack, works, and finds the lowest word that has changed.
#[inline(never)]
fn stack_of(work: fn() -> u32) -> (u32, usize) {
    let here = 0u32;
    let top = (&raw const here) as usize & !3;
    let lowest = (machine::lowest() + 3) & !3;
    // Room for the frames of this function itself.
    let mut at = lowest;
    while at < top - 256 {
        // SAFETY: between the statics and the stack there is nothing.
        unsafe { (at as *mut u32).write_volatile(PAINT) };
        at += 4;
    }
    let sum = work();
    at = lowest;
    // SAFETY: as above.
    while at < top && unsafe { (at as *const u32).read_volatile() } == PAINT {
        at += 4;
    }
    (sum, top - at)
}

fn run() -> ! {
    let mut deepest = 0;
    for (name, work) in firmware::FAMILIES {
        let (sum, stack) = stack_of(work);
        machine::print(format_args!("{name}: {sum:08x}"));
        machine::print(format_args!("# stack {stack} bytes: {name}"));
        deepest = deepest.max(stack);
    }
    let source: [u8; 400] = core::array::from_fn(|x| (x * 7) as u8);
    let mut bits = [0; 50];
    let ticks = machine::ticks(|| {
        for y in 0..4 {
            core::hint::black_box(firmware::one_row(y, core::hint::black_box(&source), &mut bits));
        }
    });
    if let Some(ticks) = ticks {
        // 25.6 ticks an instruction.
        let hundredths = u64::from(ticks) * 1000 / (256 * 4 * 400);
        machine::print(format_args!("# ticks {ticks}: {hundredths} hundredths of an instruction a pixel, grey to 1 bit"));
    }
    machine::print(format_args!("# deepest stack {deepest} bytes"));
    machine::exit(true)
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    machine::print(format_args!("{info}"));
    machine::exit(false)
}
