//! sRGB and linear light, in integers: what a dithered area looks like is the mean of its *light*.
//!
//! IEC 61966-2-1. The table of 256 numbers is made by the compiler.

use super::quantise;

/// 16-bit linear light of the 8-bit sRGB values.
static LINEAR: [u16; 256] = {
    let mut table = [0; 256];
    let mut v = 0;
    while v < 256 {
        table[v] = linear_8(v as u64);
        v += 1;
    }
    table
};

/// v/12.92 to v = 10, then ((v + .055)/1.055)^2.4, of 255 and 65535.
#[expect(clippy::cast_possible_truncation, reason = "at most 65535")]
const fn linear_8(v: u64) -> u16 {
    if v <= 10 {
        // 65535/255/12.92 = 25700/1292.
        return ((v * 25700 + 646) / 1292) as u16;
    }
    // x = n/d; x^2.4 = x²·(x²)^⅕.
    let (n, d) = ((200 * v + 2805) as u128, 53_805);
    // The fifth root in 0.19 fixed point, bit by bit: z⁵·d² ≤ n²·2⁹⁵ fits 127 bits.
    let (mut z, mut bit) = (0u128, 1 << 19);
    while bit > 0 {
        let tried = z | bit;
        if tried <= 1 << 19 && tried * tried * tried * tried * tried * d * d <= (n * n) << 95 {
            z = tried;
        }
        bit >>= 1;
    }
    ((n * n * z * 65535 / (d * d) + (1 << 18)) >> 19) as u16
}

/// Linear light of an sRGB value, both 16 bits, 0 to 0 and 65535 to 65535. Monotone; exact to about one unit for the
/// values 257·v of 8 bits, and linear between them.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "between two numbers of 16 bits")]
pub const fn to_linear(srgb: u16) -> u16 {
    let (at, rest) = ((srgb / 257) as usize, (srgb % 257) as u32);
    let lower = LINEAR[at] as u32;
    let upper = LINEAR[if at < 255 { at + 1 } else { at }] as u32;
    (lower + ((upper - lower) * rest + 128) / 257) as u16
}

/// The largest sRGB value whose linear light is not above the given, both 16 bits: for renderers, whose numbers are
/// linear.
#[must_use]
pub const fn from_linear(linear: u16) -> u16 {
    let (mut srgb, mut bit) = (0, 0x8000);
    while bit > 0 {
        if to_linear(srgb | bit) <= linear {
            srgb |= bit;
        }
        bit >>= 1;
    }
    srgb
}

/// As [`quantise::level`], levels and value being sRGB, and the way between levels being measured in
/// linear light.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "65535 times a ratio up to 1, and a level")]
pub const fn level(value: u16, max: u16, levels: u16, threshold_fx: u32) -> u16 {
    let value = if value < max { value } else { max };
    let srgb = match (value as u32 * 65535 + max as u32 / 2).checked_div(max as u32) {
        Some(srgb) => srgb as u16,
        None => return 0,
    };
    let lower = quantise::level(srgb, u16::MAX, levels, u32::MAX);
    let light = to_linear(srgb) as u32;
    let below = to_linear(quantise::value(lower, u16::MAX, levels)) as u32;
    let above = to_linear(quantise::value(lower.saturating_add(1), u16::MAX, levels)) as u32;
    // Of the uppermost level and the one above, which does not exist, both are the same.
    let up = above > below && light.saturating_sub(below) > quantise::scaled(threshold_fx, above - below);
    lower + up as u16
}
