//! The converged picture, from a generator that has nothing to do with the library: `rand`'s Xoshiro256++, jittered.
//!
//! Every pixel takes two independent sets of m² samples. In each set time, lens and light are stratified each for
//! itself, into m² intervals or m×m cells, and visited in random orders of their own. The spread of the two sets gives
//! the standard error of their mean.

use crate::film::Image;
use crate::measure;
use crate::progress::Progress;
use crate::scene::{Dimensions, Sample, Scene};
use glam::Vec3A;
use rand::rngs::Xoshiro256PlusPlus;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};

pub struct Reference {
    pub image: Image,
    pub spp: u32,
    /// Standard error of the mean over pixels and channels: of a pixel, and after each Gaussian of `measure::SIGMAS`.
    pub error: f32,
    pub filtered: [f32; 2],
}

impl Reference {
    /// At least `spp` samples a pixel.
    pub fn render(scene: &Scene, size: [u32; 2], dimensions: Dimensions, spp: u32, seed: u32) -> Self {
        let side = (1..).find(|side| 2 * side * side >= spp).unwrap_or(1);
        let progress = Progress::new("rendering the reference", size[1] as usize);
        let [first, second] = [0, 1].map(|half| {
            Image::render(size, |x, y| {
                if x == 0 && half == y % 2 {
                    progress.add(1);
                }
                let stream = u64::from(seed) << 33 ^ u64::from(y * size[0] + x) << 1 | u64::from(half);
                set(&mut Xoshiro256PlusPlus::seed_from_u64(stream), side, |sample| {
                    scene.radiance(x, y, sample.only(dimensions))
                })
            })
        });
        let spread = first.minus(&second);
        let mean = first.pixels.iter().zip(&second.pixels).map(|(a, b)| 0.5 * (*a + *b)).collect();
        Self {
            image: Image { size, pixels: mean },
            spp: 2 * side * side,
            error: 0.5 * measure::rms(&spread),
            filtered: measure::SIGMAS.map(|sigma| 0.5 * measure::rms(&measure::gaussian(&spread, sigma))),
        }
    }
}

/// The mean over one set of side² jittered samples.
fn set(rng: &mut Xoshiro256PlusPlus, side: u32, radiance: impl Fn(Sample) -> Vec3A) -> Vec3A {
    let mut orders: [Vec<u32>; 2] = core::array::from_fn(|_| (0..side * side).collect());
    orders.iter_mut().for_each(|order| order.shuffle(rng));
    let count = (side * side) as f32;
    let mut sum = Vec3A::ZERO;
    for (i, (lens, light)) in (0..).zip(orders[0].iter().zip(&orders[1])) {
        let mut jitter = |cell: u32, cells: u32| (cell as f32 + rng.random::<f32>()) / cells as f32;
        sum += radiance(Sample {
            time: jitter(i, side * side),
            lens: [jitter(lens % side, side), jitter(lens / side, side)],
            light: [jitter(light % side, side), jitter(light / side, side)],
        });
    }
    sum / count
}
