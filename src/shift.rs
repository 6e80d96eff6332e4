//! Cranley–Patterson offsets: one point set for the image, moved in every pixel by that pixel's mask value.
//!
//! Cranley and Patterson 1976; Georgiev and Fajardo 2016 take the offset from a blue-noise mask. All arguments and
//! results are 0.32 fixed point, and all sums wrap exactly.

/// Global offset: every component moves by the mask value, modulo 1. One addition a component.
///
/// For points that are regular this map is many-to-one (v and v + 1/N give the same set), so the mask's blueness fades
/// as N grows; [`stratified_1d`] and [`stratified_2d`] keep it.
#[inline]
#[must_use]
pub fn global<const D: usize>(point: [u32; D], offset: [u32; D]) -> [u32; D] {
    let mut moved = point;
    let mut k = 0;
    while k < D {
        moved[k] = point[k].wrapping_add(offset[k]);
        k += 1;
    }
    moved
}

/// Stratified offset in 1D: (cell + frac(local + v))/count. Wraps inside the cell only.
///
/// With `local` = 0 the estimate of every N is as blue over the image as that of one sample.
#[inline]
#[must_use]
pub const fn stratified_1d(cell: u32, count: u32, local: u32, offset: u32) -> u32 {
    crate::strata::place_1d(cell, count, local.wrapping_add(offset))
}

/// Stratified offset in 2D, in the cells of [`strata`](crate::strata): any `count`, equal areas.
#[inline]
#[must_use]
pub const fn stratified_2d(cell: u32, count: u32, local: [u32; 2], offset: [u32; 2]) -> [u32; 2] {
    let inside = [local[0].wrapping_add(offset[0]), local[1].wrapping_add(offset[1])];
    crate::strata::place_2d(cell, count, inside)
}
