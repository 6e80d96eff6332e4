//! Halftoning.

use bluedither::dither::{alpha, gamma, ordered, quantise};
use bluedither::shader::*;
use bluedither::tables::THRESHOLD_64;
use bluedither::{Dither, ScalarMask};

use crate::bind;
use crate::case::{Case, case};

pub fn cases() -> Vec<Case> {
    [quantises(), gammas(), others(), dithers()].into_iter().flatten().collect()
}

/// The lower 16 bits, which is what the shader is given as well.
fn half(word: u32) -> u16 {
    word as u16
}

fn quantises() -> Vec<Case> {
    vec![
        case(QUANTISE, "bd_quantise_level(a & 0xffffu, b & 0xffffu, c & 0xffffu, d)", |[a, b, c, d]| {
            [quantise::level(half(a), half(b), half(c), d).into()]
        }),
        case(QUANTISE, "bd_quantise_level(a & 0xffu, 255u, b & 31u, c)", |[a, b, c]| {
            [quantise::level(half(a & 255), 255, half(b & 31), c).into()]
        }),
        case(QUANTISE, "bd_quantise_level_triangular(a & 0xffffu, b & 0xffffu, c & 0xffffu, d)", |[a, b, c, d]| {
            [quantise::level_triangular(half(a), half(b), half(c), d).into()]
        }),
        case(QUANTISE, "bd_quantise_level_triangular(a & 0xffu, 255u, b & 31u, c)", |[a, b, c]| {
            [quantise::level_triangular(half(a & 255), 255, half(b & 31), c).into()]
        }),
        case(QUANTISE, "bd_quantise_triangular(a)", |[a]| [quantise::triangular(a).cast_unsigned()]),
        case(QUANTISE, "bd_quantise_value(a & 0xffffu, b & 0xffffu, c & 0xffffu)", |[a, b, c]| {
            [quantise::value(half(a), half(b), half(c)).into()]
        }),
    ]
}

fn gammas() -> Vec<Case> {
    vec![
        case(GAMMA, "bd_gamma_to_linear(a & 0xffffu)", |[a]| [gamma::to_linear(half(a)).into()]),
        case(GAMMA, "bd_gamma_from_linear(a & 0xffffu)", |[a]| [gamma::from_linear(half(a)).into()]),
        case(GAMMA, "bd_gamma_level(a & 0xffffu, b & 0xffffu, c & 0xffffu, d)", |[a, b, c, d]| {
            [gamma::level(half(a), half(b), half(c), d).into()]
        }),
        case(GAMMA, "bd_gamma_level(a & 0xffu, 255u, b & 31u, c)", |[a, b, c]| {
            [gamma::level(half(a & 255), 255, half(b & 31), c).into()]
        }),
    ]
    .into_iter()
    .map(|case| case.with(bind::linear_light()))
    .collect()
}

fn others() -> Vec<Case> {
    vec![
        case(ORDERED, "bd_ordered_value_fx(a, b, c)", |[a, b, c]| [ordered::value_fx(a, b, c)]),
        case(ORDERED, "bd_ordered_value_fx(a, b, c & 15u)", |[a, b, c]| [ordered::value_fx(a, b, c & 15)]),
        case(
            ALPHA,
            "bd_alpha_over(vec4(a, a >> 8u, a >> 16u, a >> 24u) & vec4(255u), vec3(b, b >> 8u, b >> 16u) & vec3(255u))",
            |[a, b]| {
                let [red, green, blue, _] = b.to_le_bytes();
                alpha::over(a.to_le_bytes(), [red, green, blue]).map(u32::from)
            },
        ),
    ]
}

fn dithers() -> Vec<Case> {
    static MASK: &ScalarMask<64> = &THRESHOLD_64;
    vec![
        case(DITHER, "bd_dither_threshold_fx(bd_dither_constant(d), a, b, c)", |[a, b, c, d]| {
            [Dither::constant(d).threshold_fx(a, b, c)]
        }),
        case(DITHER, "bd_dither_threshold_fx(bd_dither_frame(bd_dither_random(d), e), a, b, c)", |[a, b, c, d, e]| {
            [Dither::random(d).frame(e).threshold_fx(a, b, c)]
        }),
        case(DITHER, "bd_dither_threshold_fx(bd_dither_frame(bd_dither_ordered(d), e), a, b, c)", |[a, b, c, d, e]| {
            [Dither::ordered(d).frame(e).threshold_fx(a, b, c)]
        }),
        case(DITHER, "bd_dither_threshold_fx(bd_dither_ordered(d & 15u), a, b, c)", |[a, b, c, d]| {
            [Dither::ordered(d & 15).threshold_fx(a, b, c)]
        }),
        case(DITHER, "bd_dither_threshold_fx(bd_dither_blue(), a, b, c)", |[a, b, c]| {
            [Dither::blue(MASK).threshold_fx(a, b, c)]
        }),
        case(
            DITHER,
            "bd_dither_threshold_fx(bd_dither_origin(bd_dither_frame(bd_dither_blue(), d), e, f), a, b, c)",
            |[a, b, c, d, e, f]| [Dither::blue(MASK).frame(d).origin(e, f).threshold_fx(a, b, c)],
        ),
        case(DITHER, "bd_dither_level(bd_dither_blue(), a, b, c, d & 0xffffu, e & 0xffffu, f & 0xffffu)", |given| {
            let [a, b, c, d, e, f] = given;
            [Dither::blue(MASK).level(a, b, c, half(d), half(e), half(f)).into()]
        }),
        case(
            DITHER,
            "bd_dither_level(bd_dither_triangular(bd_dither_frame(bd_dither_blue(), e)), a, b, c, d & 255u, 255u, f & 31u)",
            |[a, b, c, d, e, f]| {
                let dither = Dither::blue(MASK).triangular().frame(e);
                [dither.level(a, b, c, half(d & 255), 255, half(f & 31)).into()]
            },
        ),
    ]
    .into_iter()
    .map(|case| case.with_read(bind::scalar(MASK)))
    .collect()
}
