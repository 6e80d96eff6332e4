//! Numbers in [0, 1): 0.32 fixed point in a `u32`, and the only place where it becomes a float.
//!
//! All arithmetic of the crate stays in fixed point, where a sum wraps exactly and a mean is exact. Floats are made
//! last and rounded *down*, since rounding to nearest turns every value above 1 − 2⁻²⁵ into 1.0.

/// The `f32` in [0, 1) at or just below a 0.32 fixed-point number: its upper 24 bits, exactly.
///
/// Multiples of 2⁻²⁴; the largest is 1 − 2⁻²⁴. A shift, a conversion and a multiplication.
#[inline]
#[must_use]
pub const fn to_f32(value_fx: u32) -> f32 {
    // 24 bits fit the mantissa, so neither the conversion nor the scaling rounds.
    const ULP: f32 = 1.0 / (1u32 << 24) as f32;
    (value_fx >> 8) as f32 * ULP
}

/// The `f64` in [0, 1) that equals a 0.32 fixed-point number exactly.
#[inline]
#[must_use]
pub const fn to_f64(value_fx: u32) -> f64 {
    const ULP: f64 = 1.0 / (1u64 << 32) as f64;
    value_fx as f64 * ULP
}

/// The 0.32 fixed-point number of a float: clamped to [0, 1 − 2⁻³²], NaN to 0, rounded down.
///
/// For every `v`, `from_f32(to_f32(v))` is `v` with its lower 8 bits cleared.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates and drops the fraction: that is the clamp")]
pub const fn from_f32(value: f32) -> u32 {
    const ONE: f32 = (1u64 << 32) as f32;
    (value * ONE) as u32
}

/// `to_f32` of every component: `[f32; D]` in [0, 1).
#[inline]
#[must_use]
pub fn to_f32s<const D: usize>(values_fx: [u32; D]) -> [f32; D] {
    values_fx.map(to_f32)
}
