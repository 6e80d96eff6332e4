//! The joint net: eight numbers of one digital net for the whole picture, linear in the sample's number and in the
//! place of the pixel.
//!
//! As in the Z order (Ahmed and Wonka 2020) all pixels share one sequence along a Z curve whose squares are shuffled,
//! so that neighbours complete each other. A point's binary digits are sums modulo 2 of *columns*: one for every bit
//! that is set in the sample's number, one for every bit of the pixel's place inside a block of 4×4, and one for every
//! bit of the block's place on the curve up to 32×32 pixels; there is a random digital shift above. All eight numbers
//! have their columns in common, so that the error of an integrand of several of them is blue, too. The lowest two
//! levels of the curve are shuffled in eight ways only, which puts the strongest Walsh functions on those of a block
//! that a filter takes away.
//!
//! Columns are found by annealing the predicted error after a filter: see `tests/search`. Components 2k and 2k+1 are
//! an own pair, of which every aligned run of 2ᵐ samples is a (0, m, 2)-net in every pixel.

/// 16 digits of each of the eight numbers: of number 2k in the upper half of word k, of number 2k+1 in the lower half.
pub type Digits = [u32; 4];

/// Digits of a number, and bits of a sample's number that have a column: two numbers a word, eight in 128 bits.
pub const DIGITS: u32 = 16;
/// Bits of a pixel's place inside a block of 4×4: two of x, two of y.
pub const INSIDE: usize = 4;
/// Bits of a block's place on the curve that have a column: squares of 8×8, 16×16 and 32×32 pixels.
pub const PLACE: usize = 6;
/// Bits of a frame that have a column of their own where the number of samples is not known: five digits in base 8, of
/// which every number of frames is a net (see `tests/search`).
pub const FRAMES: usize = 15;

/// All columns for a number of samples. 416 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Order {
    /// For every bit of a sample's number.
    pub samples: [Digits; DIGITS as usize],
    /// For bits 0 and 1 of x, then of y.
    pub inside: [Digits; INSIDE],
    /// For every bit of the place on the curve, of the smallest squares first.
    pub place: [Digits; PLACE],
}

/// Numbers of samples that have an order: 1, 2, 4, …, 64, 256, and any. All that fit into 4 KiB: 128 has none.
pub const ORDERS: usize = 9;

/// All constants of the joint net.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tables {
    /// For 1, 2, 4, 8, 16, 32, 64 and 256 samples a pixel.
    pub known: [Order; ORDERS - 1],
    /// For any number of samples.
    pub progressive: Order,
    /// For every bit of a frame, where the number of samples is not known.
    pub frames: [Digits; FRAMES],
}

impl Tables {
    /// The order made for `spp` samples a pixel, 0 counting as 1: 128 and what is no power of two up to 256 has none.
    #[inline]
    #[must_use]
    pub const fn known(&self, spp: u32) -> Option<&Order> {
        match spp {
            0 | 1 => Some(&self.known[0]),
            2 => Some(&self.known[1]),
            4 => Some(&self.known[2]),
            8 => Some(&self.known[3]),
            16 => Some(&self.known[4]),
            32 => Some(&self.known[5]),
            64 => Some(&self.known[6]),
            256 => Some(&self.known[7]),
            _ => None,
        }
    }
}

/// The sum modulo 2 of two sets of digits.
#[inline(always)]
#[must_use]
pub const fn add(a: Digits, b: Digits) -> Digits {
    [a[0] ^ b[0], a[1] ^ b[1], a[2] ^ b[2], a[3] ^ b[3]]
}

/// `sum` and the columns of all bits that are set in `bits`, of which only as many count as there are columns. Six
/// operations a column, or two where a processor has vectors of four.
#[inline(always)]
#[must_use]
pub const fn add_columns<const N: usize>(sum: Digits, columns: &[Digits; N], bits: u32) -> Digits {
    let mut sum = sum;
    let mut k = 0;
    while k < N {
        // All ones where the bit is set: no branch, and vectors of four.
        let mask = 0u32.wrapping_sub(bits >> k & 1);
        let column = columns[k];
        sum = add(sum, [column[0] & mask, column[1] & mask, column[2] & mask, column[3] & mask]);
        k += 1;
    }
    sum
}
