//! Look-ups.

use bluedither::shader::*;
use bluedither::tables::{
    KEYS_64, OFFSET_1D_16, OFFSET_2D_64, SEED_PERMUTATION, SEQUENCE, THRESHOLD_64, THRESHOLD_256,
    THRESHOLD_OVER_TIME_32,
};
use bluedither::{ScalarMask, frames};

use super::low_high;
use crate::bind;
use crate::case::{Case, case};

pub fn cases() -> Vec<Case> {
    let scalars = [scalars(&THRESHOLD_64), scalars(&OFFSET_1D_16), scalars(&THRESHOLD_256)].into_iter().flatten();
    scalars.chain(vectors()).chain(sequence()).chain(keys()).chain(over_time()).chain(seeds()).collect()
}

fn scalars<const S: usize>(mask: &'static ScalarMask<S>) -> Vec<Case> {
    vec![
        case(SCALAR, "bd_scalar_rank(a, b)", |[a, b]| [mask.rank(a, b).into()]).with(bind::scalar(mask)),
        case(SCALAR, "bd_scalar_value_fx(a, b)", |[a, b]| [mask.value_fx(a, b)]).with(bind::scalar(mask)),
        case(SCALAR, "bd_scalar_value(a, b)", |[a, b]| [mask.value(a, b).to_bits()]).with(bind::scalar(mask)),
    ]
}

fn vectors() -> Vec<Case> {
    let mask = &OFFSET_2D_64;
    vec![
        case(VECTOR, "bd_vector_rank(a, b)", |[a, b]| mask.rank(a, b).map(u32::from)).with(bind::vector(mask)),
        case(VECTOR, "bd_vector_value_fx(a, b)", |[a, b]| mask.value_fx(a, b)).with(bind::vector(mask)),
        case(VECTOR, "bd_vector_value(a, b)", |[a, b]| mask.value(a, b).map(f32::to_bits)).with(bind::vector(mask)),
    ]
}

fn sequence() -> Vec<Case> {
    vec![
        case(KEYED_SEQUENCE, "bd_sequence_packed_rev(a)", |[a]| low_high(SEQUENCE.packed_rev(a)))
            .with(bind::sequence()),
        case(KEYED_SEQUENCE, "bd_sequence_packed(a)", |[a]| low_high(SEQUENCE.packed(a))).with(bind::sequence()),
    ]
}

fn keys() -> Vec<Case> {
    vec![case(KEYS, "bd_keys_key(a, b)", |[a, b]| KEYS_64.key(a, b)).with(bind::keys(&KEYS_64))]
}

fn over_time() -> Vec<Case> {
    let mask = &THRESHOLD_OVER_TIME_32;
    vec![
        case(OVER_TIME, "bd_over_time_rank(a, b, c)", |[a, b, c]| [mask.frame(a).rank(b, c).into()]),
        case(OVER_TIME, "bd_over_time_value_fx(a, b, c)", |[a, b, c]| [mask.frame(a).value_fx(b, c)]),
        case(OVER_TIME, "bd_over_time_value(a, b, c)", |[a, b, c]| [mask.frame(a).value(b, c).to_bits()]),
    ]
    .into_iter()
    .map(|case| case.with(bind::over_time(mask)))
    .collect()
}

fn seeds() -> Vec<Case> {
    vec![
        case(SEEDS, "bd_seeds_place(a)", |[a]| SEED_PERMUTATION.place(a)).with(bind::seed_swaps()),
        case(SEEDS, "bd_seeds_partner(a & 3u, b, c)", |[a, b, c]| {
            let partner = SEED_PERMUTATION.partner(a & 3, b, c);
            partner.map_or([0; 2], |(right, down)| [right as i32 as u32, down as u32])
        })
        .with(bind::seed_swaps()),
        case(SEEDS, "select(0u, 1u, bd_seeds_begins_block(2u << (a % 3u), b, c))", |[a, b, c]| {
            let begins = match a % 3 {
                0 => frames::seeds::begins_block::<2>(b, c),
                1 => frames::seeds::begins_block::<4>(b, c),
                _ => frames::seeds::begins_block::<8>(b, c),
            };
            [begins.into()]
        })
        .with(bind::seed_swaps()),
    ]
}
