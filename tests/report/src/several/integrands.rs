//! All integrands of several dimensions, evaluated at once for a point of eight numbers, and their exact values.
//!
//! In `f32` and laid out so that a compiler does several at a time. Each family draws from a seed of its own.

use super::family::{ALL, EDGES, FAMILIES, FIXED, Id};
use super::half_space::HalfSpace;
use super::light::Light;
use super::ridges::{Ridges, spread};
use super::smooth::{Smooth, smooth_step};
use crate::analysis::half_plane::HalfPlane;
use crate::analysis::integrands::{Integrand2, smooth_2d};
use crate::analysis::random::{Random, seeds};
use crate::analysis::soft_edge::SoftEdge;
use crate::peers::joint;
use rayon::prelude::*;

/// Those that are 1 on one side of a plane, else 0.
const STEPS: usize =
    Id::Own.count() + Id::Across.count() + Id::Space3.count() + Id::Space5.count() + Id::Space8.count();
const PRODUCTS: usize = Id::Product.count() + Id::Below.count();
const XORS: usize = Id::Xor.count();
const CHECKERS: usize = Id::Checkers.count();

/// Points that integrate what has no formula.
const POINTS: u32 = 1 << 21;

/// The parameters of all integrands.
#[derive(Debug)]
pub struct Integrands {
    /// Exact values.
    pub exact: Vec<f64>,
    /// What is taken from every value, so that sums and their rounding errors stay small: nothing from those that count
    /// points, which are exact.
    centre: Vec<f32>,
    steps: Ridges<STEPS>,
    products: [Ridges<PRODUCTS>; 2],
    xors: [Ridges<XORS>; 2],
    /// Two dimensions, cells on a side.
    checkers: [([usize; 2], f32); CHECKERS],
    edges: Ridges<EDGES>,
    smooth: [Smooth; 2],
    light: Light,
}

/// The dimensions of own pair `k`, modulo the four.
fn own(k: usize) -> [usize; 2] {
    [k % 4 * 2, k % 4 * 2 + 1]
}

/// Two dimensions of different pairs: the 24 there are, in turn.
fn across(k: usize) -> [usize; 2] {
    const PAIRS: [[usize; 2]; 6] = [[0, 1], [2, 3], [0, 2], [1, 3], [0, 3], [1, 2]];
    let [a, b] = PAIRS[k % 6];
    [2 * a + k / 6 % 2, 2 * b + k / 12 % 2]
}

/// The first `count` dimensions, and in every second case a random set of as many.
fn some(random: &mut Random, count: usize, k: usize) -> Vec<usize> {
    let mut all: Vec<usize> = (0..8).collect();
    if k % 2 == 1 {
        random.shuffle(&mut all);
    }
    all.truncate(count);
    all
}

impl Integrands {
    /// Those of all figures. Takes a second.
    pub fn new() -> Self {
        let mut random: Vec<Random> = (0..FAMILIES.len()).map(|k| Random::new(seeds::SEVERAL + k as u64)).collect();
        let mut exact = vec![0.0; ALL];
        let mut set = |id: Id, k: usize, value: f64| exact[id.family().first + k] = value;

        let steps = Ridges::new(|place| {
            let id = [Id::Own, Id::Across, Id::Space3, Id::Space5, Id::Space8]
                .into_iter()
                .rfind(|id| id.family().first <= place)
                .expect("the first begins at 0");
            let (random, k) = (&mut random[id as usize], place - id.family().first);
            let mut space = |dimensions: usize| {
                let dimensions = some(random, dimensions, k);
                let space = HalfSpace::random(random, &dimensions);
                (space.normal, -space.distance, space.volume())
            };
            let (normal, offset, volume) = match id {
                Id::Space3 => space(3),
                Id::Space5 => space(5),
                Id::Space8 => space(8),
                _ => {
                    let plane = HalfPlane::random(random);
                    let at = if id == Id::Own { own(k) } else { across(k) };
                    (spread(plane.normal, at), -plane.distance, plane.area())
                }
            };
            set(id, k, volume);
            (normal, offset)
        });

        let planes: Vec<[HalfPlane; 2]> = (0..Id::Product.count())
            .map(|_| [0; 2].map(|_| HalfPlane::random(&mut random[Id::Product as usize])))
            .collect();
        let products = [0, 1].map(|half| {
            Ridges::new(|place| match planes.get(place) {
                Some(both) => {
                    // Pairs 0 and 1, 2 and 3, 0 and 2, …
                    let at = across(place)[half] / 2;
                    (spread(both[half].normal, own(at)), -both[half].distance)
                }
                None => (one(across(place - planes.len())[half]), -0.5),
            })
        });
        planes.iter().enumerate().for_each(|(k, [a, b])| set(Id::Product, k, a.area() * b.area()));
        (0..Id::Below.count()).for_each(|k| set(Id::Below, k, 0.25));

        // Every third of an own pair.
        let pair = |k: usize| if k.is_multiple_of(3) { own(k / 3) } else { across(2 * k) };
        let xors = [0, 1].map(|half| Ridges::new(|k| (one(pair(k)[half]), -0.5)));
        (0..XORS).for_each(|k| set(Id::Xor, k, 0.5));
        let checkers = core::array::from_fn(|k| (pair(k), if k % 2 == 0 { 4.0 } else { 8.0 }));
        (0..CHECKERS).for_each(|k| set(Id::Checkers, k, 0.5));

        for (k, Integrand2 { exact, .. }) in smooth_2d(seeds::SMOOTH_2D).iter().take(FIXED / 4).enumerate() {
            (0..4).for_each(|pair| set(Id::SmoothPair, 6 * pair + k, *exact));
        }
        let edges = Ridges::new(|k| {
            let edge = SoftEdge::random(&mut random[Id::SmoothPair as usize]);
            set(Id::SmoothPair, FIXED + k, edge.integral());
            (spread(edge.normal.map(|a| a / edge.width), own(k)), 0.5 - edge.distance / edge.width)
        });
        let smooth = [(Id::Smooth5, 5), (Id::Smooth8, 8)].map(|(id, dimensions)| {
            let random = &mut random[id as usize];
            Smooth::new(random, |random, k| some(random, dimensions, k))
        });
        let light = Light::new(&mut random[Id::Light as usize]);
        let centre = vec![0.0; ALL];
        let mut all = Self { exact, centre, steps, products, xors, checkers, edges, smooth, light };
        let found = all.integrate(POINTS, seeds::INTEGRATION as u32);
        for id in [Id::Smooth5, Id::Smooth8, Id::Light] {
            let range = id.family().range();
            all.exact[range.clone()].copy_from_slice(&found[range]);
        }
        for family in FAMILIES.iter().filter(|family| family.normalised) {
            family.range().for_each(|k| all.centre[k] = all.exact[k] as f32);
        }
        all
    }

