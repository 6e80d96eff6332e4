//! A program of the one call, or of all integer functions, that the environment variable `CALL` names.
#![no_std]

use firmware::calls::{Call, Room, named};

#[unsafe(no_mangle)]
extern "C" fn call(room: &mut Room, n: u32) -> u32 {
    const KEY: &str = env!("CALL", "set CALL to a key of firmware::calls::CALLS");
    const CALL: Option<Call> = if let b"integers" = KEY.as_bytes() { None } else { Some(named(KEY)) };
    let Some(call) = CALL else { return firmware::integers() };
    (call.work)(room, n);
    0
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
