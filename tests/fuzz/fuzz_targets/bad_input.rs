//! See `tests/api/bad_input`.
#![no_main]

#[path = "../../api/bad_input/mod.rs"]
mod bad_input;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| bad_input::run(bytes));
