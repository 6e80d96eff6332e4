//! The linear pixel order: one digital net for the whole picture, linear in the sample's number and in the pixel's
//! coordinates.
//!
//! As in the Z order (Ahmed and Wonka 2020) all pixels share one sequence, so that neighbours complete each other. But
//! here the binary digits of a point are sums modulo 2 of *columns*, one for every bit that is set in the index and one
//! for every bit that is set in the coordinates inside a block of 32×32 pixels, and of a random digital shift per block.
//!
//! Then everything is known beforehand. The error of an estimate is a sum over the Walsh functions that the points of a
//! pixel do not integrate (the dual net); over the pixels of a block each is again a Walsh function, of a frequency that
//! the columns say. So the error after a filter, in the mean over shifts, is a plain sum of products, and the columns are
//! annealed for the least of it: see `src/bake/columns`.
//!
//! Every pixel has a (0, m, 2)-net for every power of two, since a shifted net is one. The sequence is Sobol's with
//! matrix-scrambled digits (Matoušek 1998), chosen so that few Walsh functions of smooth integrands are left over, which
//! is the idea of higher-order nets (Dick 2008): from 8 samples on the error is below that of Owen-scrambled points.

/// log₂ of the side of a block, pixels.
pub const BLOCK_LOG2: u32 = 5;

/// What the coordinates add: for bit 0 of x, bit 0 of y, bit 1 of x, …, the upper 16 digits of the first number (upper
/// half) and of the second.
pub type Columns = [u32; 2 * BLOCK_LOG2 as usize];

/// How many sets of columns there are for a number of samples.
pub const SETS: usize = 8;

/// Sets of columns that blocks choose from at random, which keeps a picture from showing them.
pub type Order = [Columns; SETS];

/// Numbers of samples that have an order: 1, 2, 4, …, 256, and any.
pub const ORDERS: usize = 10;

/// All constants of the linear pixel order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tables {
    /// For 2ᵏ samples a pixel.
    pub known: [Order; ORDERS - 1],
    /// For any number of samples.
    pub progressive: Order,
    /// The points.
    pub sequence: Sequence,
}

impl Tables {
    /// The order made for `spp` samples a pixel, 0 counting as 1: powers of two up to 256 have one.
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
            128 => Some(&self.known[7]),
            256 => Some(&self.known[8]),
            _ => None,
        }
    }
}

/// A (0, 2)-sequence in base 2 by its columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sequence {
    /// The sums for the two lower nibbles of an index, each reversed: the first number is the upper half.
    nibbles: [[u64; 16]; 2],
    /// The columns of the other bits.
    columns: [u64; 24],
}

impl Sequence {
    /// Of one column of digits for each dimension and bit of the index.
    #[must_use]
    pub const fn new(columns: &[[u32; 2]; 32]) -> Self {
        let mut sequence = Self { nibbles: [[0; 16]; 2], columns: [0; 24] };
        let mut bit = 0;
        while bit < 32 {
            let column = (columns[bit][0] as u64) << 32 | columns[bit][1] as u64;
            if bit < 8 {
                let mut sum = 0;
                while sum < 16 {
                    if sum >> (3 - bit % 4) & 1 == 1 {
                        sequence.nibbles[bit / 4][sum] ^= column;
                    }
                    sum += 1;
                }
            } else {
                sequence.columns[bit - 8] = column;
            }
            bit += 1;
        }
        sequence
    }

    /// Point `index`, 0.32 fixed point, both numbers in one word, the first in the upper half. Two look-ups, and one for
    /// every further bit that is set.
    #[inline]
    #[must_use]
    pub const fn packed(&self, index: u32) -> u64 {
        self.packed_rev(index.reverse_bits())
    }

    /// The same, of a bit-reversed index.
    #[inline]
    #[must_use]
    pub const fn packed_rev(&self, index_rev: u32) -> u64 {
        let sum = self.nibbles[0][(index_rev >> 28) as usize] ^ self.nibbles[1][(index_rev >> 24 & 15) as usize];
        if index_rev << 8 == 0 { sum } else { sum ^ self.rest(index_rev << 8) }
    }

    /// The sum for the bits above the eighth. Not inline, so that what is called for most numbers of samples is.
    #[inline(never)]
    const fn rest(&self, rest_rev: u32) -> u64 {
        let mut rest = rest_rev;
        let mut sum = 0;
        let mut bit = 0;
        while rest != 0 && bit < 24 {
            if rest >> 31 == 1 {
                sum ^= self.columns[bit];
            }
            rest <<= 1;
            bit += 1;
        }
        sum
    }
}

/// The digits that a pixel at (`x`, `y`) in its block adds to all its points: the upper 16 of the first number in the
/// upper half, of the second in the lower half. Only the lower 5 bits of the coordinates count. Some thirty operations,
/// four columns at a time where a processor can.
#[inline]
#[must_use]
pub const fn digits(columns: &Columns, x: u32, y: u32) -> u32 {
    let place = y << 16 | x & 0xffff;
    let mut sum = 0;
    let mut k = 0;
    while k < columns.len() {
        let bit = 1 << (k / 2 + k % 2 * 16);
        sum ^= if place & bit == bit { columns[k] } else { 0 };
        k += 1;
    }
    sum
}
