//! Masks: square tiles of ranks, looked up toroidally.
//!
//! A mask of S×S pixels holds ranks 0..S²−1. Rank r stands for the centre of its cell, (r + ½)/S², so that the mean
//! over a mask is ½ exactly and no value is 0 or 1. A look-up is two ANDs and one load: S is a power of two known to
//! the compiler, which leaves no bounds check and no branch.

use crate::{torus, unit};

/// The 0.32 value of a rank in a mask of 2^`size_log2` squared pixels: the centre of its cell.
#[inline]
pub(crate) const fn value_fx(rank: u16, size_log2: u32) -> u32 {
    (2 * rank as u32 + 1) << (31 - 2 * size_log2)
}

/// One number a pixel: thresholds, or offsets in one dimension. S is a power of two up to 256.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScalarMask<const S: usize> {
    ranks: [[u16; S]; S],
}

impl<const S: usize> ScalarMask<S> {
    /// log₂ of the side.
    pub const SIZE_LOG2: u32 = size_log2(S);

    /// A mask of your own, `ranks[y][x]`, each of 0..S²−1 once.
    #[must_use]
    pub const fn new(ranks: [[u16; S]; S]) -> Self {
        // Evaluated for every size in use, so that a wrong size does not compile.
        let _ = Self::SIZE_LOG2;
        Self { ranks }
    }

    /// A mask of your own, row by row: none if there are not S² ranks or one is S² or more. That each occurs once is
    /// not checked; the exact mean of ½ depends on it. The mask is made on the stack: 2·S² bytes.
    #[must_use]
    pub fn from_slice(ranks: &[u16]) -> Option<Self> {
        if ranks.len() != S * S || ranks.iter().any(|&rank| usize::from(rank) >= S * S) {
            return None;
        }
        let mut rows = [[0; S]; S];
        rows.as_flattened_mut().copy_from_slice(ranks);
        Some(Self::new(rows))
    }

    /// The rank at a pixel, 0..S²−1. Any coordinate; an `i32` is passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn rank(&self, x: u32, y: u32) -> u16 {
        let size = 1 << Self::SIZE_LOG2;
        self.ranks[torus::wrap(y, size) as usize][torus::wrap(x, size) as usize]
    }

    /// The value at a pixel in 0.32 fixed point.
    #[inline]
    #[must_use]
    pub const fn value_fx(&self, x: u32, y: u32) -> u32 {
        value_fx(self.rank(x, y), Self::SIZE_LOG2)
    }

    /// The value at a pixel, in (0, 1).
    #[inline]
    #[must_use]
    pub const fn value(&self, x: u32, y: u32) -> f32 {
        unit::to_f32(self.value_fx(x, y))
    }

    /// All ranks, row by row.
    #[inline]
    #[must_use]
    pub const fn ranks(&self) -> &[[u16; S]; S] {
        &self.ranks
    }

    /// The table as it lies in memory, 2·S² bytes (little-endian on little-endian machines): for uploads.
    #[cfg(feature = "bytemuck")]
    #[inline]
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        bytemuck::bytes_of(&self.ranks)
    }
}

/// D numbers a pixel, swapped as whole vectors when it was optimised: offsets in D dimensions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VectorMask<const D: usize, const S: usize> {
    ranks: [[[u16; D]; S]; S],
}

impl<const D: usize, const S: usize> VectorMask<D, S> {
    /// log₂ of the side.
    pub const SIZE_LOG2: u32 = size_log2(S);

    /// A mask of your own, `ranks[y][x][channel]`, in each channel each of 0..S²−1 once.
    #[must_use]
    pub const fn new(ranks: [[[u16; D]; S]; S]) -> Self {
        let _ = Self::SIZE_LOG2;
        Self { ranks }
    }

    /// A mask of your own, row by row: none if there are not S² vectors or a rank is S² or more. That each occurs once
    /// in each channel is not checked. The mask is made on the stack: 2·D·S² bytes.
    #[must_use]
    pub fn from_slice(ranks: &[[u16; D]]) -> Option<Self> {
        if ranks.len() != S * S || ranks.as_flattened().iter().any(|&rank| usize::from(rank) >= S * S) {
            return None;
        }
        let mut rows = [[[0; D]; S]; S];
        rows.as_flattened_mut().copy_from_slice(ranks);
        Some(Self::new(rows))
    }

    /// The ranks at a pixel, each 0..S²−1. Any coordinate; an `i32` is passed `as u32`.
    #[inline]
    #[must_use]
    pub const fn rank(&self, x: u32, y: u32) -> [u16; D] {
        let size = 1 << Self::SIZE_LOG2;
        self.ranks[torus::wrap(y, size) as usize][torus::wrap(x, size) as usize]
    }

    /// The values at a pixel in 0.32 fixed point.
    #[inline]
    #[must_use]
    pub fn value_fx(&self, x: u32, y: u32) -> [u32; D] {
        self.rank(x, y).map(|rank| value_fx(rank, Self::SIZE_LOG2))
    }

    /// The values at a pixel, each in (0, 1).
    #[inline]
    #[must_use]
    pub fn value(&self, x: u32, y: u32) -> [f32; D] {
        unit::to_f32s(self.value_fx(x, y))
    }

    /// All ranks, row by row, channels interleaved.
    #[inline]
    #[must_use]
    pub const fn ranks(&self) -> &[[[u16; D]; S]; S] {
        &self.ranks
    }

    /// The table as it lies in memory, 2·D·S² bytes (little-endian on little-endian machines): for uploads.
    #[cfg(feature = "bytemuck")]
    #[inline]
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        bytemuck::bytes_of(&self.ranks)
    }
}

const fn size_log2(size: usize) -> u32 {
    assert!(size.is_power_of_two() && size <= 256, "the side of a mask is a power of two up to 256");
    size.trailing_zeros()
}
