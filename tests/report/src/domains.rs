//! Many dimensions: what is lost, or not, when one integrand takes numbers of several pairs and domains.
//!
//! The same integrands are estimated twice: by the sampler's domains, and by pairs of as many samplers of independent
//! seeds. If domains decorrelate, both errors are alike.

use crate::analysis::random::Random;
use crate::analysis::soft_edge::SoftEdge;
use crate::error_part::short;
use crate::progress::Progress;
use crate::samplers;
use crate::shape::{Pixel, Sampler, Task};
use crate::table::Table;
use rayon::prelude::*;

/// Samples per pixel.
const COUNTS: [u32; 4] = [1, 4, 16, 64];
/// Pixels on a side; errors are not looked at as images here.
const SIZE: u32 = 64;
const EACH: usize = 16;
/// Any seed that no optimiser uses.
const SEED: u64 = 0x5e51_6000;

/// Products of soft edges, one a pair, and half-spaces of all dimensions.
struct Integrands<const D: usize> {
    products: Vec<Vec<SoftEdge>>,
    half_spaces: Vec<([f64; D], f64)>,
    /// Of the products, then of the half-spaces.
    exact: Vec<f64>,
}

impl<const D: usize> Integrands<D> {
    fn new() -> Self {
        let mut random = Random::new(SEED + D as u64);
        let products: Vec<Vec<SoftEdge>> =
            (0..EACH).map(|_| (0..D / 2).map(|_| SoftEdge::random(&mut random)).collect()).collect();
        let half_spaces: Vec<([f64; D], f64)> = (0..EACH).map(|_| half_space(&mut random)).collect();
        let product = |edges: &Vec<SoftEdge>| edges.iter().map(|edge| 0.5 + edge.integral()).product();
        let exact = products.iter().map(product).chain(half_spaces.iter().map(|(a, t)| volume(a, *t))).collect();
        Self { products, half_spaces, exact }
    }

    fn add(&self, point: &[f32; D], sums: &mut [f64; 2 * EACH]) {
        let point = point.map(f64::from);
        let (products, half_spaces) = sums.split_at_mut(EACH);
        for (sum, edges) in products.iter_mut().zip(&self.products) {
            *sum += edges.iter().zip(point.chunks_exact(2)).map(|(e, p)| 0.5 + e.value([p[0], p[1]])).product::<f64>();
        }
        for (sum, (a, t)) in half_spaces.iter_mut().zip(&self.half_spaces) {
            *sum += f64::from(u8::from(a.iter().zip(point).map(|(a, x)| a * x).sum::<f64>() < *t));
        }
    }
}

/// A normal of random direction, no component too small for `volume`, and a plane through a point of the cube.
fn half_space<const D: usize>(random: &mut Random) -> ([f64; D], f64) {
    loop {
        let normal: [f64; D] = core::array::from_fn(|_| random.normal());
        let point: [f64; D] = core::array::from_fn(|_| random.between(0.2, 0.8));
        if normal.iter().all(|a| a.abs() > 0.15) {
            return (normal, normal.iter().zip(point).map(|(a, x)| a * x).sum());
        }
    }
}

/// The part of the unit cube where a·x < t: inclusion and exclusion of its corners, after mirroring negative axes.
fn volume<const D: usize>(a: &[f64; D], t: f64) -> f64 {
    let t = t - a.iter().map(|a| a.min(0.0)).sum::<f64>();
    let corner = |set: u32| {
        let reach: f64 = (0..D).filter(|k| set >> k & 1 == 1).map(|k| a[k].abs()).sum();
        let sign = if set.count_ones().is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * (t - reach).max(0.0).powi(D as i32)
    };
    let factorial: f64 = (1..=D).map(|k| k as f64).product();
    (0..1u32 << D).map(corner).sum::<f64>() / factorial / a.iter().map(|a| a.abs()).product::<f64>()
}

/// Mean squares of the errors of all integrands, by the domains and by independent seeds.
struct Both<'a, const D: usize> {
    integrands: &'a Integrands<D>,
    count: u32,
    seed: u32,
}

