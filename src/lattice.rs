//! Rank-1 lattices and R-sequences: one multiplication a dimension, in integers.
//!
//! Point i of a lattice of N points has the coordinates frac(i·z/N), z the generating vector (Korobov 1959). Taken as
//! frac(φ(i)·z), φ the van der Corput sequence, every 2ᵏ first points are a lattice (Hickernell, Hong, L'Ecuyer and
//! Lemieux 2000). Shift them as a whole, modulo 1, for error estimates or a pixel's own points. All values are 0.32
//! fixed point: in `f32` such a product has some five bits of fraction left.
//!
//! A 2-D lattice with the largest least distance between points is best for showing a picture of samples, not for
//! integration; [`FIBONACCI`] is close to it in both.

/// Frank Kuo's `exew_base2_m20_a3_HKKN`: extensible to 2²⁰ points, order 3 Korobov space, 10 dimensions (Hickernell,
/// Kritzer, Kuo and Nuyens 2012). The one in the released code of Belcour and Heitz 2021.
pub const EXEW: [u32; 10] = [1, 364_981, 245_389, 97_823, 488_939, 62_609, 400_749, 385_317, 21_281, 223_487];

/// Fibonacci numbers F₂ to F₄₇, which is the last below 2³². The 2-D lattice of N = Fₖ points with z = (1, Fₖ₋₁)
/// leaves the least error of its size in the Korobov space of order 2 (tested up to 233 points).
pub const FIBONACCI: [u32; 46] = fibonacci();

/// Coordinate ⌊2³²·frac(i·z/N)⌋ of point `index` of a lattice of `count` points: exact for every N. A 64-bit remainder
/// and a division; both are shifts when N is known and a power of two. `count` 0 counts as 1.
#[inline]
#[must_use]
pub const fn fixed(index: u32, z: u32, count: u32) -> u32 {
    let count = if count == 0 { 1 } else { count as u64 };
    let remainder = index as u64 * z as u64 % count;
    low_word((remainder << 32) / count)
}

/// Coordinate frac(φ(i)·z) of point `index` of an extensible lattice, z odd. A bit reversal and a multiplication.
///
/// Every run of 2ᵏ points from a multiple of 2ᵏ on hits each interval of 2⁻ᵏ once.
#[inline]
#[must_use]
pub const fn extensible(index: u32, z: u32) -> u32 {
    index.reverse_bits().wrapping_mul(z)
}

/// The first two coordinates by [`EXEW`], frac(φ·z), of the point whose φ(i) is `phi`: the bit-reversed index.
#[inline]
#[must_use]
pub(crate) const fn multiples(phi: u32) -> [u32; 2] {
    [phi.wrapping_mul(EXEW[0]), phi.wrapping_mul(EXEW[1])]
}

/// Increments of the R-sequence in D dimensions, D = 1..4 in row D−1: 2³²·φ⁻ʲ rounded to odd, for φ^(D+1) = φ + 1.
///
/// M. Roberts 2018. An odd increment visits all 2³² values before one comes again. D = 1 is the golden ratio.
pub const R: [[u32; 4]; 4] = [
    [0x9e37_79b9, 0, 0, 0],
    [0xc13f_a9a9, 0x91e1_0da5, 0, 0],
    [0xd1b5_4a33, 0xabc9_8389, 0x8cb9_2ba7, 0],
    [0xdb4f_0b91, 0xbbe0_5633, 0xa0f2_ec75, 0x89e1_8285],
];

/// The same in 64 bits, for more than some 10⁵ points: the 32-bit ones drift by up to 1.9·10⁻¹⁰ a point.
pub const R_64: [[u64; 4]; 4] = [
    [0x9e37_79b9_7f4a_7c15, 0, 0, 0],
    [0xc13f_a9a9_02a6_328f, 0x91e1_0da5_c79e_7b1d, 0, 0],
    [0xd1b5_4a32_d192_ed03, 0xabc9_8388_fb8f_ac03, 0x8cb9_2ba7_2f3d_8dd7, 0],
    [0xdb4f_0b91_75ae_2165, 0xbbe0_5633_03a4_615f, 0xa0f2_ec75_a1fe_1575, 0x89e1_8285_7d9e_d689],
];

/// Point `index` of the R-sequence in D = 1..4 dimensions, from one half on: a multiplication a dimension.
#[inline]
#[must_use]
pub const fn r<const D: usize>(index: u32) -> [u32; D] {
    const { assert!(D >= 1 && D <= 4, "increments are given for 1 to 4 dimensions") };
    let mut point = [0; D];
    let mut k = 0;
    while k < D {
        point[k] = index.wrapping_mul(R[D - 1][k]).wrapping_add(1 << 31);
        k += 1;
    }
    point
}

/// The same with 64 bits of index and value.
#[inline]
#[must_use]
pub const fn r_64<const D: usize>(index: u64) -> [u64; D] {
    const { assert!(D >= 1 && D <= 4, "increments are given for 1 to 4 dimensions") };
    let mut point = [0; D];
    let mut k = 0;
    while k < D {
        point[k] = index.wrapping_mul(R_64[D - 1][k]).wrapping_add(1 << 63);
        k += 1;
    }
    point
}

const fn fibonacci() -> [u32; 46] {
    let mut all = [1; 46];
    all[1] = 2;
    let mut k = 2;
    while k < 46 {
        all[k] = all[k - 1] + all[k - 2];
        k += 1;
    }
    all
}

#[expect(clippy::cast_possible_truncation, reason = "callers divide a number below count·2³² by count")]
const fn low_word(value: u64) -> u32 {
    value as u32
}
