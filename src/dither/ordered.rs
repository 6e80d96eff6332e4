//! Ordered dither: Bayer's recursive matrix (B. Bayer 1973), any power of two on a side, without a table.

use crate::zorder;

/// The largest matrix, as log₂ of its side: the centres of its 2³⁰ cells just fit 0.32 fixed point.
pub const MAX_LOG2: u32 = 15;

/// The threshold at a pixel in 0.32 fixed point, the centre of its rank's cell; a `size_log2` beyond [`MAX_LOG2`]
/// counts as that.
///
/// The matrix of twice the side is 4·M + {0, 2; 3, 1}: the lowest bits of the coordinates weigh most. Bit by bit
/// that is the Z curve of (x ⊕ y, y), read backwards.
#[inline]
#[must_use]
pub const fn value_fx(x: u32, y: u32, size_log2: u32) -> u32 {
    let size_log2 = if size_log2 < MAX_LOG2 { size_log2 } else { MAX_LOG2 };
    let rank_rev = zorder::morton_16(x ^ y, y);
    let half = 0x8000_0000u32 >> (2 * size_log2);
    rank_rev.reverse_bits() & (half << 1).wrapping_neg() | half
}
