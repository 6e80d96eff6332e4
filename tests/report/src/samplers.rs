//! The samplers that are measured: one line each.

use crate::peers::{Cycles, Heitz, Pbrt, Pcg, RandomPattern, SobolBurley};
use crate::shape::{Task, shape};
use bluedither::{Constant, Dithered, Keyed, Rank1, Sampler, White, ZOrder, tables};

/// The control that all others are held against.
pub const WHITE: &str = "white";

macro_rules! samplers {
    (|$seed:ident, $spp:ident| $($name:literal => $sampler:expr $(; $bytes:expr)?,)*) => {
        /// All names, in the order of the tables.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Bytes of the tables that each of them links.
        pub const BYTES: &[usize] = &[$(0 $(+ $bytes)?),*];

        /// Does a task with the sampler of that name.
        pub fn with<T: Task>(name: &str, task: &T) -> T::Output {
            match name {
                $($name => task.run(&shape(
                    |$seed: u32, $spp: u32| { _ = $spp; $sampler },
                    |sampler, x, y, frame| sampler.pixel(x, y, frame),
                    |pixel, domain, index| pixel.draw::<1>(domain, index),
                    |pixel, domain, index| pixel.draw::<2>(domain, index),
                    |pixel, domain, index| pixel.draw::<4>(domain, index),
                    |pixel, domain, first, out| pixel.fill::<1>(domain, first, out),
                    |pixel, domain, first, out| pixel.fill::<2>(domain, first, out),
                    |pixel, domain, first, out| pixel.fill::<4>(domain, first, out),
                )),)*
                _ => unreachable!("names are checked when arguments are read"),
            }
        }
    };
}

/// Bytes of the two default masks.
const MASKS: usize = size_of_val(&tables::THRESHOLD_64) + OFFSETS;
const OFFSETS: usize = size_of_val(&tables::OFFSET_2D_64);
/// A table of keys, and the points that `LINEAR_ORDER` has for them.
const KEYS: usize = size_of_val(&tables::KEYS_64) + size_of_val(&tables::LINEAR_ORDER.sequence);
const LINEAR: usize = size_of_val(&tables::LINEAR_ORDER);
/// A release of 2019 as bytes: 256 × 256 numbers, and two tiles of 128 × 128 × 8. The package holds four times as much.
const RELEASE: usize = 256 * 256 + 2 * 128 * 128 * 8;

// Any expression whose value has `pixel(x, y, frame)` and its `draw::<D>(domain, index)` and `fill`; then the bytes of its tables,
// if it has any.
samplers! { |seed, spp|
    "white" => White::with_spp(seed, spp),
    "constant" => Constant::with_spp(seed, spp),
    "sampler" => Sampler::with_spp(seed, spp); LINEAR,
    "sampler-progressive" => Sampler::new(seed); LINEAR,
    "dithered" => Dithered::with_spp(seed, spp); MASKS,
    "dithered-progressive" => Dithered::new(seed); MASKS,
    "dithered-stratified" => Dithered::with_spp(seed, spp).stratified(spp); MASKS,
    "z-order" => ZOrder::with_spp(seed, spp),
    "keys" => Keyed::new(seed); KEYS,
    "keys-spp-4" => Keyed::with_keys(&tables::KEYS_64_SPP_4, seed); KEYS,
    "keys-spp-16" => Keyed::with_keys(&tables::KEYS_64_SPP_16, seed); KEYS,
    "lattice" => Rank1::new(seed); size_of_val(&tables::LATTICE_64),
    "dithered-random" => RandomPattern::new(seed); OFFSETS,
    "pcg" => Pcg::new(seed),
    "sobol_burley" => SobolBurley::new(seed); 256 * 16 * 4,
    "heitz-2019" => Heitz::with_spp(seed, spp); RELEASE,
    "cycles-z" => Cycles::with_spp(seed, spp),
    "pbrt-z" => Pbrt::with_spp(seed, spp),
}
