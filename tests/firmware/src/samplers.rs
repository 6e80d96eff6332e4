//! Draws, fills and rows of every sampler.

use bluedither::tables::{OFFSET_2D_64, THRESHOLD_64};
use bluedither::{Dithered, Keyed, Keys, Sampler, White, hash};

/// A checksum of fixed-point numbers by every public way to get them.
macro_rules! sampled {
    ($sampler:expr) => {{
        let (sampler, mut sum) = ($sampler, 0);
        for k in 0..32 {
            let pixel = sampler.pixel(k * 5, u32::MAX - k * 3, k / 8);
            let (one, two, three) =
                (pixel.draw_fx::<1>(k % 3, k), pixel.draw_fx::<2>(k, k << 27), pixel.draw_fx::<3>(!k, !k));
            let (mut filled, mut row) = ([[0; 5]; 5], [[0; 6]; 5]);
            pixel.fill_fx(k, k, &mut filled);
            sampler.fill_row_fx(k, k, k, k, k, &mut row);
            let words = pixel.draw_fx::<8>(k % 4, k).into_iter().chain(one).chain(two).chain(three);
            let words = words.chain(filled.into_iter().flatten()).chain(row.into_iter().flatten());
            sum = hash::combine(sum, crate::fold(words));
        }
        sum
    }};
}

pub(crate) fn sampler() -> u32 {
    [1, 4, 100, 256].into_iter().fold(0, |sum, spp| hash::combine(sum, sampled!(Sampler::with_spp(3, spp))))
}

pub(crate) fn progressive() -> u32 {
    sampled!(Sampler::new(3))
}

pub(crate) fn dithered() -> u32 {
    sampled!(Dithered::new(3)) ^ sampled!(Dithered::with_spp(3, 4)).rotate_left(1)
}

pub(crate) fn stratified() -> u32 {
    let masked = Dithered::with_masks(&THRESHOLD_64, &OFFSET_2D_64, 3);
    sampled!(masked.stratified(5)) ^ sampled!(masked.stratified(5).global()).rotate_left(1)
}

pub(crate) fn white() -> u32 {
    sampled!(White::new(5))
}

pub(crate) fn keyed() -> u32 {
    static KEYS: Keys<4> = Keys::new([[[1, 2], [0x3333, 4], [5, 0x6666], [7, 8]]; 4]);
    sampled!(Keyed::new(3)) ^ sampled!(Keyed::with_keys(&KEYS, 3)).rotate_left(1)
}

pub(crate) fn lattice() -> u32 {
    sampled!(Dithered::lattice(3)) ^ sampled!(Dithered::new(3).on_lattice()).rotate_left(1)
}
