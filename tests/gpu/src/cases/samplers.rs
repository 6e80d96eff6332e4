//! Every sampler in the call shape that they share.

use bluedither::shader::*;
use bluedither::tables::{KEYS_64, LATTICE_64, OFFSET_2D_64, THRESHOLD_64};
use bluedither::{Dithered, Keyed, Sampler, White};

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
            sampler!(@draw 5 $parts, $wgsl, $new, |$seed, $spp| $sampler),
            sampler!(@draw 6 $parts, $wgsl, $new, |$seed, $spp| $sampler),
            sampler!(@draw 7 $parts, $wgsl, $new, |$seed, $spp| $sampler),
            sampler!(@draw 8 $parts, $wgsl, $new, |$seed, $spp| $sampler),
        ]
        .into_iter()
        .flatten()
        .map(move |case| tables.iter().cloned().fold(case, Case::with_read))
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
    let net = || vec![bind::net()];
    let keyed = || vec![bind::sequence(), bind::keys(&KEYS_64)];
    let lattice = || vec![bind::scalar(&THRESHOLD_64), bind::vector(&LATTICE_64)];
    let masks = || vec![bind::scalar(&THRESHOLD_64), bind::vector(&OFFSET_2D_64)];
    std::iter::empty()
        .chain(sampler!(net(), SAMPLER, "sampler", "new(a)", |seed, spp| Sampler::new(seed)))
        .chain(sampler!(net(), SAMPLER, "sampler", "with_spp(a, g)", |seed, spp| Sampler::with_spp(seed, spp)))
        .chain(sampler!(keyed(), KEYED, "keyed", "with_spp(a, g)", |seed, spp| Keyed::with_spp(seed, spp)))
        .chain(sampler!(lattice(), DITHERED, "dithered", "lattice(a)", |seed, spp| Dithered::lattice(seed)))
        .chain(sampler!(vec![], WHITE, "white", "new(a)", |seed, spp| White::new(seed)))
        .chain(sampler!(masks(), DITHERED, "dithered", "new(a)", |seed, spp| Dithered::new(seed)))
        .chain(sampler!(masks(), DITHERED, "dithered", "with_spp(a, g)", |seed, spp| Dithered::with_spp(seed, spp)))
        .chain(sampler!(masks(), DITHERED, "dithered", "stratified(bd_dithered_new(a), g)", |seed, spp| {
            Dithered::new(seed).stratified(spp)
        }))
        .chain(sampler!(masks(), DITHERED, "dithered", "global(bd_dithered_with_spp(a, g))", |seed, spp| {
            Dithered::with_spp(seed, spp).global()
        }))
        .chain(others())
        .collect()
}

/// The other way to make those that are the same by `new` and by `with_spp`.
fn others() -> Vec<Case> {
    vec![
        case(WHITE, "bd_white_draw1_fx(bd_white_pixel(bd_white_with_spp(a, b), c, d, e), f, g)", |given| {
            let [a, b, c, d, e, f, g] = given;
            White::with_spp(a, b).pixel(c, d, e).draw_fx::<1>(f, g)
        }),
        case(KEYED, "bd_keyed_draw1_fx(bd_keyed_pixel(bd_keyed_new(a), b, c, d), e, f)", |[a, b, c, d, e, f]| {
            Keyed::new(a).pixel(b, c, d).draw_fx::<1>(e, f)
        })
        .with_read(bind::sequence())
        .with_read(bind::keys(&KEYS_64)),
    ]
}
