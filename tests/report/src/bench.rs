//! The error of one sampler at one number of samples, over all seeds: mean squares an integrand, spikes, spectra.

use crate::analysis::spectrum::Spectrum;
use crate::family::{ALL, Family, Integrands, LINES, SMOOTH};
use crate::field::{Drawn, PIXELS, SIZE, error_images};
use crate::power::{Analyser, Squares};
use crate::samplers;
use crate::shape::{Sampler, Task};
use rayon::prelude::*;

/// What is measured: the images of some seeds, from that of `first` on.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    pub first: Drawn,
    pub seeds: u32,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Samples taken, over all frames.
    pub count: u32,
    /// Of each seed, each integrand.
    pub squares: Vec<[Squares; ALL]>,
    /// Of each half-plane: the largest bin of the mean periodogram over the mean bin, both for |f| > 0.
    pub spikes: [f64; LINES],
    /// Mean power in rings of |f| over the mean for |f| > 0, of each family; ring k is k cycles an image.
    pub radial: [Vec<f64>; 2],
}

/// All that does not depend on the sampler, made once.
pub struct Bench {
    pub integrands: Integrands,
    pub analyser: Analyser,
}

impl Bench {
    pub fn new() -> Self {
        Self { integrands: Integrands::new(), analyser: Analyser::new() }
    }

    /// The error of the sampler of that name.
    pub fn measure(&self, name: &str, setting: Setting) -> Measured {
        samplers::with(name, &Error { bench: self, setting })
    }
}

struct Error<'a> {
    bench: &'a Bench,
    setting: Setting,
}

/// The squares and periodograms of some seeds.
struct Sums {
    squares: Vec<[Squares; ALL]>,
    /// Of the smooth family together, each image's power made 1; then of each half-plane.
    power: Vec<f32>,
}

impl Sums {
    fn new() -> Self {
        Self { squares: Vec::new(), power: vec![0.0; (1 + LINES) * PIXELS] }
    }

    fn and(mut self, mut other: Self) -> Self {
        self.squares.append(&mut other.squares);
        self.power.iter_mut().zip(&other.power).for_each(|(a, b)| *a += b);
        self
    }
}

impl Task for Error<'_> {
    type Output = Measured;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Measured {
        let Self { bench, setting: Setting { first, seeds } } = *self;
        let one = |mut sums: Sums, seed: u32| {
            let drawn = Drawn { seed: first.seed.wrapping_add(seed), ..first };
            let images = error_images(&make(drawn.seed, drawn.spp), drawn, &bench.integrands);
            let mut squares = Vec::with_capacity(ALL);
            let mut scratch = bench.analyser.scratch();
            for (k, pair) in images.chunks_exact(2 * PIXELS).enumerate() {
                let (a, b) = pair.split_at(PIXELS);
                if 2 * k < SMOOTH {
                    let power = &mut sums.power[..PIXELS];
                    let scale = [a, b].map(|image| 1.0 / image.iter().map(|e| e * e).sum::<f32>().max(1e-30));
                    let see = |f: usize, p: [f32; 2]| power[f] += p[0] * scale[0] + p[1] * scale[1];
                    squares.extend(bench.analyser.pair([a, b], &mut scratch, see));
                } else {
                    let start = (1 + 2 * k - SMOOTH) * PIXELS;
                    let (first, second) = sums.power[start..start + 2 * PIXELS].split_at_mut(PIXELS);
                    let see = |f: usize, p: [f32; 2]| (first[f], second[f]) = (first[f] + p[0], second[f] + p[1]);
                    squares.extend(bench.analyser.pair([a, b], &mut scratch, see));
                }
            }
            sums.squares.push(squares.try_into().expect("one for each integrand"));
            sums
        };
        let sums = (0..seeds).into_par_iter().fold(Sums::new, one).reduce(Sums::new, Sums::and);
        let lines: Vec<&[f32]> = sums.power[PIXELS..].chunks_exact(PIXELS).collect();
        Measured {
            count: first.count * first.frames,
            squares: sums.squares,
            spikes: core::array::from_fn(|line| spectrum(&lines[line..=line]).spike()),
            radial: [spectrum(&[&sums.power[..PIXELS]]).radial(), spectrum(&lines).radial()],
        }
    }
}

/// The spectrum that some images of power have together, without the mean.
fn spectrum(powers: &[&[f32]]) -> Spectrum {
    let sum = |k: usize| powers.iter().map(|power| f64::from(power[k])).sum();
    Spectrum::of_power((0..PIXELS).map(|k| if k == 0 { 0.0 } else { sum(k) }).collect(), SIZE)
}

impl Measured {
    /// The mean square of a family in one seed, each integrand divided by `unit` first, weighted.
    pub fn family(&self, seed: usize, family: Family, unit: &[f64; ALL], of: impl Fn(&Squares) -> f64) -> f64 {
        let (mut sum, mut weights) = (0.0, 0.0);
        for k in family.range() {
            sum += Family::weight(k) * of(&self.squares[seed][k]) / unit[k];
            weights += Family::weight(k);
        }
        sum / weights
    }

    /// The mean square of every integrand over the seeds.
    pub fn plain(&self) -> [f64; ALL] {
        let mean = |k: usize| self.squares.iter().map(|s| s[k].plain).sum::<f64>() / self.squares.len() as f64;
        core::array::from_fn(mean)
    }
}
