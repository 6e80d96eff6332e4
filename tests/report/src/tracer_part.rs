//! The path tracer's pictures: direct light, two and five vertices; each also through a renderer's own reconstruction
//! filter, where blueness becomes plain lower error.

use crate::analysis::random::seeds;
use crate::arguments::Arguments;
use crate::field::{PIXELS, SIZE};
use crate::figures::{Value, mean, root_of_ratio};
use crate::filter::Filter;
use crate::power::{Analyser, Squares};
use crate::progress::Progress;
use crate::samplers::{self, WHITE};
use crate::several::{BASELINE, number};
use crate::shape::{Pixel, Sampler, Task};
use crate::table::Table;
use crate::tracer::luminance;
use rayon::prelude::*;

/// Vertices of the paths.
const LENGTHS: [u32; 3] = [1, 2, 5];
const COUNTS: [u32; 4] = [1, 4, 16, 64];
/// The reconstruction filter of pbrt-v4: its standard deviation and where it is cut off, pixels.
const SIGMA: f32 = 0.5;
const RADIUS: f32 = 1.5;
/// What a picture is measured by: unfiltered, two Gaussians; the reconstructed picture unfiltered.
const FIGURES: usize = 4;
/// Of the picture of a pixel's own samples, and of the reconstructed one.
type Pictures = [Vec<f32>; 2];

struct Render {
    vertices: u32,
    spp: u32,
    seed: u32,
}

impl Task for Render {
    type Output = Pictures;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Pictures {
        let made = make(self.seed, self.spp);
        // Of each pixel: the mean, and what its samples give to the nine pixels around, with their weights.
        let pixel = |p: usize| {
            let (x, y) = (p % SIZE, p / SIZE);
            let pixel = made.pixel(x as u32, y as u32, 0);
            let (mut sum, mut given) = (0.0, [[0.0f32; 2]; 9]);
            for index in 0..self.spp {
                // A place in the pixel, a point of the lamp, a direction: what the first vertex takes.
                let [dx, dy, rest @ ..] = pixel.draw::<6>(0, index);
                let place = [x as f32 + dx, y as f32 + dy].map(|c| c / SIZE as f32);
                let found = luminance(place, self.vertices, |vertex| {
                    let [u, v, a, b] = if vertex == 0 { rest } else { pixel.draw::<4>(vertex, index) };
                    [[u, v], [a, b]]
                });
                sum += found;
                let [across, down] = [dx, dy].map(|d| [-1.0, 0.0, 1.0].map(|step: f32| weight(d - 0.5 - step)));
                for (k, [value, weights]) in given.iter_mut().enumerate() {
                    let weight = across[k % 3] * down[k / 3];
                    *value += weight * found;
                    *weights += weight;
                }
            }
            (sum / self.spp as f32, given)
        };
        let pixels: Vec<(f32, [[f32; 2]; 9])> = (0..PIXELS).into_par_iter().map(pixel).collect();
        let reconstructed = |p: usize| {
            let (x, y) = (p % SIZE, p / SIZE);
            let mut sum = [0.0; 2];
            for k in 0..9 {
                // From the pixel that this one is neighbour k of.
                let (x, y) = ((x + 1).wrapping_sub(k % 3), (y + 1).wrapping_sub(k / 3));
                if x < SIZE && y < SIZE {
                    let [value, weight] = pixels[y * SIZE + x].1[k];
                    sum = [sum[0] + value, sum[1] + weight];
                }
            }
            sum[0] / sum[1]
        };
        [pixels.iter().map(|pixel| pixel.0).collect(), (0..PIXELS).map(reconstructed).collect()]
    }
}

/// A Gaussian that is lowered to end in zero.
fn weight(distance: f32) -> f32 {
    let gauss = |d: f32| (-0.5 * (d / SIGMA).powi(2)).exp();
    (gauss(distance) - gauss(RADIUS)).max(0.0)
}

/// Converged pictures, and the mean squares of their own errors.
struct Reference {
    pictures: Pictures,
    noise: [f64; FIGURES],
}

impl Reference {
    fn new(vertices: u32, spp: u32, analyser: &Analyser) -> Self {
        let seed = seeds::INTEGRATION as u32;
        let [a, b] = [0, 1].map(|k| samplers::with("sobol-joint", &Render { vertices, spp, seed: seed + k }));
        let halved = |k: usize, sign: f32| a[k].iter().zip(&b[k]).map(|(a, b)| 0.5 * (a + sign * b)).collect();
        let noise = squares(analyser, &[halved(0, -1.0), halved(1, -1.0)]);
        Self { pictures: [halved(0, 1.0), halved(1, 1.0)], noise }
    }

