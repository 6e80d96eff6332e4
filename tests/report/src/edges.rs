//! Edges that move over the screen: neighbouring pixels no longer integrate the same function.
//!
//! Every line sweeps forth and back through the unit square as the pixel goes along a direction of the screen; the
//! shorter the sweep, the less two neighbours have in common, up to an integrand that is noise itself.

use crate::analysis::half_plane::HalfPlane;
use crate::analysis::random::Random;
use crate::bench::Bench;
use crate::error_part::short;
use crate::field::{PIXELS, SIZE};
use crate::progress::Progress;
use crate::samplers::{self, WHITE};
use crate::shape::{Sampler, Task};
use crate::table::Table;
use rayon::prelude::*;

const COUNTS: [u32; 3] = [1, 4, 16];
/// Sweeps over the image: one in 128, 32 and 8 pixels; then a line anywhere, anew in each pixel.
const SWEEPS: [usize; 4] = [1, 4, 16, NOISE];
const NOISE: usize = 0;
const LINES: usize = 8;
/// Any seed that no optimiser uses.
const SEED: u64 = 0x5e51_7000;

/// One line at one density: where it is in each pixel, and what is lit there.
struct Sweep {
    normal: [f32; 2],
    distances: Vec<f32>,
    exact: Vec<f64>,
}

impl Sweep {
    fn new(random: &mut Random, sweeps: usize) -> Self {
        let HalfPlane { normal, .. } = HalfPlane::random(random);
        let along = [sweeps, random.below(sweeps + 1)];
        let phase = random.uniform();
        let low = normal[0].min(0.0) + normal[1].min(0.0);
        let high = normal[0].max(0.0) + normal[1].max(0.0);
        let distance = |p: usize| {
            let turn = (along[0] * (p % SIZE) + along[1] * (p / SIZE)) as f64 / SIZE as f64 + phase;
            // Forth and back, so that the image has no seam.
            let part = if sweeps == NOISE { random.uniform() } else { (2.0 * (turn - turn.floor()) - 1.0).abs() };
            low + (high - low) * part
        };
        let distances: Vec<f64> = (0..PIXELS).map(distance).collect();
        let exact = distances.iter().map(|&distance| HalfPlane { normal, distance }.area()).collect();
        Self { normal: normal.map(|v| v as f32), distances: distances.iter().map(|&d| d as f32).collect(), exact }
    }
}

/// Error images of all sweeps.
struct Images<'a> {
    sweeps: &'a [Sweep],
    count: u32,
    seed: u32,
}

impl Task for Images<'_> {
    type Output = Vec<Vec<f32>>;

    fn run(&self, sampler: &impl Sampler) -> Self::Output {
        let made = sampler.make(self.seed, self.count);
        let mut images = vec![vec![0.0; PIXELS]; self.sweeps.len()];
        let mut points = Vec::new();
        for p in 0..PIXELS {
            let pixel = sampler.pixel(&made, (p % SIZE) as u32, (p / SIZE) as u32, 0);
            points.clear();
            points.extend((0..self.count).map(|index| sampler.draw_2(pixel, 0, index)));
            for (Sweep { normal: [a, b], distances, exact }, image) in self.sweeps.iter().zip(&mut images) {
                let lit = points.iter().filter(|[x, y]| a * x + b * y < distances[p]).count();
                image[p] = (lit as f64 / f64::from(self.count) - exact[p]) as f32;
            }
        }
        images
    }
}

/// W at sigma 1, one row a sampler.
pub fn table(bench: &Bench, names: &[&'static str], seed: u32, seeds: u32) -> Table {
    let progress = Progress::new("moving edges", COUNTS.len() * (1 + names.len()));
    let mut random = Random::new(SEED);
    let sweeps: Vec<Sweep> =
        SWEEPS.iter().flat_map(|&n| (0..LINES).map(|_| Sweep::new(&mut random, n)).collect::<Vec<_>>()).collect();
    // Mean square after the filter, of each density.
    let measure = |name: &str, count: u32| {
        let one = |k: u32| {
            let images = samplers::with(name, &Images { sweeps: &sweeps, count, seed: seed.wrapping_add(k) });
            let mut scratch = bench.analyser.scratch();
            let pairs = images.chunks_exact(2).map(|pair| {
                let squares = bench.analyser.pair([&pair[0], &pair[1]], &mut scratch, |_, _| ());
                squares[0].filtered[0] + squares[1].filtered[0]
            });
            pairs.collect::<Vec<f64>>().chunks_exact(LINES / 2).map(|density| density.iter().sum()).collect()
        };
        let runs: Vec<Vec<f64>> = (0..seeds).into_par_iter().map(one).collect();
        progress.add(1);
        (0..SWEEPS.len()).map(|k| runs.iter().map(|run| run[k]).sum::<f64>()).collect::<Vec<f64>>()
    };
    let white = COUNTS.map(|count| measure(WHITE, count));
    let row = |name: &&'static str| {
        let cells = COUNTS.into_iter().zip(&white).flat_map(|(count, white)| {
            let found = measure(name, count);
            found.into_iter().zip(white).map(|(found, white)| short((found / white).sqrt())).collect::<Vec<_>>()
        });
        core::iter::once((*name).to_string()).chain(cells).collect()
    };
    let density = |n: usize| SIZE.checked_div(n).map_or("noise".to_string(), |period| format!("{period} px"));
    let heads = COUNTS.iter().flat_map(|count| SWEEPS.map(|n| format!("{count} spp, {}", density(n))));
    Table {
        id: "edges".into(),
        title: "W, sigma 1, edges that sweep through the pixel's square".into(),
        about: "One sweep in so many pixels: from smooth over the screen to noise.".into(),
        head: core::iter::once("sampler".to_string()).chain(heads).collect(),
        rows: names.iter().map(row).collect(),
    }
}
