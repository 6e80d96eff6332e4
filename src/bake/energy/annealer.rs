//! Swaps that keep every pixel's energy up to date: a proposal costs two sums over a window.

use super::{Distance, Kernel, pixel_kernel, window};
use crate::{sobol, torus};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

/// Radius of the optimiser's window, a disc: the first weight left out is 4e-4.
const RADIUS: usize = 5;
const RADIUS_SQUARED: i32 = 32;
const WEIGHT_ONE: f64 = 4096.0; // the sum of all weights · Kernel::ONE is below 2³²

/// A mask between two swaps.
#[derive(Clone, Debug)]
pub struct Annealer<const D: usize> {
    /// The kernel of values.
    pub kernel: Kernel<D>,
    size: usize,
    rng: Xoshiro256PlusPlus,
    values: Vec<[f32; D]>, // ranks, in an order where near values stand near
    value_of: Vec<usize>,  // pixel → index in `values`
    pixel_of: Vec<usize>,  // and back
    plane: Vec<[f32; D]>,  // values by place: the tile with a margin, so that no window wraps
    home: Vec<usize>,      // place → pixel
    weights: Vec<u32>,     // by squared distance of pixels
    /// Steps from place to place and weights, of the eight nearest pixels and of the rest of the disc.
    rings: [Vec<(usize, u32)>; 2],
    energies: Vec<[u32; 2]>, // e(p), by ring
}

impl<const D: usize> Annealer<D> {
    /// The value set, shuffled.
    pub fn new(size: usize, distance: Distance, seed: u64) -> Self {
        assert!(size.is_power_of_two() && size <= 128, "the side of a mask is a power of two up to 128");
        assert!((1..=4).contains(&D), "a mask has one to four channels");
        let (count, pitch) = (size * size, size + 2 * RADIUS);
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut value_of: Vec<usize> = (0..count).collect();
        for last in (1..count).rev() {
            value_of.swap(last, below(&mut rng, last + 1));
        }
        let inside = |a: usize| torus::wrap((a as u32).wrapping_sub(RADIUS as u32), size as u32) as usize;
        let weight = |r2| if r2 == 0 { 0 } else { libm::round(WEIGHT_ONE * pixel_kernel(r2)) as u32 };
        let mut this = Self {
            kernel: Kernel::new(count, distance),
            size,
            rng,
            values: values(size),
            value_of,
            pixel_of: vec![0; count],
            plane: vec![[0.0; D]; pitch * pitch],
            home: (0..pitch * pitch).map(|place| inside(place / pitch) * size + inside(place % pitch)).collect(),
            weights: (0..=RADIUS_SQUARED).map(weight).collect(),
            rings: [Vec::new(), Vec::new()],
            energies: vec![[0; 2]; count],
        };
        for (dx, dy) in window(size, RADIUS).filter(|(dx, dy)| dx * dx + dy * dy <= RADIUS_SQUARED) {
            let step = (dy as isize * pitch as isize + dx as isize).cast_unsigned();
            this.rings[usize::from(dx.abs().max(dy.abs()) > 1)].push((step, weight(dx * dx + dy * dy)));
        }
        (0..count).for_each(|p| this.put(p));
        (0..count).for_each(|p| this.energies[p] = [0, 1].map(|ring| this.sum(ring, p, &this.value(p))));
        this
    }

    /// The mask, row by row.
    pub fn ranks(&self) -> Vec<[u16; D]> {
        self.value_of.iter().map(|&i| self.values[i].map(|rank| rank as u16)).collect()
    }

    /// The sum over ordered pairs that is optimised, in units of 1/(4096·65535), from the kept e(p).
    pub fn total(&self) -> i64 {
        self.energies.iter().flatten().map(|&e| i64::from(e)).sum()
    }

    /// 4096 times the weight of pixels that are dx < size and dy < size apart; of a pixel and itself 0.
    pub fn weight(&self, dx: usize, dy: usize) -> u32 {
        let [dx, dy] = [dx, dy].map(|d| d.min(self.size - d));
        self.weights.get(dx * dx + dy * dy).copied().unwrap_or(0)
    }

    /// Tries `count` swaps with partners out of the part `reach` of all values; returns how [`total`](Self::total)
    /// changed, from the changes alone.
    pub fn sweep(&mut self, count: u64, temperature: f64, reach: f64, maximise: bool) -> i64 {
        // How much the nearest pixels may speak against a proposal before it is refused unseen, as most are. At equal
        // swaps the mask is as good as with .1; with 0 it is worse.
        const SCREEN: f64 = 0.02;
        let unit = WEIGHT_ONE * f64::from(Kernel::<D>::ONE);
        let all = self.values.len();
        let span = ((reach.min(1.0) * all as f64) as usize).max(2);
        let mut total = 0;
        for _ in 0..count {
            let p = below(&mut self.rng, all);
            let step = below(&mut self.rng, span);
            let q = self.pixel_of[(self.value_of[p] + all + step - span / 2) & (all - 1)];
            let random = (f64::from(self.rng.next_u32()) + 0.5) / 4_294_967_296.0;
            let limit = -temperature * libm::log(random);
            let limits = [limit + SCREEN, limit].map(|l| (l * unit) as i64);
            if let Some(change) = self.change(p, q, limits, maximise) {
                self.swap(p, q);
                total += 2 * change;
            }
        }
        total
    }

