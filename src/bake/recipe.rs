//! What can be baked, and how.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

use super::inputs::Inputs;
use super::{anneal, features, void_and_cluster};
use crate::effort::Effort;

/// What a mask is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Thresholds and offsets of stratified samples: one channel, void-and-cluster.
    Threshold,
    /// Offsets in one dimension, annealed for 1, 4 and 16 samples at once.
    Offset1d,
    /// Offsets in two dimensions, annealed for 1, 4 and 16 samples at once.
    Offset2d,
}

/// One table: a mask of 2^`size_log2` squared pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// What the mask is for.
    pub kind: Kind,
    /// log₂ of its side.
    pub size_log2: u32,
}

/// Every recipe; each is a feature of the crate.
pub fn all() -> Vec<Recipe> {
    let sizes = |kind, range: core::ops::RangeInclusive<u32>| range.map(move |size_log2| Recipe { kind, size_log2 });
    sizes(Kind::Threshold, 4..=8).chain(sizes(Kind::Offset1d, 4..=7)).chain(sizes(Kind::Offset2d, 4..=7)).collect()
}

impl Recipe {
    /// Side in pixels.
    pub fn size(self) -> usize {
        1 << self.size_log2
    }

    /// Numbers a pixel.
    pub fn channels(self) -> usize {
        if self.kind == Kind::Offset2d { 2 } else { 1 }
    }

    /// Bytes of the table.
    pub fn bytes(self) -> usize {
        2 * self.channels() * self.size() * self.size()
    }

    /// As in `offset_2d_64`.
    pub fn name(self) -> String {
        let kind = match self.kind {
            Kind::Threshold => "threshold",
            Kind::Offset1d => "offset_1d",
            Kind::Offset2d => "offset_2d",
        };
        format!("{kind}_{}", self.size())
    }

    /// The ranks, 0..S²−1, row by row, channels interleaved.
    pub fn bake(self, effort: Effort, inputs: &Inputs) -> Vec<u16> {
        let seed = u64::from(self.size_log2) << 8 | self.kind as u64;
        if self.kind == Kind::Threshold {
            let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
            return void_and_cluster::void_and_cluster(self.size_log2, &inputs.void_and_cluster_kernel, &mut rng);
        }
        let columns = if self.kind == Kind::Offset1d { &inputs.features_1d } else { &inputs.features_2d };
        let set = features::value_set(self.channels(), self.size_log2);
        let vectors = features::vectors(&set, self.channels(), self.size_log2, columns, &inputs.cosine);
        let proposals = match effort {
            Effort::Quick => 50,
            Effort::Normal => 400,
            Effort::Thorough => 20_000,
        };
        let items = anneal::anneal(
            self.size_log2,
            &vectors,
            &features::value_order(&set),
            &inputs.anneal_kernel,
            proposals,
            seed,
        );
        items.iter().flat_map(|&item| set[usize::from(item)][..self.channels()].to_vec()).collect()
    }
}
