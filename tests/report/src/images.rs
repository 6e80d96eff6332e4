//! Error images of a chapter's own integrands, and what filters leave of them.

use crate::bench::Bench;
use crate::field::{PIXELS, SIZE};
use crate::power::Squares;
use crate::samplers;
use crate::shape::{Sampler, Task};
use rayon::prelude::*;

/// Integrands that a pixel evaluates together.
pub trait Pixels: Sync {
    /// An even number of them: images are transformed in pairs.
    fn count(&self) -> usize;
    /// Writes the error of each integrand in pixel `p`, row by row; `point(index)` is a sample of two numbers, or of
    /// one.
    fn errors(&self, p: usize, point: impl Fn(u32) -> [f32; 2], out: &mut [f32]);
    /// One sampler's samples in the shape of a pair.
    fn draw(pixel: impl crate::shape::Pixel, index: u32) -> [f32; 2] {
        pixel.draw::<2>(0, index)
    }
}

struct Images<'a, P> {
    pixels: &'a P,
    count: u32,
    seed: u32,
}

impl<P: Pixels> Task for Images<'_, P> {
    /// An error image an integrand.
    type Output = Vec<Vec<f32>>;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Self::Output {
        let made = make(self.seed, self.count);
        let mut images = vec![vec![0.0; PIXELS]; self.pixels.count()];
        let mut errors = vec![0.0; images.len()];
        for p in 0..PIXELS {
            let pixel = made.pixel((p % SIZE) as u32, (p / SIZE) as u32, 0);
            self.pixels.errors(p, |index| P::draw(pixel, index), &mut errors);
            images.iter_mut().zip(&errors).for_each(|(image, error)| image[p] = *error);
        }
        images
    }
}

/// Mean squares of the error of each integrand, summed over the seeds from `seed` on.
pub fn squares<P: Pixels>(bench: &Bench, name: &str, pixels: &P, count: u32, [seed, seeds]: [u32; 2]) -> Vec<Squares> {
    let one = |k: u32| -> Vec<Squares> {
        let images = samplers::with(name, &Images { pixels, count, seed: seed.wrapping_add(k) });
        let mut scratch = bench.analyser.scratch();
        let pair = |pair: &[Vec<f32>]| bench.analyser.pair([&pair[0], &pair[1]], &mut scratch, |_, _| ());
        images.chunks_exact(2).flat_map(pair).collect()
    };
    let sum = |mut sums: Vec<Squares>, other: Vec<Squares>| {
        sums.iter_mut().zip(&other).for_each(|(sum, other)| sum.add(other));
        sums
    };
    (0..seeds).into_par_iter().map(one).reduce_with(sum).unwrap_or_default()
}
