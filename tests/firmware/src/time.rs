//! Frames, and pixels that know those before them.

use crate::fold;
use bluedither::frames::masks::TimeMask;
use bluedither::frames::seeds::{Rows, begins_block, permute, retarget, sort};
use bluedither::{Dither, ScalarMask, candidate as best, hash};

/// Two frames of a mask: baked ones are too large for the smallest machine.
static MASK: TimeMask<'_, 4, 2> = TimeMask::new([&FRAMES[0], &FRAMES[1]]);
static FRAMES: [ScalarMask<4>; 2] = {
    let mut ranks = [[[0; 4]; 4]; 2];
    let mut k = 0;
    while k < 16 {
        ranks[0][k / 4][k % 4] = (k * 7 % 16) as u16;
        ranks[1][k / 4][k % 4] = (k * 11 % 16) as u16;
        k += 1;
    }
    [ScalarMask::new(ranks[0]), ScalarMask::new(ranks[1])]
};

pub(crate) fn masks() -> u32 {
    fold((0..99).flat_map(|k| {
        let mask = MASK.frame(k);
        [mask.value_fx(k, k / 4), Dither::blue(mask).threshold_fx(k, 3, 0), u32::from(MASK.frames()[1].rank(k, 1))]
    }))
}

pub(crate) fn seeds() -> u32 {
    let mut seeds: [u32; 21 * 9] = core::array::from_fn(|k| hash::mix(k as u32));
    let mut estimates: [f32; 21 * 9] = core::array::from_fn(|k| f32::from_bits(hash::mix(!k as u32)));
    estimates[7] = f32::NAN;
    let mut sum = 0;
    for frame in 0..5 {
        let rows = Rows { width: 21, first: 3 * frame };
        sort::<2>(&mut seeds, &estimates, rows, frame);
        sort::<4>(&mut seeds, &estimates[..100], rows, frame);
        permute::<8>(&mut seeds, &estimates, 20, frame);
        retarget(&mut seeds, rows, frame);
        sum = hash::combine(sum, fold(seeds));
        sum = hash::combine(sum, u32::from(begins_block::<4>(frame, frame)));
    }
    sum
}

pub(crate) fn candidate() -> u32 {
    let mut rows = [[[0; 3]; 8]; 3];
    fold((0..5).flat_map(|y| {
        let [above_2, above, row] = &mut rows;
        best::fill_row(7, y, [above_2, above], row);
        rows.rotate_left(1);
        rows[2].into_iter().flatten()
    }))
}
