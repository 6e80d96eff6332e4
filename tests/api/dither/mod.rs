//! Halftoning: exact counts, order, naive twins, pictures, and the ends of every range.

#[cfg(feature = "gamma")]
mod gamma;
mod levels;
mod patterns;
mod rows;

use bluedither::{Dither, ScalarMask};

/// Ranks in an order without symmetry, so that no table needs to be baked.
static MASK: ScalarMask<64> = {
    let mut ranks = [[0; 64]; 64];
    let mut p = 0;
    while p < 64 * 64 {
        ranks[p / 64][p % 64] = (p * 2531 % 4096) as u16;
        p += 1;
    }
    ScalarMask::new(ranks)
};

/// Every kind of threshold, by name.
fn kinds() -> Vec<(&'static str, Dither<'static>)> {
    vec![
        ("constant", Dither::constant(1 << 31)),
        ("random", Dither::random(7)),
        ("ordered", Dither::ordered(3)),
        ("ordered, large", Dither::ordered(8)),
        ("mask", Dither::blue(&MASK)),
        ("mask, moved", Dither::blue(&MASK).frame(5).origin(17, u32::MAX)),
    ]
}

fn bit(bits: &[u8], x: usize) -> bool {
    bits[x / 8] >> (7 - x % 8) & 1 == 1
}
