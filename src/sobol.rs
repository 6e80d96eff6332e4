//! The first four dimensions of the Sobol sequence (Sobol 1967; direction numbers of Joe and Kuo 2008).
//!
//! The first two form a (0, 2)-sequence in base 2: 2ᵐ consecutive points from a multiple of 2ᵐ on lie one in each
//! elementary interval of area 2⁻ᵐ. They are computed; the others use direction numbers, those from the fifth on the
//! ones of a table ([`Directions`]).

/// Point `index` of dimension 0, the van der Corput sequence: 0.32 fixed point. One bit reversal.
#[inline]
#[must_use]
pub const fn dimension_0(index: u32) -> u32 {
    index.reverse_bits()
}

/// Point `index` of dimension 1, whose generator is Pascal's triangle modulo 2: 0.32 fixed point.
///
/// Digit r is the sum of C(c, r)·bit c of the index, odd exactly where r is a subset of c (Lucas), so five
/// butterflies over the bits do it without a table (the idea of Ahmed 2024).
#[inline]
#[must_use]
pub const fn dimension_1(index: u32) -> u32 {
    second(dimension_0(index))
}

/// The second number of the point of the first two dimensions whose first number is `first`.
#[inline]
pub(crate) const fn second(first: u32) -> u32 {
    let mut n = first;
    n ^= (n << 1) & 0xaaaa_aaaa;
    n ^= (n << 2) & 0xcccc_cccc;
    n ^= (n << 4) & 0xf0f0_f0f0;
    n ^= (n << 8) & 0xff00_ff00;
    n ^ (n << 16)
}

/// [`dimension_1`], bit-reversed, by the same butterflies the other way round: what
/// [`laine_karras`](crate::hash::laine_karras) scrambles.
#[inline]
#[must_use]
pub const fn dimension_1_rev(index: u32) -> u32 {
    let mut n = index;
    n ^= (n >> 1) & 0x5555_5555;
    n ^= (n >> 2) & 0x3333_3333;
    n ^= (n >> 4) & 0x0f0f_0f0f;
    n ^= (n >> 8) & 0x00ff_00ff;
    n ^ (n >> 16)
}

/// Point `index` of the (0, 2)-sequence of the first two dimensions: 0.32 fixed point.
#[inline]
#[must_use]
pub const fn point(index: u32) -> [u32; 2] {
    [dimension_0(index), dimension_1(index)]
}

/// Point `index` of dimension `dimension` modulo 4: 0.32 fixed point. Up to 32 conditional XORs; for set-up code.
#[must_use]
pub const fn dimension(index: u32, dimension: u32) -> u32 {
    match dimension % 4 {
        0 => dimension_0(index),
        1 => dimension_1(index),
        2 => combine(index, &DIRECTIONS_2),
        _ => combine(index, &DIRECTIONS_3),
    }
}

/// A pixel's own Owen-scrambled point: `point` with one independent scramble a dimension.
#[inline]
#[must_use]
pub const fn owen_point(index: u32, seed: u32) -> [u32; 2] {
    // Laine–Karras works on reversed bits and a Sobol point is a reversed number: the two reversals cancel.
    [
        crate::hash::laine_karras(index, crate::hash::mix(seed)).reverse_bits(),
        crate::hash::laine_karras(dimension_1_rev(index), crate::hash::mix(seed ^ 0x94d0_49bb)).reverse_bits(),
    ]
}

/// Direction numbers of dimensions of the Sobol sequence: 128 bytes each. Those of the features `sobol-16` to
/// `sobol-1024` stand in [`tables`](crate::tables); [`directions`] makes others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Directions<const D: usize> {
    numbers: [[u32; 32]; D],
}

impl<const D: usize> Directions<D> {
    /// Number `bit` of dimension `d` is `numbers[d][bit]`, as [`directions`] returns them. D = 0 is a compile error.
    #[must_use]
    pub const fn new(numbers: [[u32; 32]; D]) -> Self {
        const { assert!(D > 0, "a table has one dimension at least") };
        Self { numbers }
    }

    /// Point `index` of dimension `dimension` modulo D: 0.32 fixed point. A conditional step per set bit of the index.
    ///
    /// As they are, the higher dimensions are poorly spread in pairs over the first points: take [`owen`](Self::owen).
    #[inline]
    #[must_use]
    pub const fn dimension(&self, index: u32, dimension: u32) -> u32 {
        combine(index, &self.numbers[dimension as usize % D])
    }

    /// The same, Owen-scrambled: seed and dimension choose the scramble.
    ///
    /// From dimension D on the dimensions come again, each time in an order of the samples and a scramble of their own
    /// (padding), so that the first 2ᵏ samples stay as even in each of them; between them they are as independent ones.
    #[inline]
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "D ≥ 2³² has no numbers")]
    pub const fn owen(&self, index: u32, dimension: u32, seed: u32) -> u32 {
        let round = dimension / D as u32;
        let index = if round == 0 { index } else { crate::hash::shuffle(index, crate::hash::combine(seed, round)) };
        let scramble = crate::hash::combine(seed, crate::hash::mix(dimension));
        crate::hash::owen(self.dimension(index, dimension), scramble)
    }
}

static DIRECTIONS_2: [u32; 32] = directions(1, &[1, 3]);
static DIRECTIONS_3: [u32; 32] = directions(1, &[1, 3, 1]);

/// The sum of the direction numbers of the set bits.
const fn combine(index: u32, directions: &[u32; 32]) -> u32 {
    let mut sum = 0;
    let mut rest = index;
    while rest != 0 {
        sum ^= directions[(rest.trailing_zeros() & 31) as usize];
        rest &= rest - 1;
    }
    sum
}

/// Direction numbers from the initial ones, `m`, and the inner coefficients `a` of a primitive polynomial of degree
/// `m.len()` (at most 32 are read), in the notation of Joe and Kuo 2008.
#[must_use]
pub const fn directions(a: u32, m: &[u32]) -> [u32; 32] {
    let s = if m.len() < 32 { m.len() } else { 32 };
    let mut v = [0u32; 32];
    let mut k = 0;
    while k < 32 {
        v[k] = if k < s {
            m[k] << (31 - k)
        } else {
            // Inside anyway: the masks leave no check that could panic.
            let mut next = v[(k - s) & 31] ^ (v[(k - s) & 31] >> s);
            let mut j = 1;
            while j < s {
                next ^= (a >> (s - 1 - j) & 1) * v[(k - j) & 31];
                j += 1;
            }
            next
        };
        k += 1;
    }
    v
}
