//! What can be baked, and how.

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

use super::features::{Column, Pattern};
use super::filter::Filter;
use super::inputs::Inputs;
use super::void_and_cluster::{self, Window, void_and_cluster};
use super::{anneal, features, keys, retarget};
use crate::effort::Effort;
use crate::sequence::Sequence;

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
    /// A threshold mask for the filter that comes after it.
    Filtered,
    /// The same for every frame of some, and a moving average.
    FilteredOverTime,
    /// An offset mask of two channels for every frame of some, annealed in space and time.
    Offset2dOverTime,
    /// Swaps that take the threshold mask from one frame's place to the next one's.
    Retargeting,
    /// Scrambling keys, for any number of samples.
    Keys,
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
/// What a pixel's own sequence weighs over time, beside the frames.
pub const OWN: f64 = 0.7;
/// 2²⁰·[`OWN`]·exp(−t²/(2·1.5²)) at a distance of t frames. With 1 instead of .7, frames have a third more power at low
/// frequencies; with a deviation of 1.9, successive frames differ less.
pub const TIME_KERNEL: [i32; 6] = [734_003, 587_744, 301_758, 99_337, 20_967, 2_838];
/// The same for offsets: 128·[`OWN`]·exp(−t²/(2·1.5²)). With 1.7 instead of .7, frames have a tenth more error and the
/// mean of 16 a twentieth less.
pub const OFFSET_TIME_KERNEL: [i32; 4] = [90, 72, 37, 12];

/// Every recipe; each is a feature of the crate.
pub fn all() -> Vec<Recipe> {
    let sizes = |kind, range: core::ops::RangeInclusive<u32>| range.map(move |size_log2| Recipe { kind, size_log2 });
    sizes(Kind::Threshold, 4..=8)
        .chain(sizes(Kind::Offset1d, 4..=7))
        .chain(sizes(Kind::Offset2d, 4..=7))
        .chain(sizes(Kind::Keys, 6..=7))
        .chain(sizes(Kind::Lattice, 6..=6))
        .chain(sizes(Kind::OverTime, 5..=7))
        .chain(sizes(Kind::Offset2dOverTime, 5..=6))
        .chain(sizes(Kind::Filtered, 6..=6))
        .chain(sizes(Kind::FilteredOverTime, 6..=6))
        .chain(sizes(Kind::Retargeting, 6..=6))
        .collect()
}

impl Recipe {
    /// Side in pixels.
    pub fn size(self) -> usize {
        1 << self.size_log2
    }

    /// 16-bit numbers a pixel, as baked.
    pub fn channels(self) -> usize {
        match self.kind {
            Kind::Threshold | Kind::Offset1d | Kind::OverTime => 1,
            Kind::Filtered | Kind::FilteredOverTime | Kind::Retargeting => 1,
            Kind::Offset2d | Kind::Offset2dOverTime | Kind::Lattice | Kind::Keys => 2,
        }
    }

    /// The ranks whose blueness the build log tells, if there are any.
    pub fn still(self, numbers: &[u16]) -> Option<&[u16]> {
        let frame = numbers.len() / self.frames();
        (self.kind != Kind::Retargeting).then_some(&numbers[..frame])
    }

    /// log₂ of the number of frames: as many as fit into 64 or 128 KiB, and of the largest mask the published 64.
    fn frames_log2(self) -> u32 {
        match (self.kind, self.size_log2) {
            (Kind::OverTime, 7) => 6,
            (Kind::OverTime | Kind::FilteredOverTime, size_log2) => 10 - size_log2,
            (Kind::Offset2dOverTime, size_log2) => 9 - size_log2,
            _ => 0,
        }
    }

    /// Number of frames.
    pub fn frames(self) -> usize {
        1 << self.frames_log2()
    }

