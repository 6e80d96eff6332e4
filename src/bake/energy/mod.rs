//! The published method: Georgiev and Fajardo 2016, "Blue-noise dithered sampling".
//!
//! A mask is blue when near pixels hold unlike values. Its energy per pixel is
//!
//! ```text
//! E = Σ_{p≠q} exp(−‖p_i − q_i‖²/2.1² − ‖p_s − q_s‖^{D/2})/S²
//! ```
//!
//! over ordered pairs of pixels p, q of a toroidal tile, with positions `_i` and values `_s`. Swaps of
//! values, by simulated annealing, lower it. Values that are used as samples need [`Distance::Euclidean`]: wrapped, the
//! kernel is not positive definite from D = 2 on, and the lowest energy is red. This is the reference that other masks
//! are compared with; the library's own are better in what they are for.
//!
//! ```text
//! shuffle the values over the pixels; keep e(p) = Σ_q w(q − p)·K(M[p], M[q]) of every pixel
//! for each of 100 phases, with temperature and reach falling geometrically:
//!     p = any pixel; q = the pixel whose value lies within reach of M[p], in an order where near values stand near
//!     change = what e(p) + e(q) would gain by the swap; first of the nearest pixels, then of all
//!     if change < −temperature·ln(random): swap, and update e around p and q
//! ```
//!
//! The falling reach is not in the paper: late, a random partner is nearly always refused, and a near value is a fine
//! step. It saves two thirds of the swaps. Sums are integers, and floats are single operations or `libm`'s: a seed
//! gives the same mask on every machine.
//!
//! Mounted by `#[path]` in tests and examples, whose root needs `use bluedither::{sobol, torus};`.
#![allow(clippy::cast_possible_truncation, reason = "coordinates, ranks and floats that hold them are below 2^16")]
#![allow(unreachable_pub, reason = "mounted privately by programs and tests")]

mod annealer;
mod kernel;

pub use annealer::Annealer;
pub use kernel::Kernel;

use crate::torus;

/// How far apart two sample values are. Pixels are always toroidal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distance {
    /// Modulo 1 in every component.
    Toroidal,
    /// In the unit cube.
    Euclidean,
}

/// Which frequencies a mask holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spectrum {
    /// Lowest energy: blue.
    High,
    /// Shuffled only: white.
    All,
    /// Highest energy: red.
    Low,
}

/// A mask and what it reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Annealed<const D: usize> {
    /// Row by row, y·size + x.
    pub ranks: Vec<[u16; D]>,
    /// [`energy`] of `ranks`.
    pub energy: f64,
}

/// The definition: E per pixel by brute force over a window of ±8 pixels.
pub fn energy<const D: usize>(ranks: &[[u16; D]], size: usize, distance: Distance) -> f64 {
    let count = (size * size) as f64;
    let wrap = |a: usize, d: i32| torus::wrap((a as u32).wrapping_add_signed(d), size as u32) as usize;
    let mut sum = 0.0;
    for (p, a) in ranks.iter().enumerate() {
        for (dx, dy) in window(size, 8) {
            let b = &ranks[wrap(p / size, dy) * size + wrap(p % size, dx)];
            let squared: f64 = (0..D).map(|k| (difference(a[k], b[k], count, distance) / count).powi(2)).sum();
            sum += pixel_kernel(dx * dx + dy * dy) * value_kernel::<D>(squared);
        }
    }
    sum / count
}

fn difference(a: u16, b: u16, count: f64, distance: Distance) -> f64 {
    let plain = f64::from(a.abs_diff(b));
    if distance == Distance::Toroidal { plain.min(count - plain) } else { plain }
}

/// Of a squared distance in pixels; sigma is the paper's.
fn pixel_kernel(squared: i32) -> f64 {
    libm::exp(-f64::from(squared) / (2.1 * 2.1))
}

/// Of a squared distance of values in the unit cube.
fn value_kernel<const D: usize>(squared: f64) -> f64 {
    libm::exp(-libm::pow(squared, D as f64 / 4.0))
}

/// The steps to a pixel's neighbours; on a small torus each is met once.
fn window(size: usize, radius: usize) -> impl Iterator<Item = (i32, i32)> {
    let range = -(radius.min((size - 1) / 2) as i32)..=radius.min(size / 2) as i32;
    range.clone().flat_map(move |dy| range.clone().map(move |dx| (dx, dy))).filter(|&step| step != (0, 0))
}

/// Swap annealing of a tile of `size` pixels, a power of two up to 128, with `swaps` tried swaps a pixel.
///
/// D = 1 places every rank once; D = 2 to 4 the first S² Sobol points, as whole vectors. `progress` hears 100 times
/// which part is done.
pub fn anneal<const D: usize>(
    size: usize,
    spectrum: Spectrum,
    distance: Distance,
    swaps: u32,
    seed: u64,
    progress: &mut dyn FnMut(f32),
) -> Annealed<D> {
    const PHASES: u16 = 100;
    // From – to. Starts of .03 and .1 and an end of .001 are no better. A reach that ends at .02 gains a little in a
    // third more time; .1 and 1 are worse.
    const TEMPERATURE: [f64; 2] = [0.06, 0.0003];
    const REACH: [f64; 2] = [1.0, 0.05];

    let mut annealer = Annealer::<D>::new(size, distance, seed);
    let tries = |phases: u16| u64::from(swaps) * (size * size) as u64 * u64::from(phases) / u64::from(PHASES);
    for phase in 0..PHASES {
        let t = f64::from(phase) / f64::from(PHASES - 1);
        let between = |ends: [f64; 2]| ends[0] * libm::pow(ends[1] / ends[0], t);
        if spectrum != Spectrum::All {
            let count = tries(phase + 1) - tries(phase);
            annealer.sweep(count, between(TEMPERATURE), between(REACH), spectrum == Spectrum::Low);
        }
        progress(f32::from(phase + 1) / f32::from(PHASES));
    }
    let ranks = annealer.ranks();
    Annealed { energy: energy(&ranks, size, distance), ranks }
}