    /// Mean squares of the errors of pictures, without the reference's own.
    fn judge(&self, analyser: &Analyser, pictures: &Pictures) -> [f64; FIGURES] {
        let error = |k: usize| pictures[k].iter().zip(&self.pictures[k]).map(|(a, b)| a - b).collect();
        let found = squares(analyser, &[error(0), error(1)]);
        core::array::from_fn(|k| found[k] - self.noise[k])
    }
}

fn squares(analyser: &Analyser, errors: &Pictures) -> [f64; FIGURES] {
    let [own, reconstructed] = analyser.pair([&errors[0], &errors[1]], &mut analyser.scratch(), |_, _| ());
    let after = |squares: &Squares, sigma: f64| squares.filtered[Filter::Gauss(sigma).place()];
    [own.plain, after(&own, 1.0), after(&own, 2.1), reconstructed.plain]
}

/// A table a length of the paths, a row a sampler.
pub fn tables(arguments: &Arguments) -> Vec<Table> {
    let (counts, seeds, reference) = if arguments.quick { (&COUNTS[..2], 2, 64) } else { (&COUNTS[..], 8, 512) };
    let counts = arguments.spp().unwrap_or_else(|| counts.to_vec());
    let seeds = arguments.chosen_seeds().unwrap_or(seeds);
    let names = arguments.samplers_and_twins();
    let progress = Progress::new("tracing paths", LENGTHS.len() * (2 + names.len()) * counts.len());
    let analyser = Analyser::new();
    let table = |vertices: u32| {
        let reference = Reference::new(vertices, reference, &analyser);
        let of = |name: &str, spp: u32, first: u32, seeds: u32| -> [Value; FIGURES] {
            let one = |k: u32| {
                let pictures = samplers::with(name, &Render { vertices, spp, seed: first.wrapping_add(k) });
                reference.judge(&analyser, &pictures)
            };
            let all: Vec<[f64; FIGURES]> = (0..seeds).map(one).collect();
            progress.add(1);
            core::array::from_fn(|k| mean(&all.iter().map(|one| one[k]).collect::<Vec<f64>>()))
        };
        let white: Vec<_> =
            counts.iter().map(|&spp| of(WHITE, spp, arguments.seed.wrapping_add(BASELINE), 2 * seeds)).collect();
        let row = |name: &&'static str| {
            let cell = |(&spp, white): (&u32, &[Value; FIGURES])| {
                let found = of(name, spp, arguments.seed, seeds);
                let w = |k: usize| number(root_of_ratio(found[k], white[k]), arguments.errors);
                format!("{}: {} {}, {}", w(0), w(1), w(2), w(3))
            };
            core::iter::once((*name).to_string()).chain(counts.iter().zip(&white).map(cell)).collect()
        };
        let title = if vertices == 1 { "direct light".to_string() } else { format!("{vertices} vertices") };
        Table {
            id: format!("tracer-{vertices}"),
            title: format!("Path tracer, {title}"),
            about: "Over padded white noise: unfiltered, after sigma 1 and 2.1; then the picture through a renderer's \
                    reconstruction filter (Gaussian, sigma .5, radius 1.5), as it is."
                .into(),
            head: core::iter::once("samples".to_string()).chain(counts.iter().map(u32::to_string)).collect(),
            rows: names.iter().map(row).collect(),
        }
    };
    LENGTHS.map(table).to_vec()
}

#[cfg(test)]
mod checks {
    use super::*;

    /// Both pictures have the reference's mean, and the reconstruction lowers the error of white noise.
    #[test]
    fn pictures_converge_to_the_reference() {
        let analyser = Analyser::new();
        let reference = Reference::new(2, 64, &analyser);
        let error = |spp: u32| {
            let pictures = samplers::with(WHITE, &Render { vertices: 2, spp, seed: 3 });
            reference.judge(&analyser, &pictures).map(f64::sqrt)
        };
        let (few, many) = (error(1), error(16));
        for k in 0..FIGURES {
            assert!(many[k] < 0.45 * few[k], "figure {k}: {} after {}", many[k], few[k]);
        }
        assert!(few[3] < 0.8 * few[0] && few[2] < few[1] && few[1] < few[0], "{few:?}");
    }
}