    /// Half the change of the total if p and q swapped; none once it exceeds a ring's limit.
    fn change(&self, p: usize, q: usize, limits: [i64; 2], maximise: bool) -> Option<i64> {
        let (a, b) = (self.value(p), self.value(q));
        let ([px, py], [qx, qy]) = (self.xy(p), self.xy(q));
        // With b at p, p's window still shows b at q (and q's a at p), but the pair itself does not change.
        let pair = self.weight(px.abs_diff(qx), py.abs_diff(qy)) * (Kernel::<D>::ONE - self.kernel.of(&a, &b));
        let mut change = -2 * i64::from(pair);
        for ring in [0, 1] {
            change += i64::from(self.sum(ring, p, &b)) - i64::from(self.energies[p][ring]);
            change += i64::from(self.sum(ring, q, &a)) - i64::from(self.energies[q][ring]);
            if (if maximise { -change } else { change }) > limits[ring] {
                return None;
            }
        }
        (p != q).then_some(change)
    }

    fn swap(&mut self, p: usize, q: usize) {
        let (a, b) = (self.value(p), self.value(q));
        self.splat(p, &a, &b);
        self.splat(q, &b, &a);
        self.value_of.swap(p, q);
        self.put(p);
        self.put(q);
        for pixel in [p, q] {
            self.energies[pixel] = [0, 1].map(|ring| self.sum(ring, pixel, &self.value(pixel)));
        }
    }

    /// One ring of e(p), if p held `value`.
    #[inline]
    fn sum(&self, ring: usize, p: usize, value: &[f32; D]) -> u32 {
        let place = self.place(p);
        let mut sum = 0;
        for &(step, weight) in &self.rings[ring] {
            sum += weight * self.kernel.of(&self.plane[place.wrapping_add(step)], value);
        }
        sum
    }

    /// Updates e of p's neighbours for a value of p that changes from `old` to `new`.
    fn splat(&mut self, p: usize, old: &[f32; D], new: &[f32; D]) {
        let place = self.place(p);
        for (ring, neighbours) in self.rings.iter().enumerate() {
            for &(step, weight) in neighbours {
                let place = place.wrapping_add(step);
                let value = &self.plane[place];
                let e = &mut self.energies[self.home[place]][ring];
                *e = *e + weight * self.kernel.of(value, new) - weight * self.kernel.of(value, old);
            }
        }
    }

    fn value(&self, p: usize) -> [f32; D] {
        self.values[self.value_of[p]]
    }

    /// Without a division.
    fn xy(&self, p: usize) -> [usize; 2] {
        [p & (self.size - 1), p >> self.size.trailing_zeros()]
    }

    fn place(&self, p: usize) -> usize {
        let [x, y] = self.xy(p);
        (y + RADIUS) * (self.size + 2 * RADIUS) + x + RADIUS
    }

    /// Enters p's value wherever it is looked up.
    fn put(&mut self, p: usize) {
        let (value, size, pitch) = (self.value(p), self.size, self.size + 2 * RADIUS);
        self.pixel_of[self.value_of[p]] = p;
        let [first_x, first_y] = self.xy(p).map(|c| (c + RADIUS) & (size - 1));
        for y in (first_y..pitch).step_by(size) {
            for x in (first_x..pitch).step_by(size) {
                self.plane[y * pitch + x] = value;
            }
        }
    }
}

/// The first S² Sobol points as ranks (in one dimension: every rank), along a Z curve.
fn values<const D: usize>(size: usize) -> Vec<[f32; D]> {
    let bits = 2 * size.trailing_zeros();
    let point = |i| core::array::from_fn(|k| u64::from(sobol::dimension(i, k as u32)) >> (32 - bits));
    let z = |v: &[u64; D]| (0..bits).rev().fold(0, |z, bit| v.iter().fold(z, |z, rank| z << 1 | (rank >> bit & 1)));
    let mut points: Vec<[u64; D]> = (0..(size * size) as u32).map(point).collect();
    points.sort_by_key(z);
    points.iter().map(|v| v.map(|rank| rank as f32)).collect()
}

/// A number of 0..bound−1, as good as without bias.
fn below(rng: &mut Xoshiro256PlusPlus, bound: usize) -> usize {
    ((u128::from(rng.next_u64()) * bound as u128) >> 64) as usize
}
