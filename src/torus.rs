//! Toroidal addressing: a tile repeats without a seam, and is read at a place that depends on seed, domain and frame.

/// A coordinate inside a tile of `size` pixels, `size` a power of two: right for every `u32`, and for negative `i32`
/// coordinates passed `as u32`.
#[inline]
#[must_use]
pub const fn wrap(coordinate: u32, size: u32) -> u32 {
    coordinate & (size - 1)
}

/// How far one number of a tile of 2^`size_log2` pixels must be read from the pixel itself: pixels in x and y.
///
/// Different domains and frames read the same tile at different places. Moving the *place* keeps a tile's spectrum
/// exactly; adding a constant to its *values* does not (half of the blueness is gone). Successive domains step along
/// the R2 sequence (M. Roberts 2018), successive frames along the same one turned by a right angle, so that 100 of
/// either stay several pixels of a 64² tile apart. `size_log2` above 32 counts as 32.
#[inline]
#[must_use]
pub const fn offset(seed: u32, domain: u32, frame: u32, size_log2: u32) -> [u32; 2] {
    // 2³²/φ and 2³²/φ² for φ³ = φ + 1, rounded to odd.
    const R2: [u32; 2] = [0xc13f_a9a9, 0x91e1_0da5];
    let start = crate::hash::mix(seed);
    let x = start.wrapping_add(domain.wrapping_mul(R2[0])).wrapping_add(frame.wrapping_mul(R2[1]));
    let y = crate::hash::mix(start).wrapping_add(domain.wrapping_mul(R2[1])).wrapping_sub(frame.wrapping_mul(R2[0]));
    [upper_bits(x, size_log2), upper_bits(y, size_log2)]
}

/// The place in the tile is in the upper bits: low-discrepancy sequences are even there.
const fn upper_bits(value: u32, count: u32) -> u32 {
    match value.checked_shr(32u32.saturating_sub(count)) {
        Some(bits) => bits,
        None => 0, // a tile of one pixel
    }
}
