//! The published method: Georgiev and Fajardo 2016, "Blue-noise dithered sampling".
//!
//! A mask is blue when near pixels hold unlike values. Its energy per pixel is
//!
//! ```text
//! E = Σ_{p≠q} exp(−‖p_i − q_i‖²/2.1² − ‖p_s − q_s‖^{D/2})/S²
//! ```
//!
//! over ordered pairs of pixels p, q of a toroidal tile with positions `_i` and values `_s` (METHODS §2). Values are
//! swapped between pixels, by simulated annealing, until E is low. With [`Distance::Toroidal`] and D ≥ 2 that
//! amplifies low frequencies (the wrapped kernel is not positive definite): values that are used as samples need
//! [`Distance::Euclidean`]. Kept as the reference that other masks are measured against.
//!
//! ```text
//! shuffle the values over the pixels; keep e(p) = Σ_q w(q − p)·K(M[p], M[q]) of every pixel
//! for each of 100 phases, temperature and reach falling geometrically:
//!     p = any pixel; q = the pixel whose value lies within reach of M[p], in an order where near values stand near
//!     change = what e(p) + e(q) would gain by the swap
//!     swap if change < −temperature·ln(random); only then update e around p and q
//! ```
//!
//! Two things make it quick. Near values are swapped ever more often (a fine step, where a random pair is a coarse one
//! that is nearly always refused late): 250 swaps a pixel then beat 2000 of the published kind. And a proposal is
//! judged by the eight nearest pixels first. Sums are integers, floats are single correctly rounded operations or
//! `libm`'s: the same seed gives the same mask everywhere.

use crate::{sobol, torus};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

/// How far apart two sample values are; pixels are always toroidal.
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

const SIGMA_PIXELS: f64 = 2.1; // the paper's; its sigma of values is 1

/// The definition: E per pixel by brute force over the window of ±8 pixels.
pub fn energy<const D: usize>(ranks: &[[u16; D]], size: usize, distance: Distance) -> f64 {
    let count = (size * size) as f64;
    let wrap = |a: usize, d: i32| torus::wrap(low_u32(a).wrapping_add_signed(d), low_u32(size)) as usize;
    let mut sum = 0.0;
    for (p, a) in ranks.iter().enumerate() {
        for dy in window(size, 8) {
            for dx in window(size, 8).filter(|&dx| (dx, dy) != (0, 0)) {
                let b = &ranks[wrap(p / size, dy) * size + wrap(p % size, dx)];
                let squared: f64 = (0..D).map(|k| (difference(a[k], b[k], count, distance) / count).powi(2)).sum();
                let pixels = f64::from(dx * dx + dy * dy) / (SIGMA_PIXELS * SIGMA_PIXELS);
                sum += libm::exp(-pixels - libm::pow(squared, D as f64 / 4.0));
            }
        }
    }
    sum / count
}

fn difference(a: u16, b: u16, count: f64, distance: Distance) -> f64 {
    let plain = f64::from(a.abs_diff(b));
    match distance {
        Distance::Euclidean => plain,
        Distance::Toroidal => plain.min(count - plain),
    }
}

/// Swap annealing of a tile of `size` pixels, a power of two up to 128, with `swaps` tried swaps a pixel.
///
/// D = 1 places every rank once; D = 2 to 4 the first S² Sobol points as whole vectors. `progress` hears the part that
/// is done, 100 times.
pub fn anneal<const D: usize>(
    size: usize,
    spectrum: Spectrum,
    distance: Distance,
    swaps: u32,
    seed: u64,
    progress: &mut dyn FnMut(f32),
) -> Annealed<D> {
    const PHASES: u16 = 100;
    // Ends of the geometric schedules. Start: hotter gains nothing. End: colder or wider is the same or worse; a last
    // reach of a fiftieth of the values is a little better and takes a third longer.
    const TEMPERATURE: [f64; 2] = [0.06, 0.0003];
    const REACH: [f64; 2] = [1.0, 0.05];

    let mut annealer = Annealer::<D>::new(size, distance, seed);
    let tries = u64::from(swaps) * annealer.values.len() as u64;
    for phase in 0..PHASES {
        let (i, all) = (u64::from(phase), u64::from(PHASES));
        let t = f64::from(phase) / f64::from(PHASES - 1);
        let between = |ends: [f64; 2]| ends[0] * libm::pow(ends[1] / ends[0], t);
        if spectrum != Spectrum::All {
            let maximise = spectrum == Spectrum::Low;
            let count = tries * (i + 1) / all - tries * i / all;
            annealer.sweep(count, between(TEMPERATURE), between(REACH), maximise);
        }
        progress(f32::from(phase + 1) / f32::from(PHASES));
    }
    let ranks = annealer.ranks();
    Annealed { energy: energy(&ranks, size, distance), ranks }
}