    /// Where its random numbers begin: fixed for each kind, whatever others come and go; some share one.
    pub fn seed(self) -> u64 {
        let kind = match self.kind {
            Kind::Threshold | Kind::Filtered | Kind::Retargeting => 0,
            Kind::Offset1d => 1,
            Kind::Offset2d | Kind::Offset2dOverTime => 2,
            Kind::OverTime | Kind::FilteredOverTime | Kind::Keys => 3,
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
        let size = self.size();
        match self.kind {
            Kind::Threshold => format!("threshold_{size}"),
            Kind::Offset1d => format!("offset_1d_{size}"),
            Kind::Offset2d => format!("offset_2d_{size}"),
            Kind::OverTime => format!("threshold_over_time_{size}"),
            Kind::Offset2dOverTime => format!("offset_2d_over_time_{size}"),
            Kind::Filtered => format!("threshold_filtered_{size}"),
            Kind::FilteredOverTime => format!("threshold_filtered_over_time_{size}"),
            Kind::Retargeting => "seed_permutation".into(),
            Kind::Keys => format!("keys_{size}"),
            Kind::Lattice => format!("lattice_{size}"),
        }
    }

    /// Whether its digest is recorded: of masks for a filter of the user's own it is not.
    pub fn is_recorded(self, inputs: &Inputs) -> bool {
        !self.is_filtered() || inputs.filter == Filter::default()
    }

    /// Whether the filter is part of it.
    pub fn is_filtered(self) -> bool {
        matches!(self.kind, Kind::Filtered | Kind::FilteredOverTime)
    }

    /// The table that it is made of, if it is made of one.
    pub fn base(self) -> Option<Self> {
        (self.kind == Kind::Retargeting).then_some(Self { kind: Kind::Threshold, ..self })
    }

    /// What [`bake`](Self::bake) makes, from the ranks of its [`base`](Self::base).
    pub fn derive(self, base: &[u16]) -> Vec<u16> {
        match self.kind {
            Kind::Retargeting => retarget::retargeting(base),
            _ => unreachable!("{} is made of no other table", self.name()),
        }
    }

    /// The ranks, 0..S²−1, row by row, channels interleaved; of keys the upper 16 digits of both numbers.
    pub fn bake(self, effort: Effort, inputs: &Inputs) -> Vec<u16> {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(self.seed());
        let sizes = [self.size_log2, self.frames_log2()];
        let kernel = &inputs.void_and_cluster_kernel[..];
        match self.kind {
            Kind::Threshold => void_and_cluster(self.size_log2, kernel, &mut rng),
            Kind::OverTime => {
                let point = |&weight: &i32| Window::new(0, |_, _| weight);
                let mut windows = vec![Window::round(&kernel[..SHORT_KERNEL])];
                windows.extend(TIME_KERNEL[1..].iter().map(point));
                void_and_cluster::over_time(sizes, &windows, &mut rng)
            }
            Kind::Filtered => void_and_cluster::over_time(sizes, &[inputs.filter.still()], &mut rng),
            Kind::FilteredOverTime => {
                void_and_cluster::over_time(sizes, &inputs.filter.over_time(self.frames_log2()), &mut rng)
            }
            Kind::Retargeting => self.derive(&void_and_cluster(self.size_log2, kernel, &mut rng)),
            Kind::Offset1d => self.bake_offsets(Pattern::Regular, &inputs.features_1d, effort, inputs),
            Kind::Offset2d | Kind::Offset2dOverTime => {
                self.bake_offsets(Pattern::Sobol, &inputs.features_2d, effort, inputs)
            }
            Kind::Lattice => self.bake_offsets(Pattern::Lattice, &inputs.features_lattice, effort, inputs),
            Kind::Keys => self.bake_keys(effort, inputs, &mut rng),
        }
    }

    fn bake_offsets(self, pattern: Pattern, columns: &[Column], effort: Effort, inputs: &Inputs) -> Vec<u16> {
        let set = features::value_set(self.channels(), self.size_log2);
        let vectors = features::vectors(&set, pattern, self.size_log2, columns, &inputs.cosine);
        let (time_kernel, share) = match self.kind {
            Kind::Offset2dOverTime => (&OFFSET_TIME_KERNEL[..], 2),
            _ => (&[][..], 1),
        };
        let proposals = match effort {
            Effort::Quick => 50,
            Effort::Normal => 400 / share,
            Effort::Thorough => 20_000 / share,
        };
        let items = anneal::anneal(
            [self.size_log2, self.frames_log2()],
            &vectors,
            &features::value_order(&set),
            &inputs.anneal_kernel,
            time_kernel,
            proposals,
            self.seed(),
        );
        items.iter().flat_map(|&item| set[usize::from(item)][..self.channels()].to_vec()).collect()
    }

    fn bake_keys(self, effort: Effort, inputs: &Inputs, rng: &mut Xoshiro256PlusPlus) -> Vec<u16> {
        let sequence = Sequence::new(&inputs.sequence.0);
        let points = keys::points(&sequence, 1 << (2 * self.size_log2));
        let block = |(columns, prefix)| keys::vectors(&points, prefix as usize, columns, &inputs.cosine);
        let features: Vec<_> = inputs.features_keys.chunks(keys::LANES).zip(keys::PREFIXES).map(block).collect();
        let proposals = match effort {
            Effort::Quick => 50,
            Effort::Normal => 2_500,
            Effort::Thorough => 10_000,
        };
        let mut numbers = keys::start(self.size_log2, rng);
        keys::anneal(&mut numbers, &features, &inputs.anneal_kernel, proposals, rng);
        keys::keys(&sequence, &numbers, rng)
    }
}
