//! Toroidal addressing: a tile repeats without a seam, and is read at a place that depends on seed, domain and frame.

/// A coordinate inside a tile of `size` pixels, `size` a power of two: right for every `u32`, and for negative `i32`
/// coordinates passed `as u32`.
#[inline]
#[must_use]
pub const fn wrap(coordinate: u32, size: u32) -> u32 {
    coordinate & (size - 1)
}

/// How far from the pixel itself a tile of 2^`size_log2` squared pixels is read: pixels in x and y.
///
/// Different domains, pairs and frames read the same tile at different places. Moving the *place* keeps a tile's
/// spectrum exactly; adding a constant to its *values* does not (half of the blueness is gone). Successive domains step
/// along the R2 sequence (M. Roberts 2018), and 100 of them, as 100 frames, stay 4 pixels or more of a 64² tile apart;
/// so do all of 16 domains in 4 frames, 8 in 8 and 4 in 16, and, 2 pixels or more, the four pairs (`pad` = 0..3) of
/// each of these and of 32 domains in one frame. Number domains 0, 1, 2, …: two large unrelated numbers may meet, with
/// a chance of one in the tile's pixels. `size_log2` above 32 counts as 32.
#[inline(always)]
#[must_use]
pub const fn offset(seed: u32, domain: u32, pad: u32, frame: u32, size_log2: u32) -> [u32; 2] {
    // Multiples of 2⁻³². 1/φ and 1/φ² for φ³ = φ + 1, rounded to odd; the others by a search for the largest least
    // distance. (The R2 step turned by a right angle puts domain 7 of frame 0 beside domain 0 of frame 4.) Places of a
    // tile correlate by chance, of 64² ones by 1/64: of a thousand steps between frames as far apart as this one, it is
    // the one by which 4 to 64 frames of the masks average best.
    const DOMAIN: [u32; 2] = [0xc13f_a9a9, 0x91e1_0da5];
    const FRAME: [u32; 2] = [0x2780_e141, 0xbc21_8b0d];
    const PAD: [u32; 2] = [0x7041_6dd8, 0x247e_9a23];
    let start = crate::hash::mix(seed);
    let starts = [start, crate::hash::mix(start)];
    let mut place = [0; 2];
    let mut axis = 0;
    while axis < 2 {
        let steps = domain
            .wrapping_mul(DOMAIN[axis])
            .wrapping_add(frame.wrapping_mul(FRAME[axis]))
            .wrapping_add(pad.wrapping_mul(PAD[axis]));
        place[axis] = upper_bits(starts[axis].wrapping_add(steps), size_log2);
        axis += 1;
    }
    place
}

/// The place in the tile is in the upper bits: low-discrepancy sequences are even there.
const fn upper_bits(value: u32, count: u32) -> u32 {
    match value.checked_shr(32u32.saturating_sub(count)) {
        Some(bits) => bits,
        None => 0, // a tile of one pixel
    }
}
