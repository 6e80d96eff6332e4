//! Pixels along a Z curve, the sequence that they share, and where on it a pixel begins.
//!
//! Ahmed and Wonka 2020: all pixels share one (0, 2)-sequence and take it in turns along a Z curve, so that the points
//! of every square of 2ᵏ×2ᵏ pixels are a net together and their errors cancel. Consecutive pixels take consecutive runs
//! there, which needs the number of samples beforehand. Here a pixel begins at an index from which that holds for
//! *every* number 2ᵐ of samples.
//!
//! The sequence is Sobol's with digits scrambled by a matrix (Matoušek 1998) that a few shifts and masks make: annealed
//! for little error of half-planes and smooth integrands, in a pixel and in squares of them.

use crate::sobol;

/// The Z curve (Morton 1966): bit k of `x` is bit 2k of the code, bit k of `y` bit 2k+1.
#[inline]
#[must_use]
pub const fn morton(x: u32, y: u32) -> u64 {
    morton_16(x, y) as u64 | (morton_16(x >> 16, y >> 16) as u64) << 32
}

/// The lower half of the code, from the lower 16 bits of both. Both are spread in one word.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "32 bits are left")]
pub const fn morton_16(x: u32, y: u32) -> u32 {
    let mut n = (x & 0xffff) as u64 | ((y & 0xffff) as u64) << 32;
    n = (n | n << 8) & 0x00ff_00ff_00ff_00ff;
    n = (n | n << 4) & 0x0f0f_0f0f_0f0f_0f0f;
    n = (n | n << 2) & 0x3333_3333_3333_3333;
    n = (n | n << 1) & 0x5555_5555_5555_5555;
    (n | n >> 31) as u32
}

/// Where place `place_rev`, bit-reversed, of a Z curve begins: its sample i is [`point`] `first_index ^ i`.
///
/// A bijection. For every m and k with m + 2k ≤ 16, the first 2ᵐ samples of 4ᵏ places in a row, from a multiple of 4ᵏ on,
/// are a (0, m+2k, 2)-net together; beyond, too, but for cells narrower than 2⁻¹⁶.
///
/// Read an index as a polynomial over GF(2), bit j for tʲ: then the two coordinates of its Sobol point are its power
/// series at t = 0 and at t = 1, and nets are sets of all polynomials below some degree. With q = t² + t + 1, which
/// has an inverse at both, the base-4 digits a of a place are taken as Σ aₖ/qᵏ⁺¹, k = 0 for the last: with the
/// numerators tʲ of the samples that spans all polynomials below degree m + 2k over qᵏ. And since q¹⁶ = t³² + t¹⁶ + 1
/// is 1 up to digit 16, Σ aₖ·q¹⁵⁻ᵏ does as well, which is a polynomial: four steps from the base q to the base t.
#[inline]
#[must_use]
pub const fn first_index(place_rev: u32) -> u32 {
    // b·qᵏ = b·t²ᵏ + b·tᵏ + b, in place, for k = 1, 2, 4, 8.
    let mut n = place_rev;
    let b = n & 0xcccc_cccc;
    n ^= b >> 1 ^ b >> 2;
    let b = n & 0xf0f0_f0f0;
    n ^= b >> 2 ^ b >> 4;
    let b = n & 0xff00_ff00;
    n ^= b >> 4 ^ b >> 8;
    let b = n & 0xffff_0000;
    n ^ b >> 8 ^ b >> 16
}

/// Point `index` of the sequence that pixels share: 0.32 fixed point. Linear: the point of `a ^ b` is that of `a` XOR
/// that of `b`, and every aligned run of 2ᵐ points is a (0, m, 2)-net. A bit reversal and some thirty operations, no
/// look-up and no product.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "halves of a word")]
pub const fn point(index: u32) -> [u32; 2] {
    let word = packed_rev(index.reverse_bits());
    [(word >> 32) as u32, word as u32]
}

/// [`point`] of a bit-reversed index, both numbers in one word, the first in the upper half.
#[inline]
pub(crate) const fn packed_rev(index_rev: u32) -> u64 {
    // A reversed index is the first number.
    let mut word = (index_rev as u64) << 32 | sobol::second(index_rev) as u64;
    // To digits are added some of the digits above them. No word has a bit that a digit of the other number would reach.
    word ^= (word >> 1) & SCRAMBLE[0];
    word ^= (word >> 2) & SCRAMBLE[1];
    word ^= (word >> 4) & SCRAMBLE[2];
    word ^ (word >> 8) & SCRAMBLE[3]
}

/// Which digits take one from 1, 2, 4 and 8 above, of the first number in the upper half. Found by `src/bake/columns/scramble.rs`;
/// the last six digits are as they fell.
const SCRAMBLE: [u64; 4] = [0x53be_4322_298a_f328, 0x2ff4_b33a_17ef_c464, 0x03ff_e2f7_099f_e007, 0x00a5_ffec_00ed_ffd3];
