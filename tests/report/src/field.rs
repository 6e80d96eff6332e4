//! Error images of a sampler: every integrand of both families from one draw of the samples.

use crate::family::{ALL, Integrands};
use crate::shape::{Pixel, Sampler};

/// Pixels on a side of every error image.
pub const SIZE: usize = 128;
/// Pixels of an error image.
pub const PIXELS: usize = SIZE * SIZE;

/// What is drawn for one set of error images.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    pub seed: u32,
    /// What the sampler is told.
    pub spp: u32,
    /// How many samples are taken; fewer than `spp` make a prefix.
    pub count: u32,
    /// How many frames are averaged.
    pub frames: u32,
    /// What is kept of the frames before when one is added: 1 for the mean, less for an exponential moving average.
    pub keep: f32,
}

impl Drawn {
    /// One frame, all samples that the sampler is told of.
    pub const fn all_of(seed: u32, count: u32) -> Self {
        Self { seed, spp: count, count, frames: 1, keep: 1.0 }
    }

    /// The weight of all samples: their number, if frames count alike.
    fn weight(&self) -> f64 {
        (0..self.frames).map(|frame| f64::from(self.keep).powi(frame as i32)).sum::<f64>() * f64::from(self.count)
    }
}

/// One image an integrand, one after the other, each row by row.
pub fn error_images<S: Sampler>(sampler: &S, drawn: Drawn, integrands: &Integrands) -> Vec<f32> {
    // Several pixels at a time: written one by one, the images would share a cache line's place.
    const RUN: usize = 16;
    let mut images = vec![0.0; ALL * PIXELS];
    let mut errors = [[0.0; ALL]; RUN];
    let weight = drawn.weight();
    for start in (0..PIXELS).step_by(RUN) {
        for (k, errors) in errors.iter_mut().enumerate() {
            let (x, y) = ((start + k) % SIZE, (start + k) / SIZE);
            let mut sums = [0.0; ALL];
            for frame in 0..drawn.frames {
                sums.iter_mut().for_each(|sum| *sum *= drawn.keep);
                let pixel = sampler.pixel(x as u32, y as u32, frame);
                for index in 0..drawn.count {
                    integrands.add(pixel.draw(0, index), &mut sums);
                }
            }
            *errors = integrands.errors(&sums, weight);
        }
        for (integrand, image) in images.chunks_exact_mut(PIXELS).enumerate() {
            for (out, errors) in image[start..start + RUN].iter_mut().zip(&errors) {
                *out = errors[integrand];
            }
        }
    }
    images
}
