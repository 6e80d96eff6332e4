//! The samplers that are measured: one line each.

use crate::peers::{
    Cycles, CyclesPixel, Heitz, HeitzPixel, Pbrt, PbrtPixel, Pcg, PcgPixel, Rand, RandPixel, RandomPattern,
    RandomPatternPixel, SobolBurley, SobolBurleyPixel,
};
use crate::shape::{Task, pixels, shapes};
use bluedither::sampler::{DitheredPixel, KeyedPixel, LinearPixel, WhitePixel};
use bluedither::{Dithered, Keyed, Sampler, White, tables};

/// The control that all others are held against.
pub const WHITE: &str = "white";
/// What is drawn fainter than the crate's own.
pub const PEERS: [&str; 7] = ["dithered-random", "pcg", "rand", "sobol_burley", "heitz-2019", "cycles-z", "pbrt-z"];

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
const KEYS: usize = size_of_val(&tables::KEYS_64) + LINEAR + 256 * 8;
const LINEAR: usize = size_of_val(&tables::LINEAR_ORDER);
/// A release of 2019 as bytes: 256 × 256 numbers, and two tiles of 128 × 128 × 8. The package holds four times as much.
const RELEASE: usize = 256 * 256 + 2 * 128 * 128 * 8;

// Any expression of a type that is listed below; then the bytes of its tables, if it has any.
samplers! { |seed, spp|
    "white" => White::with_spp(seed, spp),
    "sampler" => Sampler::with_spp(seed, spp); LINEAR,
    "sampler-progressive" => Sampler::new(seed); LINEAR,
    "dithered" => Dithered::with_spp(seed, spp); MASKS,
    "dithered-progressive" => Dithered::new(seed); MASKS,
    "dithered-stratified" => Dithered::with_spp(seed, spp).stratified(spp); MASKS,
    "keys" => Keyed::new(seed); KEYS,
    "lattice" => Dithered::lattice(seed); size_of_val(&tables::THRESHOLD_64) + size_of_val(&tables::LATTICE_64),
    "dithered-random" => RandomPattern::new(seed); OFFSETS,
    "pcg" => Pcg::new(seed),
    "rand" => Rand::new(seed),
    "sobol_burley" => SobolBurley::new(seed); 256 * 16 * 4,
    "heitz-2019" => Heitz::with_spp(seed, spp); RELEASE,
    "cycles-z" => Cycles::with_spp(seed, spp),
    "pbrt-z" => Pbrt::with_spp(seed, spp),
}

shapes! {
    White, WhitePixel, rows;
    Sampler, LinearPixel, rows;
    Dithered<'static>, DitheredPixel<'static>, rows;
    Keyed<'static>, KeyedPixel<'static>, rows;
    RandomPattern, RandomPatternPixel;
    Pcg, PcgPixel;
    Rand, RandPixel;
    SobolBurley, SobolBurleyPixel;
    Heitz, HeitzPixel;
    Cycles, CyclesPixel;
    Pbrt, PbrtPixel;
}

pixels! {
    WhitePixel; LinearPixel; DitheredPixel<'static>; KeyedPixel<'static>;
    RandomPatternPixel; PcgPixel; RandPixel; SobolBurleyPixel; HeitzPixel; CyclesPixel; PbrtPixel;
}
