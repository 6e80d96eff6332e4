//! Where fixed point becomes a float, and what takes floats.

use crate::fold;
#[cfg(feature = "float")]
use bluedither::Dither;
use bluedither::tables::{OFFSET_2D_64, THRESHOLD_64};
use bluedither::{Sampler, White, hash, unit, warp};

pub(crate) fn samplers() -> u32 {
    let mut sum = crate::parts::conversions();
    for k in 0..32 {
        let pixel = Sampler::with_spp(3, 4).pixel(k, k, k);
        let (mut filled, mut row) = ([[0.0; 3]; 5], [[0.0; 2]; 5]);
        pixel.fill(k, k, &mut filled);
        White::new(k).fill_row(k, k, k, k, k, &mut row);
        let words = pixel.draw::<4>(k % 4, k).into_iter().chain(filled.into_iter().flatten());
        let words = words.chain(row.into_iter().flatten()).chain([THRESHOLD_64.value(k, 1)]);
        let words = words.chain(OFFSET_2D_64.value(k, 1)).chain(pixel.pattern::<2, 9>(k, k).into_iter().flatten());
        sum = hash::combine(sum, fold(words.map(f32::to_bits)));
    }
    sum
}

pub(crate) fn warps() -> u32 {
    fold((0..64).flat_map(|k| {
        let u = unit::to_f32s([hash::mix(k), hash::mix(!k)]);
        let ([a, b], [c, d, e], [f, g]) = (warp::disk(u), warp::sphere(u), warp::gaussian(u));
        let ([h, i, j], [k, l, m], [n, o, p]) =
            (warp::cosine_hemisphere(u), warp::uniform_hemisphere(u), warp::triangle(u));
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p].map(f32::to_bits)
    }))
}

#[cfg(feature = "float")]
pub(crate) fn rows() -> u32 {
    let mut source: [f32; 180] = core::array::from_fn(|x| unit::to_f32(hash::mix(x as u32)));
    [source[0], source[1], source[2]] = [f32::NAN, f32::NEG_INFINITY, 9.0];
    let (dither, mut words) = (Dither::blue(&THRESHOLD_64), [0; 60]);
    let errors = dither.rgb565_row(9, &source, &mut words).is_err() as u32;
    hash::combine(fold(words.map(u32::from)), errors)
}
