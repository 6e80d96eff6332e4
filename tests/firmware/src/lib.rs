//! Checksums of the families of functions that small machines take, the same on every machine.
#![no_std]

use bluedither::dither::{Samples, alpha, gamma, ordered, quantise};
use bluedither::tables::{OFFSET_2D_64, SOBOL_16, THRESHOLD_64};
use bluedither::{Constant, Dither, Dithered, Sampler, White, ZOrder};
use bluedither::{hash, lattice, linear, shift, sobol, strata, torus, unit, warp, zorder};

/// A family and how its checksum is made.
pub type Family = (&'static str, fn() -> u32);

/// All families.
pub const FAMILIES: [Family; 13] = [
    ("hash, unit, torus", integers),
    ("sobol, zorder, lattice, linear", sequences),
    ("strata, shift", offsets),
    ("masks", masks),
    ("warp", warps),
    ("sampler", || sampled!(Sampler::with_spp(3, 4))),
    ("sampler, progressive", || sampled!(Sampler::new(3))),
    ("dithered", || sampled!(Dithered::with_spp(3, 4))),
    ("z-order, white, constant", || {
        sampled!(ZOrder::new(3)) ^ sampled!(White::new(5)) ^ sampled!(Constant::with_spp(7, 4))
    }),
    ("dither, grey", grays),
    ("dither, colour", colors),
    ("dither, triangular", || rows(&Dither::blue(&THRESHOLD_64).triangular())),
    ("dither, gamma and float", converted),
];

macro_rules! sampled {
    ($sampler:expr) => {{
        let (sampler, mut sum) = ($sampler, 0);
        for k in 0..32 {
            let pixel = sampler.pixel(k * 5, k * 3, k / 8);
            for word in pixel.draw_fx::<4>(k % 4, k) {
                sum = hash::combine(sum, word);
            }
            sum = hash::combine(sum, pixel.draw::<1>(k % 3, k)[0].to_bits());
        }
        sum
    }};
}
use sampled;

fn fold(words: impl IntoIterator<Item = u32>) -> u32 {
    words.into_iter().fold(1, hash::combine)
}

fn integers() -> u32 {
    fold((0..99).flat_map(|k| {
        let v = hash::mix(k);
        let float = unit::to_f32(v);
        let long = hash::mix_64(u64::from(v));
        [hash::owen(v, k), hash::owen_4(v, k), hash::shuffle(v, k), float.to_bits(), unit::from_f32(float), long as u32]
            .into_iter()
            .chain(torus::offset(v, k, 1, k, 6))
    }))
}

fn sequences() -> u32 {
    fold((0..99).flat_map(|k| {
        let v = hash::mix(k);
        let point = sobol::owen_point(k, v);
        [point[0], point[1], sobol::dimension(k, 1), SOBOL_16.dimension(k, 7), zorder::morton_16(k, v)]
            .into_iter()
            .chain([zorder::first_index(v), lattice::extensible(k, v), lattice::fixed(k, 99, v)])
            .chain([linear::digits(&[v; 10], k, v)])
    }))
}

fn offsets() -> u32 {
    fold((1..99).flat_map(|k| {
        let v = hash::mix(k);
        let [a, b] = shift::stratified_2d(v % k, k, [v, k], [k, v]);
        [a, b, shift::stratified_1d(v % k, k, v, v), strata::permute(v, k, v), strata::turn(v, k, v)]
    }))
}

fn masks() -> u32 {
    fold((0..4096).flat_map(|p| {
        let [a, b] = OFFSET_2D_64.value_fx(p % 64, p / 64);
        [THRESHOLD_64.value_fx(p % 64, p / 64), a, b]
    }))
}

fn warps() -> u32 {
    fold((0..64).flat_map(|k| {
        let u = unit::to_f32s([hash::mix(k), hash::mix(!k)]);
        let ([a, b], [c, d, e], [f, g]) = (warp::disk(u), warp::sphere(u), warp::gaussian(u));
        let [h, i, j] = warp::cosine_hemisphere(u);
        [a, b, c, d, e, f, g, h, i, j].map(f32::to_bits)
    }))
}

/// 200 numbers a row, every way to choose thresholds.
fn dithers() -> [Dither<'static>; 5] {
    let blue = Dither::blue(&THRESHOLD_64);
    [Dither::constant(1 << 31), Dither::random(3), Dither::ordered(3), blue, blue.frame(7).origin(3, u32::MAX)]
}

fn grays() -> u32 {
    let source: [u8; 200] = core::array::from_fn(|x| hash::mix(x as u32) as u8);
    let wide: [u16; 200] = core::array::from_fn(|x| hash::mix(x as u32) as u16);
    let mut sum = ordered::value_fx(5, 9, 7);
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

fn colors() -> u32 {
    dithers().iter().fold(0, |sum, dither| hash::combine(sum, rows(dither)))
}

fn rows(dither: &Dither<'_>) -> u32 {
    let source: [u8; 240] = core::array::from_fn(|x| hash::mix(x as u32) as u8);
    let mut wide = [0; 180];
    let (mut bytes, mut words, mut levels) = ([0; 80], [0; 80], [[0; 3]; 80]);
    let mut sum = quantise::triangular(1 << 20) as u32;
    for y in 0..4 {
        let mut errors = dither.rgb332_row(y, &source, &mut bytes).is_err() as u32;
        errors += dither.rgb565_row(y, &source, &mut words).is_err() as u32;
        errors += dither.levels_row(y, &source, [3, 7, 200], &mut levels).is_err() as u32;
        errors += dither.stencil_row(y, &source, &mut bytes[70..]).is_err() as u32;
        errors += alpha::over_row(&source, [1, 2, 3], &mut wide).is_err() as u32;
        errors += dither.rgb565_row(y, &wide, &mut words[..60]).is_err() as u32;
        sum = hash::combine(sum, errors);
        sum = hash::combine(sum, fold(bytes.into_iter().chain(levels.into_iter().flatten()).map(u32::from)));
        sum = hash::combine(sum, fold(words.map(u32::from)));
    }
    sum
}

fn converted() -> u32 {
    let source: [f32; 180] = core::array::from_fn(|x| unit::to_f32(hash::mix(x as u32)));
    let (dither, mut words) = (Dither::blue(&THRESHOLD_64), [0; 60]);
    let errors = dither.rgb565_row(9, &source, &mut words).is_err() as u32;
    let sum = hash::combine(fold(words.map(u32::from)), errors);
    let light = fold((0..999).map(|v| u32::from(gamma::to_linear(v * 65)) << 16 | u32::from(gamma::from_linear(v * 65))));
    hash::combine(sum, hash::combine(light, rows(&dither.gamma())))
}

/// One row of 400 pixels of grey to 1 bit, for counting instructions; the first byte.
#[inline(never)]
pub fn one_row(y: u32, source: &[u8; 400], bits: &mut [u8; 50]) -> u8 {
    match Dither::blue(&THRESHOLD_64).gray1_row(y, source, bits) {
        Ok(()) => bits[0],
        Err(_) => 0,
    }
}
