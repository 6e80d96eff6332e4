//! The published masks (Georgiev and Fajardo 2016), annealed at start: a scalar one for time and a two-channel one for
//! lens and light, of low, all and high frequencies.

use crate::energy::{self, Distance, Spectrum};
use crate::progress::Progress;
use bluedither::{Dithered, ScalarMask, VectorMask};
use rayon::prelude::*;

/// Side of the masks in pixels.
const SIZE: usize = 64;

/// The two masks of one spectrum.
pub struct Pair {
    pub spectrum: Spectrum,
    scalar: ScalarMask<SIZE>,
    vector: VectorMask<2, SIZE>,
    /// Energy per pixel of the scalar and of the vector mask.
    pub energies: [f64; 2],
}

impl Pair {
    /// The library's sampler on these masks.
    pub fn dithered(&self, seed: u32) -> Dithered<'_, SIZE> {
        Dithered::with_masks(&self.scalar, &self.vector, seed)
    }
}

/// The masks that the chosen samplers need.
pub struct Masks(pub Vec<Pair>);

impl Masks {
    /// Anneals all masks side by side, with `swaps` tried swaps a pixel.
    pub fn anneal(spectra: &[Spectrum], swaps: u32, seed: u32) -> Self {
        if spectra.is_empty() {
            return Self(Vec::new());
        }
        let progress = Progress::new("annealing the published masks", 2 * 100 * spectra.len());
        let pair = |spectrum: &Spectrum| {
            let (scalar, vector) = rayon::join(
                || anneal::<1>(*spectrum, swaps, seed, &progress),
                || anneal::<2>(*spectrum, swaps, seed, &progress),
            );
            Pair {
                spectrum: *spectrum,
                scalar: ScalarMask::from_slice(scalar.ranks.as_flattened()).expect("ranks of this size"),
                vector: VectorMask::from_slice(&vector.ranks).expect("ranks of this size"),
                energies: [scalar.energy, vector.energy],
            }
        };
        Self(spectra.par_iter().map(pair).collect())
    }

    pub fn low(&self) -> &Pair {
        self.get(Spectrum::Low)
    }

    pub fn all(&self) -> &Pair {
        self.get(Spectrum::All)
    }

    pub fn high(&self) -> &Pair {
        self.get(Spectrum::High)
    }

    fn get(&self, spectrum: Spectrum) -> &Pair {
        let found = self.0.iter().find(|pair| pair.spectrum == spectrum);
        found.expect("the masks of all chosen samplers are annealed first")
    }
}

fn anneal<const D: usize>(spectrum: Spectrum, swaps: u32, seed: u32, progress: &Progress) -> energy::Annealed<D> {
    let mut done = 0;
    let mut advance = |share: f32| {
        let percent = (share * 100.0) as usize;
        progress.add(percent.saturating_sub(done));
        done = done.max(percent);
    };
    // Values are offsets of integrands that are not periodic: Euclidean.
    energy::anneal(SIZE, spectrum, Distance::Euclidean, swaps, seed.into(), &mut advance)
}
