//! Arguments as nobody would choose them: lengths that do not fit, rectangles outside, floats that are no numbers. What
//! must come of it is written beside every call in the other files: a typed error or a defined value. `tests/fuzz`
//! feeds the same function from a fuzzer that sees which branches are taken.

mod calls;
mod input;
mod rows;

use input::Input;

/// `BAD_INPUTS=1000000 cargo test --release --all-features bad_input::`: longer.
#[test]
fn random_arguments_give_errors_or_values() {
    let rounds = std::env::var("BAD_INPUTS").ok().and_then(|text| text.parse().ok()).unwrap_or(20_000u32);
    let mut state = 1u64;
    for round in 0..rounds {
        let bytes: [u8; 1024] = core::array::from_fn(|_| {
            state = bluedither::hash::mix_64(state.wrapping_add(0x9e37_79b9_7f4a_7c15));
            state as u8
        });
        // Ending anywhere: what is missing counts as zeros.
        run(&bytes[..8 + round as usize % if round % 8 == 0 { 1017 } else { 89 }]);
    }
}

#[test]
fn nothing_and_all_ones_give_errors_or_values() {
    for byte in [0, 1, 0x7f, 0x80, 0xff] {
        for call in 0..=255 {
            let mut bytes = [byte; 96];
            bytes[0] = call;
            run(&bytes);
        }
    }
}

/// One call, chosen and given its arguments by the bytes.
pub(crate) fn run(bytes: &[u8]) {
    let mut input = Input::new(bytes);
    match input.byte() % 10 {
        0..4 => rows::run(&mut input),
        4 => calls::values(&mut input),
        5 => calls::samplers(&mut input),
        6 => calls::tables(&mut input),
        7 => calls::candidates(&mut input),
        8 => calls::seeds(&mut input),
        _ => calls::floats(&mut input),
    }
}