/// exp(−‖a − b‖^{D/2}) in units of 1/65535, for every D by one table over the upper bits of the squared distance as an
/// `f32`: spaced logarithmically, like the kernel's own detail.
#[derive(Clone, Debug)]
pub struct Kernel<const D: usize> {
    period: f32, // infinite: Euclidean
    table: Vec<u16>,
}

impl<const D: usize> Kernel<D> {
    /// A distance of 0.
    pub const ONE: u32 = 65535;
    // 10 bits of mantissa: relative error below 1e-3 up to D = 3.
    const SHIFT: u32 = f32::MANTISSA_DIGITS - 1 - 10;
    // Entry 0 is the distance 0; the next possible squared distance of ranks is 1.
    const FIRST: u32 = (1f32.to_bits() >> Self::SHIFT) - 1;

    /// For vectors of ranks 0..count−1.
    pub fn new(count: usize, distance: Distance) -> Self {
        let count = count as f32;
        let last = ((D as f32 * count * count).to_bits() >> Self::SHIFT) - Self::FIRST;
        let entry = |i| {
            let middle = f32::from_bits((i + Self::FIRST) << Self::SHIFT | 1 << (Self::SHIFT - 1));
            let squared = f64::from(middle) / f64::from(count * count);
            let value = if i == 0 { 1.0 } else { libm::exp(-libm::pow(squared, D as f64 / 4.0)) };
            rounded(value * f64::from(Self::ONE)) as u16
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

/// Neighbours at (dx, dy), (dx + 1, dy), … and their weights.
#[derive(Clone, Debug)]
struct Row {
    dx: i32,
    dy: i32,
    weights: Vec<u32>,
}

/// Radius of the optimiser's window, a disc: the first weight left out is 4e-4.
const RADIUS: usize = 5;
const RADIUS_SQUARED: usize = 32;
const WEIGHT_ONE: f64 = 4096.0; // all weights · Kernel::ONE < 2³²

/// A mask between two swaps.
#[derive(Clone, Debug)]
pub struct Annealer<const D: usize> {
    /// The kernel of values.
    pub kernel: Kernel<D>,
    size: usize,
    rng: Xoshiro256PlusPlus,
    weights: Vec<u32>,    // by squared distance of pixels
    rings: [Vec<Row>; 2], // the eight nearest pixels, the rest of the disc
    /// All values, in an order where near values stand near.
    values: Vec<[f32; D]>,
    value_of: Vec<usize>, // pixel → index in `values`
    pixel_of: Vec<usize>, // and back
    /// Values by pixel with a margin of RADIUS, so that a row of the window is one slice.
    plane: Vec<[f32; D]>,
    /// e(p), by ring.
    energies: Vec<[u32; 2]>,
}

impl<const D: usize> Annealer<D> {
    /// The value set, shuffled.
    pub fn new(size: usize, distance: Distance, seed: u64) -> Self {
        assert!(size.is_power_of_two() && size <= 128 && (1..=4).contains(&D), "size: 2^k ≤ 128, D: 1 to 4");
        let count = size * size;
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut value_of: Vec<usize> = (0..count).collect();
        for last in (1..count).rev() {
            value_of.swap(last, below(&mut rng, last + 1));
        }
        let mut pixel_of = vec![0; count];
        value_of.iter().enumerate().for_each(|(pixel, &value)| pixel_of[value] = pixel);
        let weight = |r2| rounded(WEIGHT_ONE * libm::exp(-(r2 as f64) / (SIGMA_PIXELS * SIGMA_PIXELS)));
        let weights: Vec<u32> = (0..=RADIUS_SQUARED).map(|r2| if r2 == 0 { 0 } else { weight(r2) }).collect();
        let mut this = Self {
            kernel: Kernel::new(count, distance),
            size,
            rng,
            rings: [0, 1].map(|ring| rows(size, &weights, ring)),
            weights,
            values: values(size),
            value_of,
            pixel_of,
            plane: vec![[0.0; D]; (size + 2 * RADIUS).pow(2)],
            energies: vec![[0; 2]; count],
        };
        (0..count).for_each(|p| this.put(p));
        this.energies = (0..count).map(|p| [0, 1].map(|ring| this.sum(ring, p, &this.value(p)))).collect();
        this
    }

    /// The mask, row by row.
    pub fn ranks(&self) -> Vec<[u16; D]> {
        (0..self.values.len()).map(|p| self.value(p).map(|rank| rank as u16)).collect()
    }

    /// The sum over ordered pairs that is optimised, in units of 1/(WEIGHT_ONE·Kernel::ONE), from the kept e(p).
    pub fn total(&self) -> i64 {
        self.energies.iter().map(|e| i64::from(e[0]) + i64::from(e[1])).sum()
    }

    /// Weight of a pair of pixels that are (dx, dy) apart, modulo the size; 4096 = 1, and 0 for a pixel itself.
    pub fn weight(&self, dx: usize, dy: usize) -> u32 {
        let [dx, dy] = [dx, dy].map(|d| d.min(self.size - d));
        self.weights.get(dx * dx + dy * dy).copied().unwrap_or(0)
    }

    /// Tries `count` swaps; `reach` is the part of all values that a partner is chosen from. Returns the change of
    /// [`total`](Self::total).
    pub fn sweep(&mut self, count: u64, temperature: f64, reach: f64, maximise: bool) -> i64 {
        // A proposal is refused unseen when the nearest pixels speak this much against it: far fewer terms, and the
        // mask even gets better at equal swaps than with .1 or without.
        const SCREEN: f64 = 0.02;
        let unit = WEIGHT_ONE * f64::from(Kernel::<D>::ONE);
        let all = self.values.len();
        let span = rounded(reach * all as f64) as usize;
        let mut gained = 0;
        for _ in 0..count {
            let p = below(&mut self.rng, all);
            let step = below(&mut self.rng, span.max(2));
            let q = self.pixel_of[(self.value_of[p] + all + step - span / 2) & (all - 1)];
            // (0, 1), never 0.
            let random = (f64::from(self.rng.next_u32()) + 0.5) / 4_294_967_296.0;
            let limit = -temperature * libm::log(random);
            let limits = [limit + SCREEN, limit].map(|l| (l * unit) as i64);
            if let Some(change) = self.change(p, q, limits, maximise) {
                self.swap(p, q);
                gained += 2 * change;
            }
        }
        gained
    }

    /// Half the change of the total if p and q swapped; none once it exceeds its limit.
    fn change(&self, p: usize, q: usize, limits: [i64; 2], maximise: bool) -> Option<i64> {
        if p == q {
            return None;
        }
        let (a, b) = (self.value(p), self.value(q));
        let [dx, dy] = [(p % self.size).abs_diff(q % self.size), (p / self.size).abs_diff(q / self.size)];
        // The window sums see b at q when b is tried at p, and a at p when a is tried at q; the pair itself stays a, b.
        let unseen = i64::from(Kernel::<D>::ONE) - i64::from(self.kernel.of(&a, &b));
        let mut change = -2 * i64::from(self.weight(dx, dy)) * unseen;
        for ring in [0, 1] {
            change += i64::from(self.sum(ring, p, &b)) - i64::from(self.energies[p][ring]);
            change += i64::from(self.sum(ring, q, &a)) - i64::from(self.energies[q][ring]);
            if (if maximise { -change } else { change }) > limits[ring] {
                return None;
            }
        }
        Some(change)
    }

    fn swap(&mut self, p: usize, q: usize) {
        let (a, b) = (self.value(p), self.value(q));
        self.splat(p, &a, &b);
        self.splat(q, &b, &a);
        self.value_of.swap(p, q);
        for pixel in [p, q] {
            self.pixel_of[self.value_of[pixel]] = pixel;
            self.put(pixel);
        }
        for pixel in [p, q] {
            self.energies[pixel] = [0, 1].map(|ring| self.sum(ring, pixel, &self.value(pixel)));
        }
    }

    /// e(p) of one ring if p held `value`.
    #[inline]
    fn sum(&self, ring: usize, p: usize, value: &[f32; D]) -> u32 {
        let mut sum = 0u32;
        for row in &self.rings[ring] {
            let start = self.start(p, row);
            for (near, weight) in self.plane[start..start + row.weights.len()].iter().zip(&row.weights) {
                sum = sum.wrapping_add(weight.wrapping_mul(self.kernel.of(near, value)));
            }
        }
        sum
    }

    /// Updates e of p's neighbours: p's value changes from `old` to `new`. The window is symmetric.
    fn splat(&mut self, p: usize, old: &[f32; D], new: &[f32; D]) {
        let wrap = |a: usize, d: i32| torus::wrap(low_u32(a).wrapping_add_signed(d), low_u32(self.size)) as usize;
        for (ring, rows) in self.rings.iter().enumerate() {
            for row in rows {
                let y = wrap(p / self.size, -row.dy);
                for (x, weight) in (0..).zip(&row.weights) {
                    let pixel = y * self.size + wrap(p % self.size, -row.dx - x);
                    let value = &self.values[self.value_of[pixel]];
                    let e = &mut self.energies[pixel][ring];
                    *e = *e + weight * self.kernel.of(value, new) - weight * self.kernel.of(value, old);
                }
            }
        }
    }

    fn value(&self, p: usize) -> [f32; D] {
        self.values[self.value_of[p]]
    }

    /// Where the row of p's window begins in the plane.
    #[inline]
    fn start(&self, p: usize, row: &Row) -> usize {
        let (x, y) = (p % self.size + RADIUS, p / self.size + RADIUS);
        y.wrapping_add_signed(row.dy as isize) * (self.size + 2 * RADIUS) + x.wrapping_add_signed(row.dx as isize)
    }

    /// Copies p's value to the plane and its margins.
    fn put(&mut self, p: usize) {
        let pitch = self.size + 2 * RADIUS;
        for y in ((p / self.size + RADIUS) % self.size..pitch).step_by(self.size) {
            for x in ((p % self.size + RADIUS) % self.size..pitch).step_by(self.size) {
                self.plane[y * pitch + x] = self.value(p);
            }
        }
    }
}

/// The first S² Sobol points as ranks (in one dimension: every rank), along a Z curve.
fn values<const D: usize>(size: usize) -> Vec<[f32; D]> {
    let bits = 2 * size.trailing_zeros();
    let rank = |i, k| u64::from(sobol::dimension(i, k)) >> (32 - bits);
    let mut points: Vec<[u64; D]> =
        (0..low_u32(size * size)).map(|i| core::array::from_fn(|k| rank(i, low_u32(k)))).collect();
    let z = |v: &[u64; D]| (0..bits).rev().fold(0, |z, bit| v.iter().fold(z, |z, c| z << 1 | (c >> bit & 1)));
    points.sort_by_key(z);
    points.iter().map(|v| v.map(|rank| rank as f32)).collect()
}

fn rows(size: usize, weights: &[u32], ring: usize) -> Vec<Row> {
    let weight = |dx: i32, dy: i32| {
        let wanted = (dx.abs().max(dy.abs()) > 1) == (ring == 1);
        if wanted { weights.get((dx * dx + dy * dy) as usize).copied().unwrap_or(0) } else { 0 }
    };
    let row = |dy| {
        let mut inside = window(size, RADIUS).filter(|&dx| weight(dx, dy) > 0);
        let dx = inside.next()?;
        let last = inside.last().unwrap_or(dx);
        Some(Row { dx, dy, weights: (dx..=last).map(|x| weight(x, dy)).collect() })
    };
    window(size, RADIUS).filter_map(row).collect()
}

/// The steps of a window that meet every pixel of a small torus once.
fn window(size: usize, radius: usize) -> core::ops::RangeInclusive<i32> {
    -(radius.min((size - 1) / 2) as i32)..=radius.min(size / 2) as i32
}

/// 0..bound−1; the bias of 2⁻⁵⁰ does not matter here.
fn below(rng: &mut Xoshiro256PlusPlus, bound: usize) -> usize {
    ((u128::from(rng.next_u64()) * bound as u128) >> 64) as usize
}

fn rounded(value: f64) -> u32 {
    (value + 0.5) as u32
}

fn low_u32(value: usize) -> u32 {
    value as u32
}
