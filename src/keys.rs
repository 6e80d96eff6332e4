//! Scrambling and ranking keys: a tile that tells every pixel how to scramble one sequence for all and where to start
//! it (Heitz, Belcour, Ostromoukhov, Coeurjolly and Iehl 2019).
//!
//! A pixel's sample i is point i ⊕ rank of the sequence, ⊕ its key. XOR with a key maps every elementary interval onto
//! one of the same size, so that each pixel keeps a net at every power of two. Here point i ⊕ r of the
//! [sequence](crate::sequence) is point i ⊕ point r, so that a rank is a change of the key, and keys are all there is.

use crate::torus;

/// The upper 16 digits of two keys a pixel, 4·S² bytes. S is a power of two up to 256.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Keys<const S: usize> {
    /// The first number's in the upper half.
    digits: [[u32; S]; S],
}

impl<const S: usize> Keys<S> {
    /// log₂ of the side.
    pub const SIZE_LOG2: u32 = {
        assert!(S.is_power_of_two() && S <= 256, "the side of a table of keys is a power of two up to 256");
        S.trailing_zeros()
    };

    /// A table of your own, `digits[y][x]`.
    #[must_use]
    pub const fn new(digits: [[[u16; 2]; S]; S]) -> Self {
        // Evaluated for every size in use, so that a wrong size does not compile.
        let _ = Self::SIZE_LOG2;
        let mut packed = [[0; S]; S];
        let mut y = 0;
        while y < S {
            let mut x = 0;
            while x < S {
                packed[y][x] = (digits[y][x][0] as u32) << 16 | digits[y][x][1] as u32;
                x += 1;
            }
            y += 1;
        }
        Self { digits: packed }
    }

    /// A table of your own, row by row: none if there are not S² of them. It is made on the stack.
    #[must_use]
    pub fn from_slice(digits: &[[u16; 2]]) -> Option<Self> {
        if digits.len() != S * S {
            return None;
        }
        let mut rows = [[[0; 2]; S]; S];
        rows.as_flattened_mut().copy_from_slice(digits);
        Some(Self::new(rows))
    }

    /// The keys of a pixel, 0.32 fixed point; the lower 16 digits are 0. Any coordinate; an `i32` is passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn key(&self, x: u32, y: u32) -> [u32; 2] {
        let digits = self.digits(x, y);
        [digits & 0xffff_0000, digits << 16]
    }

    #[inline]
    pub(crate) const fn digits(&self, x: u32, y: u32) -> u32 {
        let size = 1 << Self::SIZE_LOG2;
        self.digits[torus::wrap(y, size) as usize][torus::wrap(x, size) as usize]
    }
}
