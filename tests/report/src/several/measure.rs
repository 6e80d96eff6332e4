//! Error images of all integrands, seed by seed, and what is kept of them: mean squares, local spikes, some pictures.

use super::family::{ALL, FAMILIES};
use super::integrands::Integrands;
use super::numbers::{Form, RUN};
use super::spike::{Spikes, median_and_worst};
use crate::field::{PIXELS, SIZE};
use crate::power::{Analyser, Squares};
use crate::samplers::{self, PROGRESSIVE};
use crate::shape::{Sampler, Task};
use rayon::prelude::*;

/// Seeds whose spikes are looked at: thousands of windows a family.
const SPIKE_SEEDS: u32 = 2;

/// All that does not depend on the sampler, made once.
pub struct Judge {
    pub integrands: Integrands,
    analyser: Analyser,
    spikes: Spikes,
}

/// What is measured of a sampler.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    pub form: Form,
    /// Samples per pixel, the least first.
    pub counts: &'a [u32],
    /// The first seed, and how many.
    pub seeds: [u32; 2],
}

/// What was found at one number of samples.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// Of each seed, each integrand.
    pub squares: Vec<Vec<Squares>>,
    /// Median and worst local spike of each family.
    pub spikes: Vec<[f32; 2]>,
    /// Of the first seed, the image of each family's first integrand.
    pub images: Vec<Vec<f32>>,
}

/// One seed at one number of samples.
#[derive(Default)]
struct One {
    squares: Vec<Squares>,
    spikes: Vec<Vec<f32>>,
    images: Vec<Vec<f32>>,
}

impl Judge {
    pub fn new() -> Self {
        Self { integrands: Integrands::new(), analyser: Analyser::new(), spikes: Spikes::new() }
    }

    /// The error of the sampler of that name at each number of samples.
    pub fn measure(&self, name: &str, setting: Setting) -> Vec<Measured> {
        let [first, seeds] = setting.seeds;
        let one = |k: u32| {
            let images = Images { judge: self, name, setting, seed: first.wrapping_add(k), place: k };
            samplers::with(name, &images)
        };
        let all: Vec<Vec<One>> = (0..seeds).into_par_iter().map(one).collect();
        let mut measured = vec![Measured::default(); setting.counts.len()];
        for (k, measured) in measured.iter_mut().enumerate() {
            measured.squares = all.iter().map(|seed| seed[k].squares.clone()).collect();
            measured.images = all[0][k].images.clone();
            let family = |place: usize| {
                let mut spikes: Vec<f32> =
                    all.iter().filter_map(|seed| seed[k].spikes.get(place)).flatten().copied().collect();
                median_and_worst(&mut spikes)
            };
            measured.spikes = (0..FAMILIES.len()).map(family).collect();
        }
        measured
    }
}

/// All error images of one seed.
struct Images<'a> {
    judge: &'a Judge,
    name: &'a str,
    setting: Setting<'a>,
    seed: u32,
    /// Its place among the seeds.
    place: u32,
}

impl Task for Images<'_> {
    type Output = Vec<One>;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Vec<One> {
        let progressive = PROGRESSIVE.contains(&self.name);
        let mut sums = vec![0.0; ALL * PIXELS];
        let mut taken = 0;
        let one = |&count: &u32| {
            // A progressive sampler goes on from what was drawn before.
            if !progressive {
                sums.fill(0.0);
                taken = 0;
            }
            let made = make(self.seed, count);
            let mut points = [[0.0; 8]; RUN];
            for (p, sums) in sums.chunks_exact_mut(ALL).enumerate() {
                let pixel = made.pixel((p % SIZE) as u32, (p / SIZE) as u32, 0);
                let mut first = taken;
                while first < count {
                    let points = &mut points[..RUN.min((count - first) as usize)];
                    self.setting.form.fill(pixel, first, points);
                    points.iter().for_each(|point| self.judge.integrands.add(point, sums));
                    first += points.len() as u32;
                }
            }
            taken = count;
            self.look(&sums, count)
        };
        self.setting.counts.iter().map(one).collect()
    }
}

impl Images<'_> {
    /// From sums, pixel by pixel, to images, some at a time, and to what is kept of them.
    fn look(&self, sums: &[f32], count: u32) -> One {
        // As many as share a line of memory.
        const AT_ONCE: usize = 16;
        let Judge { integrands, analyser, spikes } = self.judge;
        let mut scratch = analyser.scratch();
        let mut images = vec![0.0; AT_ONCE * PIXELS];
        let mut found = One { spikes: vec![Vec::new(); FAMILIES.len()], ..One::default() };
        for first in (0..ALL).step_by(AT_ONCE) {
            let taken = AT_ONCE.min(ALL - first);
            for (p, sums) in sums.chunks_exact(ALL).enumerate() {
                for (k, sum) in sums[first..first + taken].iter().enumerate() {
                    images[k * PIXELS + p] = integrands.error(first + k, *sum, count);
                }
            }
            for (k, pair) in images[..taken * PIXELS].chunks_exact(2 * PIXELS).enumerate() {
                let pair: [&[f32]; 2] = pair.split_at(PIXELS).into();
                found.squares.extend(analyser.pair(pair, &mut scratch, |_, _| ()));
                let place = FAMILIES.iter().rposition(|family| family.first <= first + 2 * k).unwrap_or(0);
                if self.place < SPIKE_SEEDS {
                    spikes.of(pair, &mut found.spikes[place]);
                }
                if self.place == 0 && FAMILIES[place].first == first + 2 * k {
                    found.images.push(pair[0].to_vec());
                }
            }
        }
        found
    }
}
