//! Every sampler in the call shape that they share.

use bluedither::Sampler;
use bluedither::shader::*;

use crate::bind;
use crate::case::{Case, case};
use crate::device::Bound;

/// All draws of a sampler. `$new` makes it of a seed `a`, and of a number of samples `g` in the second expression.
macro_rules! sampler {
    ($tables:expr, $parts:expr, $wgsl:literal, $new:literal, |$seed:ident, $spp:ident| $sampler:expr) => {{
        let tables: Vec<Bound> = $tables;
        [
            sampler!(@draw 1 $parts, $wgsl, $new, |$seed, $spp| $sampler),
            sampler!(@draw 2 $parts, $wgsl, $new, |$seed, $spp| $sampler),
            sampler!(@draw 3 $parts, $wgsl, $new, |$seed, $spp| $sampler),
            sampler!(@draw 4 $parts, $wgsl, $new, |$seed, $spp| $sampler),
        ]
        .into_iter()
        .flatten()
        .map(move |case| tables.iter().cloned().fold(case, Case::with))
    }};
    (@draw $d:literal $parts:expr, $wgsl:literal, $new:literal, |$seed:ident, $spp:ident| $sampler:expr) => {
        [
            case(
                $parts,
                concat!("bd_", $wgsl, "_draw", $d, "_fx(bd_", $wgsl, "_pixel(bd_", $wgsl, "_", $new, ", b, c, d), e, f)"),
                |[$seed, x, y, frame, domain, index, $spp]| {
                    _ = $spp;
                    $sampler.pixel(x, y, frame).draw_fx::<$d>(domain, index)
                },
            ),
            case(
                $parts,
                concat!("bd_", $wgsl, "_draw", $d, "(bd_", $wgsl, "_pixel(bd_", $wgsl, "_", $new, ", b, c, d), e, f)"),
                |[$seed, x, y, frame, domain, index, $spp]| {
                    _ = $spp;
                    $sampler.pixel(x, y, frame).draw::<$d>(domain, index).map(f32::to_bits)
                },
            ),
        ]
    };
}

pub fn cases() -> Vec<Case> {
    let linear = || vec![bind::linear_order()];
    std::iter::empty()
        .chain(sampler!(linear(), SAMPLER, "sampler", "new(a)", |seed, spp| Sampler::new(seed)))
        .chain(sampler!(linear(), SAMPLER, "sampler", "with_spp(a, g)", |seed, spp| Sampler::with_spp(seed, spp)))
        .collect()
}
