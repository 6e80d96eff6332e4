//! An archive of all calls and families, each to be linked on its own.
#![no_std]

pub use firmware::{calls, integers};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
