//! The families of functions and their checksums, for a host that knows numbers only.
#![no_std]

use core::panic::PanicInfo;

/// How many families there are.
#[unsafe(no_mangle)]
pub extern "C" fn families() -> usize {
    firmware::INTEGERS.len() + firmware::FLOATS.len()
}

/// Where the name of family `k` lies.
#[unsafe(no_mangle)]
pub extern "C" fn name(k: usize) -> *const u8 {
    family(k).0.as_ptr()
}

/// The bytes of that name.
#[unsafe(no_mangle)]
pub extern "C" fn name_length(k: usize) -> usize {
    family(k).0.len()
}

/// The checksum of family `k`.
#[unsafe(no_mangle)]
pub extern "C" fn checksum(k: usize) -> u32 {
    family(k).1()
}

fn family(k: usize) -> firmware::Family {
    match firmware::INTEGERS.get(k) {
        Some(family) => *family,
        None => firmware::FLOATS[k - firmware::INTEGERS.len()],
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
