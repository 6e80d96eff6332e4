//! Every function, a line each.

mod basics;
mod halftone;
mod masks;
mod samplers;
mod sequences;

use crate::case::Case;

/// All of them.
pub fn all() -> Vec<Case> {
    [basics::cases(), sequences::cases(), masks::cases(), samplers::cases(), halftone::cases()]
        .into_iter()
        .flatten()
        .collect()
}

/// A word of two halves.
fn long(low: u32, high: u32) -> u64 {
    u64::from(high) << 32 | u64::from(low)
}

/// Halves of a word, the lower one first.
fn low_high(word: u64) -> [u32; 2] {
    [word as u32, (word >> 32) as u32]
}
