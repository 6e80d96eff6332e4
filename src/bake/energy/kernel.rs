//! The kernel of sample values as a table: one look-up for every number of dimensions, the same bits on every host.

use super::{Distance, value_kernel};

/// The kernel of values in units of 1/65535, for every D by one table over the upper bits of the squared distance as
/// an `f32`: spaced logarithmically, as the kernel's detail is.
#[derive(Clone, Debug)]
pub struct Kernel<const D: usize> {
    period: f32, // infinite: Euclidean
    table: Vec<u16>,
}

impl<const D: usize> Kernel<D> {
    /// The kernel of equal values.
    pub const ONE: u32 = 65535;
    // 10 bits of mantissa: relative error below 1e-3 up to D = 3.
    const SHIFT: u32 = f32::MANTISSA_DIGITS - 1 - 10;
    // Entry 0 is the distance 0; the next squared distance of two ranks is 1.
    const FIRST: u32 = (1f32.to_bits() >> Self::SHIFT) - 1;

    /// For vectors of ranks 0..count−1.
    pub fn new(count: usize, distance: Distance) -> Self {
        let count = count as f32;
        let last = ((D as f32 * count * count).to_bits() >> Self::SHIFT) - Self::FIRST;
        let entry = |i| {
            let middle = f32::from_bits((i + Self::FIRST) << Self::SHIFT | 1 << (Self::SHIFT - 1));
            let squared = if i == 0 { 0.0 } else { f64::from(middle) / f64::from(count * count) };
            libm::round(value_kernel::<D>(squared) * f64::from(Self::ONE)) as u16
        };
        let period = if distance == Distance::Toroidal { count } else { f32::INFINITY };
        Self { period, table: (0..=last).map(entry).collect() }
    }

    /// The kernel of two vectors of ranks.
    #[inline]
    pub fn of(&self, a: &[f32; D], b: &[f32; D]) -> u32 {
        let mut squared = 0.0;
        let mut k = 0;
        while k < D {
            let plain = (a[k] - b[k]).abs();
            let d = plain.min(self.period - plain);
            squared += d * d;
            k += 1;
        }
        u32::from(self.table[(squared.to_bits() >> Self::SHIFT).saturating_sub(Self::FIRST) as usize])
    }
}
