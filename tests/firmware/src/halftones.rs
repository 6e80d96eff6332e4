//! Rows of every format, by every way to choose thresholds.

use crate::fold;
use bluedither::dither::{Samples, alpha, gamma as light, ordered, quantise};
use bluedither::tables::THRESHOLD_64;
use bluedither::{Dither, hash};

fn dithers() -> [Dither<'static>; 6] {
    let blue = Dither::blue(&THRESHOLD_64);
    let moved = blue.frame(7).origin(3, u32::MAX);
    [Dither::constant(1 << 31), Dither::random(3), Dither::ordered(3), Dither::ordered(9), blue, moved]
}

pub(crate) fn grays() -> u32 {
    let source: [u8; 200] = core::array::from_fn(|x| hash::mix(x as u32) as u8);
    let wide: [u16; 200] = core::array::from_fn(|x| hash::mix(x as u32) as u16);
    let mut sum = fold((0..20).map(|k| ordered::value_fx(5, 9, k)));
    for dither in dithers() {
        for y in 0..4 {
            let mut dst = [0; 100];
            for row in [Samples::U8(&source), Samples::U10(&wide), Samples::U12(&wide), Samples::U16(&wide)] {
                let done = [dither.gray1_row(y, row, &mut dst), dither.gray2_row(y, row, &mut dst[26..])];
                sum = hash::combine(sum, done.iter().filter(|done| done.is_err()).count() as u32);
                sum = hash::combine(sum, fold(dst.map(u32::from)));
                sum = hash::combine(sum, dither.gray4_row(y, row, &mut dst).is_err() as u32);
                sum = hash::combine(sum, fold(dst.map(u32::from)));
            }
        }
    }
    sum
}

pub(crate) fn colors() -> u32 {
    dithers().iter().fold(0, |sum, dither| hash::combine(sum, rows(dither)))
}

pub(crate) fn triangular() -> u32 {
    let noise = fold((0..99).map(|k| quantise::triangular(hash::mix(k)) as u32));
    hash::combine(noise, rows(&Dither::blue(&THRESHOLD_64).triangular()))
}

pub(crate) fn gamma() -> u32 {
    let both = |v: u16| u32::from(light::to_linear(v * 65)) << 16 | u32::from(light::from_linear(v * 65));
    hash::combine(fold((0..999).map(both)), rows(&Dither::blue(&THRESHOLD_64).gamma()))
}

fn rows(dither: &Dither<'_>) -> u32 {
    let source: [u8; 240] = core::array::from_fn(|x| hash::mix(x as u32) as u8);
    let mut wide = [0; 180];
    let (mut bytes, mut words, mut levels) = ([0; 180], [0; 80], [[0; 3]; 80]);
    let mut sum = u32::from(dither.level(3, 4, 5, 6000, 40000, 700));
    for y in 0..4 {
        let mut errors = dither.rgb332_row(y, &source, &mut bytes).is_err() as u32;
        errors += dither.rgb565_row(y, &source, &mut words).is_err() as u32;
        errors += dither.levels_row(y, &source, [3, 7, 200], &mut levels).is_err() as u32;
        errors += dither.stencil_row(y, &source, &mut bytes[70..]).is_err() as u32;
        sum = hash::combine(sum, fold(bytes.into_iter().chain(levels.into_iter().flatten()).map(u32::from)));
        errors += alpha::over_row(&source, [1, 2, 3], &mut wide).is_err() as u32;
        errors += dither.rgb888_row(y, &wide, &mut bytes).is_err() as u32;
        errors += dither.rgb565_row(y, &wide, &mut words[..60]).is_err() as u32;
        errors += dither.rgb565_row(y, &wide, &mut words[..59]).is_err() as u32;
        sum = hash::combine(sum, errors);
        sum = hash::combine(sum, fold(bytes.map(u32::from).into_iter().chain(words.map(u32::from))));
        sum = hash::combine(sum, u32::from(quantise::value(y as u16, 9999, 7)));
    }
    sum
}
