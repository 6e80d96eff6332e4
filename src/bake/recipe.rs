//! What can be baked, and how.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

use super::inputs::Inputs;
use super::linear_order::LinearOrder;
use super::{anneal, features, keys, retarget, void_and_cluster};
use crate::effort::Effort;
use crate::linear;

/// What a mask is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Thresholds and offsets of stratified samples: one channel, void-and-cluster.
    Threshold,
    /// Offsets in one dimension, annealed for 1, 4 and 16 samples at once.
    Offset1d,
    /// Offsets in two dimensions, annealed for 1, 4 and 16 samples at once.
    Offset2d,
    /// A threshold mask for every frame of some, void-and-cluster in space and time.
    OverTime,
    /// Swaps that take the threshold mask from one frame's place to the next one's.
    Retargeting,
    /// Scrambling keys, from the linear order of any number of samples.
    Keys,
    /// Keys from the linear order of 4 samples.
    Keys4,
    /// Keys from the linear order of 16 samples.
    Keys16,
    /// Shifts of a rank-1 lattice, annealed for 1, 4 and 16 samples at once.
    Lattice,
}

/// One table: a mask of 2^`size_log2` squared pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// What the mask is for.
    pub kind: Kind,
    /// log₂ of its side.
    pub size_log2: u32,
}

/// Masks over time take as much of the kernel as reaches 6 pixels: a fifth quicker, and no worse.
const SHORT_KERNEL: usize = 37;
/// 2²⁰·.7·exp(−t²/(2·1.5²)) at a distance of t frames. With 1 instead of .7, frames have a third more power at low
/// frequencies; with a deviation of 1.9, successive frames differ less.
pub const TIME_KERNEL: [i32; 6] = [734_003, 587_744, 301_758, 99_337, 20_967, 2_838];

/// Every recipe; each is a feature of the crate.
pub fn all() -> Vec<Recipe> {
    let sizes = |kind, range: core::ops::RangeInclusive<u32>| range.map(move |size_log2| Recipe { kind, size_log2 });
    sizes(Kind::Threshold, 4..=8)
        .chain(sizes(Kind::Offset1d, 4..=7))
        .chain(sizes(Kind::Offset2d, 4..=7))
        .chain(sizes(Kind::Keys, 6..=7))
        .chain(sizes(Kind::Keys4, 6..=6))
        .chain(sizes(Kind::Keys16, 6..=6))
        .chain(sizes(Kind::Lattice, 6..=6))
        .chain(sizes(Kind::OverTime, 5..=6))
        .chain(sizes(Kind::Retargeting, 6..=6))
        .collect()
}

impl Recipe {
    /// Side in pixels.
    pub fn size(self) -> usize {
        1 << self.size_log2
    }

    /// Whether the table holds keys.
    pub fn is_keys(self) -> bool {
        matches!(self.kind, Kind::Keys | Kind::Keys4 | Kind::Keys16)
    }

    /// 16-bit numbers a pixel, as baked.
    pub fn channels(self) -> usize {
        match self.kind {
            Kind::Threshold | Kind::Offset1d | Kind::OverTime | Kind::Retargeting => 1,
            _ => 2,
        }
    }

    /// The ranks whose blueness the build log tells, if there are any.
    pub fn still(self, numbers: &[u16]) -> Option<&[u16]> {
        let frame = numbers.len() / self.frames();
        (self.kind != Kind::Retargeting).then_some(&numbers[..frame])
    }

    /// log₂ of the number of frames: larger masks have fewer.
    fn frames_log2(self) -> u32 {
        if self.kind == Kind::OverTime { 10 - self.size_log2 } else { 0 }
    }

    /// Number of frames.
    pub fn frames(self) -> usize {
        1 << self.frames_log2()
    }

    /// Where its random numbers begin: fixed for each kind, whatever others come and go; two may share one.
    pub fn seed(self) -> u64 {
        let kind = match self.kind {
            Kind::Threshold | Kind::Retargeting => 0,
            Kind::Offset1d => 1,
            Kind::Offset2d => 2,
            Kind::OverTime | Kind::Keys => 3,
            Kind::Keys4 => 4,
            Kind::Keys16 => 5,
            Kind::Lattice => 6,
        };
        u64::from(self.size_log2) << 8 | kind
    }

