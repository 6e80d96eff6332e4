//! The tables as words of 32 bits, the earlier of two halves in the lower 16 bits: the bytes of a little-endian
//! machine, on any host.

use crate::net::Order;
use crate::sobol::Directions;
use crate::tables::{NET, SEQUENCE};
use crate::{Keys, ScalarMask, VectorMask};

/// The constants of the joint net, for [`NET`](super::NET): 996 words.
pub fn net_words() -> impl Iterator<Item = u32> + Clone {
    let columns = |order: &'static Order| order.samples.iter().chain(&order.inside).chain(&order.place);
    let orders = NET.known.iter().chain([&NET.progressive]).flat_map(columns);
    orders.chain(&NET.frames).flatten().copied()
}

/// The sequence of [`Keyed`](crate::Keyed), for [`SEQUENCE`](super::SEQUENCE): 112 words.
pub fn sequence_words() -> impl Iterator<Item = u32> + Clone {
    // The bits of a reversed index that select one entry each.
    let nibbles = (0..16).map(|sum| sum << 28).chain((0..16).map(|sum| sum << 24));
    let singles = (0..24).map(|bit| 1 << (23 - bit));
    nibbles.chain(singles).flat_map(|index_rev| low_high(SEQUENCE.packed_rev(index_rev)))
}

#[expect(clippy::cast_possible_truncation, reason = "halves of a word")]
const fn low_high(word: u64) -> [u32; 2] {
    [word as u32, (word >> 32) as u32]
}

/// The ranks of a mask of one channel, two a word, for [`SCALAR_MASK`](super::SCALAR_MASK).
pub fn scalar_words<const S: usize>(mask: &ScalarMask<S>) -> impl Iterator<Item = u32> + Clone {
    pairs(mask.ranks().as_flattened())
}

/// The ranks of a mask of two channels, a pixel a word, for [`VECTOR_MASK`](super::VECTOR_MASK).
pub fn vector_words<const S: usize>(mask: &VectorMask<2, S>) -> impl Iterator<Item = u32> + Clone {
    pairs(mask.ranks().as_flattened().as_flattened())
}

/// The keys of a tile, for [`KEYS_TILE`](super::KEYS_TILE).
pub fn keys_words<const S: usize>(keys: &Keys<S>) -> impl Iterator<Item = u32> + Clone {
    places::<S>().map(|(x, y)| keys.digits(x, y))
}

/// The direction numbers of some dimensions, 32 each, for [`DIRECTION_NUMBERS`](super::DIRECTION_NUMBERS).
pub fn direction_words<const D: usize>(directions: &Directions<D>) -> impl Iterator<Item = u32> + Clone {
    (0..D as u64 * 32).map(|place| directions.dimension(1 << (place % 32), low_high(place / 32)[0]))
}

/// The ranks of masks over time, two a word, for [`TIME_MASK`](super::TIME_MASK).
pub fn time_words<const S: usize, const T: usize>(
    mask: &crate::frames::masks::TimeMask<'_, S, T>,
) -> impl Iterator<Item = u32> + Clone {
    mask.frames().iter().flat_map(|mask| scalar_words(mask))
}

/// The linear light of the 256 sRGB values of 8 bits, two a word, for [`LINEAR_LIGHT`](super::LINEAR_LIGHT).
#[cfg(feature = "gamma")]
pub fn linear_light_words() -> impl Iterator<Item = u32> + Clone {
    let light = |value: u16| u32::from(crate::dither::gamma::to_linear(257 * value));
    (0..128).map(move |pair| light(2 * pair) | light(2 * pair + 1) << 16)
}

/// The swaps of seeds, two places a word, for [`SEED_SWAPS`](super::SEED_SWAPS).
#[cfg(feature = "seed-permutation")]
pub fn seed_swap_words() -> impl Iterator<Item = u32> + Clone {
    pairs(crate::tables::SEED_PERMUTATION.codes().as_flattened())
}

/// Two numbers a word; an odd last one stands alone.
fn pairs(numbers: &[u16]) -> impl Iterator<Item = u32> + Clone {
    numbers.chunks(2).map(|pair| pair.iter().rev().fold(0, |word, &number| word << 16 | u32::from(number)))
}

/// The pixels of a tile, row by row.
fn places<const S: usize>() -> impl Iterator<Item = (u32, u32)> + Clone {
    let side = 1 << S.trailing_zeros();
    (0..side * side).map(move |place| (place % side, place / side))
}
