//! A pixel's whole set of samples in one fixed-capacity buffer, for users who sort, reuse or upload it.

/// Up to `CAPACITY` points of D numbers in [0, 1).
pub type Pattern<const D: usize, const CAPACITY: usize> = heapless::Vec<[f32; D], CAPACITY>;

/// The first min(count, CAPACITY) samples that `draw` gives.
#[inline]
#[must_use]
pub fn collect<const D: usize, const CAPACITY: usize>(
    count: u32,
    mut draw: impl FnMut(u32) -> [f32; D],
) -> Pattern<D, CAPACITY> {
    let mut pattern = Pattern::new();
    let mut index = 0;
    // The push cannot fail; asking it as well leaves no check that could panic.
    while index < count && !pattern.is_full() && pattern.push(draw(index)).is_ok() {
        index += 1;
    }
    pattern
}