impl<const D: usize> Task for Both<'_, D> {
    type Output = [[f64; 2 * EACH]; 2];

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Self::Output {
        let seed = |k: u32| bluedither::hash::combine(self.seed, k);
        let made: Vec<_> = (0..=D as u32 / 2).map(|k| make(seed(k), self.count)).collect();
        let mut squares = [[0.0; 2 * EACH]; 2];
        for p in 0..SIZE * SIZE {
            let (x, y) = (p % SIZE, p / SIZE);
            let pixels: Vec<_> = made.iter().map(|made| made.pixel(x, y, 0)).collect();
            let mut sums = [[0.0; 2 * EACH]; 2];
            for index in 0..self.count {
                let (mut domains, mut apart) = ([0.0; D], [0.0; D]);
                for (domain, out) in (0..).zip(domains.chunks_exact_mut(4)) {
                    out.copy_from_slice(&pixels[0].draw::<4>(domain, index));
                }
                for (pixel, out) in pixels[1..].iter().zip(apart.chunks_exact_mut(2)) {
                    out.copy_from_slice(&pixel.draw::<2>(0, index));
                }
                self.integrands.add(&domains, &mut sums[0]);
                self.integrands.add(&apart, &mut sums[1]);
            }
            for (squares, sums) in squares.iter_mut().zip(&sums) {
                for ((square, sum), exact) in squares.iter_mut().zip(sums).zip(&self.integrands.exact) {
                    *square += (sum / f64::from(self.count) - exact).powi(2);
                }
            }
        }
        squares.map(|s| s.map(|s| s / f64::from(SIZE * SIZE)))
    }
}

/// Tables for 4 and 8 dimensions.
pub fn tables(names: &[&'static str], seeds: [u32; 2]) -> Vec<Table> {
    let progress = Progress::new("many dimensions", 2 * names.len());
    vec![table::<4>(names, seeds, &progress), table::<8>(names, seeds, &progress)]
}

fn table<const D: usize>(names: &[&'static str], [seed, seeds]: [u32; 2], progress: &Progress) -> Table {
    let integrands = Integrands::<D>::new();
    let rows = names.iter().map(|name| {
        let cells = COUNTS.map(|count| {
            let runs: Vec<_> = (0..seeds)
                .into_par_iter()
                .map(|k| samplers::with(name, &Both { integrands: &integrands, count, seed: seed.wrapping_add(k) }))
                .collect();
            let mean = |way: usize, part: core::ops::Range<usize>| {
                runs.iter().map(|run| run[way][part.clone()].iter().sum::<f64>()).sum::<f64>()
            };
            let ratio = |part: core::ops::Range<usize>| short((mean(0, part.clone()) / mean(1, part)).sqrt());
            format!("{} / {}", ratio(0..EACH), ratio(EACH..2 * EACH))
        });
        progress.add(1);
        core::iter::once((*name).to_string()).chain(cells).collect()
    });
    Table {
        id: format!("domains-{D}d"),
        title: format!("{D} dimensions"),
        about: "Root-mean-square error over that of independently seeded pairs: products of soft edges / half-spaces."
            .into(),
        head: core::iter::once("samples".to_string()).chain(COUNTS.map(|c| c.to_string())).collect(),
        rows: rows.collect(),
    }
}

#[cfg(test)]
mod checks {
    use super::*;

    /// Volumes against plain counting, in one dimension more than a formula could be guessed for.
    #[test]
    fn half_spaces_have_their_volume() {
        let mut random = Random::new(11);
        for _ in 0..8 {
            let (a, t) = half_space::<4>(&mut random);
            let (mut inside, count) = (0, 40_000);
            for _ in 0..count {
                inside += u32::from(a.iter().map(|a| a * random.uniform()).sum::<f64>() < t);
            }
            let found = f64::from(inside) / f64::from(count);
            assert!((found - volume(&a, t)).abs() < 0.012, "{a:?} {t}: {found}, {}", volume(&a, t));
        }
        assert!((volume(&[1.0; 8], 4.0) - 0.5).abs() < 1e-12);
        assert!((volume(&[-1.0; 8], 0.0) - 1.0).abs() < 1e-12);
    }

    /// White noise loses nothing.
    #[test]
    fn white_is_white_in_eight_dimensions() {
        let integrands = Integrands::<8>::new();
        let measured = |seed| samplers::with(samplers::WHITE, &Both { integrands: &integrands, count: 4, seed });
        let mut sums = measured(0);
        for seed in 1..6 {
            sums.iter_mut().flatten().zip(measured(seed).iter().flatten()).for_each(|(sum, found)| *sum += found);
        }
        let [joint, apart] = sums;
        for (k, (joint, apart)) in joint.iter().zip(apart).enumerate() {
            assert!((joint / apart - 1.0).abs() < 0.15, "integrand {k}: {joint}, {apart}");
        }
    }
}