    /// The mean of every integrand, less its centre, over points of a joint net.
    pub fn integrate(&self, points: u32, seed: u32) -> Vec<f64> {
        // Few enough for sums in f32.
        const RUN: u32 = 256;
        let run = |first: u32| {
            let mut sums = vec![0.0; ALL];
            (first..first + RUN).for_each(|index| self.add(&joint::point(index, seed), &mut sums));
            sums
        };
        let add = |mut all: Vec<f64>, sums: Vec<f32>| {
            all.iter_mut().zip(sums).for_each(|(all, sum)| *all += f64::from(sum));
            all
        };
        let zeros = || vec![0.0; ALL];
        let both = |mut a: Vec<f64>, b: Vec<f64>| {
            a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
            a
        };
        let runs = (0..points / RUN).into_par_iter().map(|k| run(k * RUN));
        let sums = runs.fold(zeros, add).reduce(zeros, both);
        sums.iter().map(|sum| sum / f64::from(points)).collect()
    }

    /// Adds to every sum its integrand's value at a point, less its centre.
    #[inline]
    pub fn add(&self, x: &[f32; 8], sums: &mut [f32]) {
        let sums: &mut [f32; ALL] = sums.try_into().expect("a sum an integrand");
        let lit = |inside: bool| if inside { 1.0 } else { 0.0 };

        let heights = self.steps.at(x);
        for (sum, t) in sums[..STEPS].iter_mut().zip(heights) {
            *sum += lit(t < 0.0);
        }
        let [a, b] = self.products.each_ref().map(|ridges| ridges.at(x));
        for (k, sum) in sums[Id::Product.family().first..][..PRODUCTS].iter_mut().enumerate() {
            *sum += lit(a[k] < 0.0) * lit(b[k] < 0.0);
        }
        let [a, b] = self.xors.each_ref().map(|ridges| ridges.at(x));
        for (k, sum) in sums[Id::Xor.family().range()].iter_mut().enumerate() {
            let (a, b) = (lit(a[k] < 0.0), lit(b[k] < 0.0));
            *sum += a + b - 2.0 * a * b;
        }
        for (sum, ([a, b], cells)) in sums[Id::Checkers.family().range()].iter_mut().zip(&self.checkers) {
            let cell = (x[*a] * cells) as i32 + (x[*b] * cells) as i32;
            *sum += (cell & 1) as f32;
        }

        let mut put = |from: usize, values: &[f32]| {
            let centres = &self.centre[from..from + values.len()];
            for ((sum, value), centre) in sums[from..from + values.len()].iter_mut().zip(values).zip(centres) {
                *sum += value - centre;
            }
        };
        let first = Id::SmoothPair.family().first;
        for pair in 0..4 {
            put(first + 6 * pair, &fixed(x[2 * pair], x[2 * pair + 1]));
        }
        put(first + FIXED, &self.edges.at(x).map(smooth_step));
        put(Id::Smooth5.family().first, &self.smooth[0].at(x));
        put(Id::Smooth8.family().first, &self.smooth[1].at(x));
        put(Id::Light.family().first, &self.light.at(x[0], [x[2], x[3]]));
    }

    /// The error of the mean of `count` points for integrand `k`.
    #[inline]
    pub fn error(&self, k: usize, sum: f32, count: u32) -> f32 {
        (f64::from(sum) / f64::from(count) + (f64::from(self.centre[k]) - self.exact[k])) as f32
    }
}

/// The smooth functions of a pair that have no random part, in the order of the analysis.
#[inline(always)]
fn fixed(x: f32, y: f32) -> [f32; 6] {
    [
        x * y,
        (-x * x - y * y).exp(),
        x,
        x * x,
        (core::f32::consts::PI * (x + y)).sin(),
        0.3 + 0.5 * x - 0.8 * y + 0.9 * x * y,
    ]
}

/// A weight of one for dimension `d`.
fn one(d: usize) -> [f64; 8] {
    core::array::from_fn(|k| f64::from(u8::from(k == d)))
}
