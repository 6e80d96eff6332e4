//! Mitchell's best candidate in the call shape of the samplers: pictures of samples, made before they are asked for.
//!
//! The 100 candidates of a pixel cost a thousand times what a sampler does, and every sample is a picture of its own:
//! what several of a pixel do together is white.

use bluedither::{candidate, hash, unit};
use rayon::prelude::*;

/// Of each sample two pictures of pairs and one of single numbers: the five that the scene takes.
pub struct Candidates {
    width: u32,
    pictures: Vec<Vec<[u32; 2]>>,
}

/// Pictures of one sample: the last is of single numbers.
const PICTURES: u32 = 3;

/// One pixel of [`Candidates`].
pub struct CandidatesPixel<'a> {
    all: &'a Candidates,
    pixel: usize,
}

impl Candidates {
    pub fn new(seed: u32, [width, height]: [u32; 2], spp: u32) -> Self {
        let picture = |k: u32| {
            let seed = hash::combine(seed, k);
            if k % PICTURES == PICTURES - 1 {
                picture(seed, width, height).into_iter().map(|[a]| [a, 0]).collect()
            } else {
                picture(seed, width, height)
            }
        };
        Self { width, pictures: (0..PICTURES * spp).into_par_iter().map(picture).collect() }
    }

    pub fn pixel(&self, x: u32, y: u32, _frame: u32) -> CandidatesPixel<'_> {
        CandidatesPixel { all: self, pixel: (y * self.width + x) as usize }
    }
}

impl CandidatesPixel<'_> {
    pub fn draw<const D: usize>(&self, _domain: u32, index: u32) -> [f32; D] {
        const { assert!(D < 2 * PICTURES as usize, "there are no more pictures") };
        let sample = |k: usize| self.all.pictures[index as usize * PICTURES as usize + k / 2][self.pixel][k % 2];
        core::array::from_fn(|k| unit::to_f32(sample(k)))
    }
}

fn picture<const D: usize>(seed: u32, width: u32, height: u32) -> Vec<[u32; D]> {
    let mut rows = [const { Vec::new() }; 3].map(|_: Vec<[u32; D]>| vec![[0; D]; width as usize]);
    let mut all = Vec::with_capacity((width * height) as usize);
    for y in 0..height {
        let [above_2, above, row] = &mut rows;
        candidate::fill_row(seed, y, [above_2, above], row);
        all.extend_from_slice(row);
        rows.rotate_left(1);
    }
    all
}
