//! Arguments for a million calls: random, extreme, and small numbers.

use std::sync::LazyLock;

use bluedither::hash;

/// How many calls of a function are compared.
pub const CALLS: usize = 1 << 20;

/// The most arguments that a function has.
const MOST: usize = 8;

static WORDS: LazyLock<Vec<u32>> = LazyLock::new(|| (0..(CALLS * MOST) as u64).map(word).collect());

/// The words of all calls, `count` each.
pub fn arguments(count: usize) -> &'static [u32] {
    &WORDS[..CALLS * count]
}

/// One half anything, a quarter the ends of ranges, a quarter of any number of bits.
fn word(place: u64) -> u32 {
    let random = hash::mix_64(place);
    let (value, choice) = (random as u32, (random >> 32) as u32);
    match choice & 3 {
        0 => {
            let power = 1u32 << (choice >> 4 & 31);
            [0, 1, u32::MAX, power, power - 1, !power, power + 1, 0x7fff_ffff][(choice >> 9 & 7) as usize]
        }
        1 => value >> (choice >> 4 & 31),
        _ => value,
    }
}
