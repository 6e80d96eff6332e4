//! A pixel's whole set of samples in one fixed-capacity buffer, for users who sort, reuse or upload it.

/// Up to `CAPACITY` points of D numbers in [0, 1).
pub type Pattern<const D: usize, const CAPACITY: usize> = heapless::Vec<[f32; D], CAPACITY>;

/// min(count, CAPACITY) points at the origin, to be filled.
#[inline]
#[must_use]
pub(crate) fn of_length<const D: usize, const CAPACITY: usize>(count: u32) -> Pattern<D, CAPACITY> {
    let mut pattern = Pattern::new();
    let mut filled = 0;
    // The push cannot fail; asking it as well leaves no check that could panic.
    while filled < count && pattern.push([0.0; D]).is_ok() {
        filled += 1;
    }
    pattern
}
