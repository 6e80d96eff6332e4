//! Look-ups.

use bluedither::shader::*;
use bluedither::tables::{OFFSET_1D_16, OFFSET_2D_64, THRESHOLD_64, THRESHOLD_256};
use bluedither::{ScalarMask, linear, tables};

use super::low_high;
use crate::bind;
use crate::case::{Case, case};

pub fn cases() -> Vec<Case> {
    [scalars(&THRESHOLD_256), scalars(&OFFSET_1D_16), scalars(&THRESHOLD_64), vectors(), linears()]
        .into_iter()
        .flatten()
        .collect()
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

fn linears() -> Vec<Case> {
    let tables = &tables::LINEAR_ORDER;
    let bound = bind::linear_order;
    vec![
        case(LINEAR, "bd_linear_packed_rev(a)", |[a]| low_high(tables.sequence.packed_rev(a))).with(bound()),
        case(LINEAR, "bd_linear_packed(a)", |[a]| low_high(tables.sequence.packed(a))).with(bound()),
        case(LINEAR, "bd_linear_digits(10u * (a % 80u), b, c)", |[a, b, c]| {
            let sets = tables.known.as_flattened().iter().chain(&tables.progressive);
            [linear::digits(sets.clone().nth(a as usize % 80).expect("there are 80"), b, c)]
        })
        .with(bound()),
    ]
}
