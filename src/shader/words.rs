//! The tables as words of 32 bits, the earlier of two halves in the lower 16 bits: the bytes of a little-endian machine,
//! on any host.

use crate::linear::Columns;
use crate::tables::LINEAR_ORDER;
use crate::{ScalarMask, VectorMask};

/// The constants of the linear pixel order, for [`LINEAR_ORDER`](super::LINEAR_ORDER): 912 words.
pub fn linear_order_words() -> impl Iterator<Item = u32> + Clone {
    let columns = |sets: &'static [Columns]| sets.as_flattened().iter().copied();
    let orders = columns(LINEAR_ORDER.known.as_flattened()).chain(columns(&LINEAR_ORDER.progressive));
    // The bits of a reversed index that select one entry each.
    let nibbles = (0..16).map(|sum| sum << 28).chain((0..16).map(|sum| sum << 24));
    let singles = (0..24).map(|bit| 1 << (23 - bit));
    orders.chain(nibbles.chain(singles).flat_map(|index_rev| low_high(LINEAR_ORDER.sequence.packed_rev(index_rev))))
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

/// Two numbers a word; an odd last one stands alone.
fn pairs(numbers: &[u16]) -> impl Iterator<Item = u32> + Clone {
    numbers.chunks(2).map(|pair| {
        let upper = pair.get(1).map_or(0, |&number| u32::from(number));
        pair.first().map_or(0, |&number| u32::from(number)) | upper << 16
    })
}
