//! Power spectra of error images, two images a transform, and what each filter leaves.

use crate::field::{PIXELS, SIZE};
use crate::filter::{FILTERS, factors};
use rustfft::num_complex::Complex32;
use rustfft::{Fft, FftPlanner};
use std::sync::Arc;

/// Mean squares of one error image.
#[derive(Clone, Copy, Debug)]
pub struct Squares {
    /// As it is.
    pub plain: f64,
    /// After each filter.
    pub filtered: [f64; FILTERS.len()],
}

impl Squares {
    pub fn add(&mut self, other: &Self) {
        self.plain += other.plain;
        self.filtered.iter_mut().zip(other.filtered).for_each(|(sum, square)| *sum += square);
    }
}

/// The transform and the filters, planned once.
pub struct Analyser {
    fft: Arc<dyn Fft<f32>>,
    factors: Vec<[f32; FILTERS.len()]>,
}

/// What one thread needs while it transforms.
#[derive(Debug)]
pub struct Scratch {
    data: Vec<Complex32>,
    turned: Vec<Complex32>,
    fft: Vec<Complex32>,
}

impl Analyser {
    pub fn new() -> Self {
        Self { fft: FftPlanner::new().plan_fft_forward(SIZE), factors: factors() }
    }

    pub fn scratch(&self) -> Scratch {
        let zeros = |length| vec![Complex32::ZERO; length];
        Scratch { data: zeros(PIXELS), turned: zeros(PIXELS), fft: zeros(self.fft.get_inplace_scratch_len()) }
    }

    /// Analyses two images; `see(k, powers)` is told the powers of both at each frequency k, which over all k add up to
    /// the mean square. Axes are swapped, which changes no figure made of this.
    pub fn pair(
        &self,
        [a, b]: [&[f32]; 2],
        scratch: &mut Scratch,
        mut see: impl FnMut(usize, [f32; 2]),
    ) -> [Squares; 2] {
        let Scratch { data, turned, fft } = scratch;
        for ((z, &a), &b) in data.iter_mut().zip(a).zip(b) {
            *z = Complex32::new(a, b);
        }
        self.fft.process_with_scratch(data, fft);
        transpose(data, turned);
        self.fft.process_with_scratch(turned, fft);

        let mut plain = [0.0f64; 2];
        let mut filtered = [[0.0f64; FILTERS.len()]; 2];
        let scale = 0.25 / (PIXELS as f32 * PIXELS as f32);
        for row in 0..SIZE {
            // Sums of a row in f32, of rows in f64.
            let (mut row_plain, mut row_filtered) = ([0.0f32; 2], [[0.0f32; FILTERS.len()]; 2]);
            let mirror = (SIZE - row) % SIZE * SIZE;
            for column in 0..SIZE {
                let k = row * SIZE + column;
                // The spectrum of a real image is conjugate-symmetric: that tells the two apart.
                let (z, m) = (turned[k], turned[mirror + (SIZE - column) % SIZE].conj());
                let powers = [(z + m).norm_sqr() * scale, (z - m).norm_sqr() * scale];
                let factors = &self.factors[k];
                for image in 0..2 {
                    row_plain[image] += powers[image];
                    for (sum, factor) in row_filtered[image].iter_mut().zip(factors) {
                        *sum += powers[image] * factor;
                    }
                }
                see(k, powers);
            }
            for image in 0..2 {
                plain[image] += f64::from(row_plain[image]);
                for (sum, row) in filtered[image].iter_mut().zip(row_filtered[image]) {
                    *sum += f64::from(row);
                }
            }
        }
        [0, 1].map(|image| Squares { plain: plain[image], filtered: filtered[image] })
    }
}

fn transpose(from: &[Complex32], to: &mut [Complex32]) {
    const BLOCK: usize = 16;
    for y in (0..SIZE).step_by(BLOCK) {
        for x in (0..SIZE).step_by(BLOCK) {
            for dy in 0..BLOCK {
                for dx in 0..BLOCK {
                    to[(x + dx) * SIZE + y + dy] = from[(y + dy) * SIZE + x + dx];
                }
            }
        }
    }
}
