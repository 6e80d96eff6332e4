//! Edges that move over the screen: neighbouring pixels no longer integrate the same function.
//!
//! Every line sweeps forth and back through the unit square as the pixel goes along a direction of the screen; the
//! shorter the sweep, the less two neighbours have in common, up to an integrand that is noise itself.

use crate::analysis::half_plane::HalfPlane;
use crate::analysis::random::Random;
use crate::bench::Bench;
use crate::error_part::short;
use crate::field::{PIXELS, SIZE};
use crate::filter::SIGMA_1;
use crate::images::{self, Pixels};
use crate::progress::Progress;
use crate::samplers::WHITE;
use crate::table::Table;

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

/// All lines at all densities.
struct Sweeps {
    sweeps: Vec<Sweep>,
    count: u32,
}

impl Pixels for Sweeps {
    fn count(&self) -> usize {
        self.sweeps.len()
    }

    fn errors(&self, p: usize, point: impl Fn(u32) -> [f32; 2], out: &mut [f32]) {
        let points: Vec<[f32; 2]> = (0..self.count).map(point).collect();
        for (Sweep { normal: [a, b], distances, exact }, out) in self.sweeps.iter().zip(out) {
            let lit = points.iter().filter(|[x, y]| a * x + b * y < distances[p]).count();
            *out = (lit as f64 / f64::from(self.count) - exact[p]) as f32;
        }
    }
}

/// W at sigma 1, one row a sampler.
pub fn table(bench: &Bench, names: &[&'static str], seeds: [u32; 2]) -> Table {
    let progress = Progress::new("moving edges", COUNTS.len() * (1 + names.len()));
    let sweeps = COUNTS.map(|count| {
        let mut random = Random::new(SEED);
        let one = SWEEPS.map(|n| core::array::from_fn::<_, LINES, _>(|_| Sweep::new(&mut random, n)));
        Sweeps { sweeps: one.into_iter().flatten().collect(), count }
    });
    // Mean square after the filter, of each number of samples and density.
    let measure = |name: &str| -> Vec<f64> {
        let of_count = |sweeps: &Sweeps| {
            progress.add(1);
            let squares = images::squares(bench, name, sweeps, sweeps.count, seeds);
            squares
                .chunks_exact(LINES)
                .map(|lines| lines.iter().map(|s| s.filtered[SIGMA_1]).sum())
                .collect::<Vec<f64>>()
        };
        sweeps.iter().flat_map(of_count).collect()
    };
    let white = measure(WHITE);
    let row = |name: &&'static str| {
        let cells =
            measure(name).iter().zip(&white).map(|(found, white)| short((found / white).sqrt())).collect::<Vec<_>>();
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