    /// Bytes of the table.
    pub fn bytes(self) -> usize {
        2 * self.channels() * self.size() * self.size() * self.frames()
    }

    /// As in `offset_2d_64`.
    pub fn name(self) -> String {
        let kind = match self.kind {
            Kind::OverTime => "threshold_over_time",
            Kind::Retargeting => return "seed_permutation".into(),
            Kind::Threshold => "threshold",
            Kind::Offset1d => "offset_1d",
            Kind::Offset2d => "offset_2d",
            Kind::Lattice => "lattice",
            Kind::Keys | Kind::Keys4 | Kind::Keys16 => "keys",
        };
        let spp = match self.kind {
            Kind::Keys4 => "_spp_4",
            Kind::Keys16 => "_spp_16",
            _ => "",
        };
        format!("{kind}_{}{spp}", self.size())
    }

    /// The ranks, 0..S²−1, row by row, channels interleaved; of keys the upper 16 digits of both numbers.
    pub fn bake(self, effort: Effort, inputs: &Inputs) -> Vec<u16> {
        if self.kind == Kind::Retargeting {
            let mask = Self { kind: Kind::Threshold, ..self };
            return retarget::retargeting(&mask.bake(effort, inputs));
        }
        let seed = self.seed();
        if self.kind == Kind::OverTime {
            return void_and_cluster::over_time(
                self.size_log2,
                self.frames_log2(),
                &inputs.void_and_cluster_kernel[..SHORT_KERNEL],
                &TIME_KERNEL,
                &mut Xoshiro256PlusPlus::seed_from_u64(seed),
            );
        }
        if self.kind == Kind::Threshold {
            let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
            return void_and_cluster::void_and_cluster(self.size_log2, &inputs.void_and_cluster_kernel, &mut rng);
        }
        if self.is_keys() {
            return self.bake_keys(effort, inputs, seed);
        }
        let (pattern, columns) = match self.kind {
            Kind::Offset1d => (features::Pattern::Regular, &inputs.features_1d),
            Kind::Lattice => (features::Pattern::Lattice, &inputs.features_lattice),
            _ => (features::Pattern::Sobol, &inputs.features_2d),
        };
        let set = features::value_set(self.channels(), self.size_log2);
        let vectors = features::vectors(&set, pattern, self.size_log2, columns, &inputs.cosine);
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

    fn bake_keys(self, effort: Effort, inputs: &Inputs, seed: u64) -> Vec<u16> {
        // Ranks below the number of samples do not change their set.
        let ranks_log2 = match self.kind {
            Kind::Keys4 => 2,
            Kind::Keys16 => 4,
            _ => 6,
        };
        let order = match self.kind {
            Kind::Keys => linear::ORDERS - 1,
            _ => ranks_log2 as usize,
        };
        let LinearOrder { sequence, orders } = &inputs.linear_order;
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let digits = keys::linear_digits(&orders[order], self.size_log2, &mut rng);
        let points = keys::points(&linear::Sequence::new(sequence), 1 << ranks_log2);
        let mut vectors = Vec::new();
        for (columns, prefix) in inputs.features_keys.chunks(keys::LANES).zip(keys::PREFIXES) {
            if prefix < 1 << ranks_log2 {
                vectors.push(keys::vectors(&digits, &points, prefix as usize, columns, &inputs.cosine));
            }
        }
        let proposals = match effort {
            Effort::Quick => 30,
            Effort::Normal => 600,
            Effort::Thorough => 4_000,
        };
        let kernel = &inputs.anneal_kernel;
        let ranks = keys::choose_ranks(self.size_log2, ranks_log2, &vectors, kernel, proposals, &mut rng);
        let pixel = |(digits, rank): (&u32, &u8)| {
            let key = digits ^ points[usize::from(*rank)];
            [(key >> 16) as u16, key as u16]
        };
        digits.iter().zip(&ranks).flat_map(pixel).collect()
    }
}
