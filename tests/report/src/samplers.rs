//! The samplers that are measured: one line each.

use crate::peers::{Cycles, Heitz, Pbrt, Pcg, RandomPattern, SobolBurley};
use crate::shape::{Task, shape};
use bluedither::{Constant, Dithered, White};

/// The control that all others are held against.
pub const WHITE: &str = "white";

macro_rules! samplers {
    (|$seed:ident, $spp:ident| $($name:literal => $sampler:expr,)*) => {
        /// All names, in the order of the tables.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Does a task with the sampler of that name.
        pub fn with<T: Task>(name: &str, task: &T) -> T::Output {
            match name {
                $($name => task.run(&shape(
                    |$seed: u32, $spp: u32| { _ = $spp; $sampler },
                    |sampler, x, y, frame| sampler.pixel(x, y, frame),
                    |pixel, domain, index| pixel.draw::<1>(domain, index),
                    |pixel, domain, index| pixel.draw::<2>(domain, index),
                    |pixel, domain, index| pixel.draw::<4>(domain, index),
                )),)*
                _ => unreachable!("names are checked when arguments are read"),
            }
        }
    };
}

// Any expression whose value has `pixel(x, y, frame)` and its `draw::<D>(domain, index)`.
samplers! { |seed, spp|
    "white" => White::with_spp(seed, spp),
    "constant" => Constant::with_spp(seed, spp),
    "dithered" => Dithered::with_spp(seed, spp),
    "dithered-progressive" => Dithered::new(seed),
    "dithered-stratified" => Dithered::with_spp(seed, spp).stratified(spp),
    "dithered-random" => RandomPattern::new(seed),
    "pcg" => Pcg::new(seed),
    "sobol_burley" => SobolBurley::new(seed),
    "heitz-2019" => Heitz::with_spp(seed, spp),
    "cycles-z" => Cycles::with_spp(seed, spp),
    "pbrt-z" => Pbrt::with_spp(seed, spp),
}
