//! See `tests/bad_input`.
#![no_main]

#[path = "../../bad_input/main.rs"]
mod bad_input;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| bad_input::run(bytes));
