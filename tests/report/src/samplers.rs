//! The samplers that are measured: one line each.

use crate::peers::{
    Cycles, CyclesPixel, Heitz, HeitzPixel, JointSobol, JointSobolPixel, OpenQmc, OpenQmcPixel, Pbrt, PbrtPixel, Pcg,
    PcgPixel, Rand, RandPixel, RandomPattern, RandomPatternPixel, SobolBurley, SobolBurleyPixel, SobolZ, SobolZPixel,
};
use crate::shape::{Task, pixels, shapes};
use bluedither::sampler::{DitheredPixel, KeyedPixel, SamplerPixel, WhitePixel};
use bluedither::{Dithered, Keyed, Sampler, White, tables};
use openqmc::{LatticeBnSampler, PmjBnSampler, SobolBnSampler};

/// The control that all others are held against.
pub const WHITE: &str = "white";
/// What this crate recommends, for known and unknown numbers of samples.
pub const OURS: [&str; 2] = ["sampler", "sampler-progressive"];
/// What is drawn fainter than the crate's own.
pub const PEERS: [&str; 12] = [
    "dithered-random",
    "pcg",
    "rand",
    "sobol-joint",
    "sobol_burley",
    "heitz-2019",
    "openqmc-sobol-bn",
    "openqmc-lattice-bn",
    "openqmc-pmj-bn",
    "cycles-z",
    "pbrt-z",
    "sobol-z",
];
/// Those whose first samples do not depend on how many there will be.
pub const PROGRESSIVE: [&str; 13] = [
    WHITE,
    "sampler-progressive",
    "dithered-progressive",
    "keys",
    "lattice",
    "dithered-random",
    "pcg",
    "rand",
    "sobol-joint",
    "sobol_burley",
    "openqmc-sobol-bn",
    "openqmc-lattice-bn",
    "openqmc-pmj-bn",
];

macro_rules! samplers {
    (|$seed:ident, $spp:ident| $($name:literal => $sampler:expr $(; $bytes:expr)?,)*) => {
        /// All names, in the order of the tables.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Bytes of the tables that the sampler of that name links.
        pub fn bytes(name: &str) -> usize {
            match name {
                $($name => 0 $(+ $bytes)?,)*
                _ => 0,
            }
        }

        /// Does a task with the sampler of that name.
        pub fn with<T: Task>(name: &str, task: &T) -> T::Output {
            match name {
                $($name => task.run(|$seed, $spp| { _ = $spp; $sampler }),)*
                _ => unreachable!("names are checked when arguments are read"),
            }
        }
    };
}

/// Bytes of the two default masks.
const MASKS: usize = size_of_val(&tables::THRESHOLD_64) + OFFSETS;
const OFFSETS: usize = size_of_val(&tables::OFFSET_2D_64);
/// A table of keys, the constants of the points, and 256 points made of them.
const KEYS: usize = size_of_val(&tables::KEYS_64) + size_of_val(&tables::SEQUENCE) + 256 * 8;
const NET: usize = size_of_val(&tables::NET);
/// A release of 2019 as bytes: 256 × 256 numbers, and two tiles of 128 × 128 × 8. The package holds four times as much.
const RELEASE: usize = 256 * 256 + 2 * 128 * 128 * 8;
/// A table of keys and ranks for 256 × 256 pixels.
const OPENQMC: usize = 256 * 256 * 8;

// Any expression of a type that is listed below; then the bytes of its tables, if it has any.
samplers! { |seed, spp|
    "white" => White::with_spp(seed, spp),
    "sampler" => Sampler::with_spp(seed, spp); NET,
    "sampler-progressive" => Sampler::new(seed); NET,
    "dithered" => Dithered::with_spp(seed, spp); MASKS,
    "dithered-progressive" => Dithered::new(seed); MASKS,
    "dithered-stratified" => Dithered::with_spp(seed, spp).stratified(spp); MASKS,
    "keys" => Keyed::new(seed); KEYS,
    "lattice" => Dithered::lattice(seed); size_of_val(&tables::THRESHOLD_64) + size_of_val(&tables::LATTICE_64),
    "dithered-random" => RandomPattern::new(seed); OFFSETS,
    "pcg" => Pcg::new(seed),
    "rand" => Rand::new(seed),
    "sobol-joint" => JointSobol::new(seed); 8 * 32 * 4,
    "sobol_burley" => SobolBurley::new(seed); 256 * 16 * 4,
    "heitz-2019" => Heitz::with_spp(seed, spp); RELEASE,
    "openqmc-sobol-bn" => OpenQmc::<SobolBnSampler>::new(seed); OPENQMC,
    "openqmc-lattice-bn" => OpenQmc::<LatticeBnSampler>::new(seed); OPENQMC,
    "openqmc-pmj-bn" => OpenQmc::<PmjBnSampler>::new(seed); OPENQMC,
    "cycles-z" => Cycles::with_spp(seed, spp),
    "pbrt-z" => Pbrt::with_spp(seed, spp),
    "sobol-z" => SobolZ::with_spp(seed, spp); 8 * 32 * 4,
}

shapes! {
    White, WhitePixel, rows;
    Sampler, SamplerPixel, rows;
    Dithered<'static>, DitheredPixel<'static>, rows;
    Keyed<'static>, KeyedPixel<'static>, rows;
    RandomPattern, RandomPatternPixel;
    Pcg, PcgPixel;
    Rand, RandPixel;
    JointSobol, JointSobolPixel;
    SobolBurley, SobolBurleyPixel;
    Heitz, HeitzPixel;
    OpenQmc<SobolBnSampler>, OpenQmcPixel<SobolBnSampler>;
    OpenQmc<LatticeBnSampler>, OpenQmcPixel<LatticeBnSampler>;
    OpenQmc<PmjBnSampler>, OpenQmcPixel<PmjBnSampler>;
    Cycles, CyclesPixel;
    Pbrt, PbrtPixel;
    SobolZ, SobolZPixel;
}

pixels! {
    WhitePixel; SamplerPixel; DitheredPixel<'static>; KeyedPixel<'static>;
    RandomPatternPixel; PcgPixel; RandPixel; JointSobolPixel; SobolBurleyPixel;
    HeitzPixel; OpenQmcPixel<SobolBnSampler>; OpenQmcPixel<LatticeBnSampler>; OpenQmcPixel<PmjBnSampler>; CyclesPixel;
    PbrtPixel; SobolZPixel;
}
