//! A (0, 2)-sequence in base 2: the points of [`Keyed`](crate::Keyed).
//!
//! Every aligned run of 2ᵐ points is a (0, m, 2)-net: each of the 2ᵐ equal rectangles of any one shape has one point of
//! it. The binary digits of a point are sums modulo 2 of *columns*, one for every bit that is set in the index. So
//! point i ⊕ k is point i ⊕ point k, and scrambling by XOR with a point is a change of the order.
//!
//! [`SEQUENCE`](crate::tables::SEQUENCE) is Sobol's with matrix-scrambled digits (Matoušek 1998), chosen so that few
//! Walsh functions of smooth integrands are left over, which is the idea of higher-order nets (Dick 2008): from 8
//! samples on the error is below that of Owen-scrambled points. It is frozen in `tables/sequence.txt`.

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

    /// Point `index`, 0.32 fixed point, both numbers in one word, the first in the upper half. Two look-ups, and one
    /// for every further bit that is set.
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
