//! Over time, and best candidates.

use bluedither::frames::masks::{TimeMask, VectorTimeMask};
use bluedither::frames::seeds::{Rows, begins_block, permute, retarget, sort};
use bluedither::tables::{SEED_PERMUTATION, THRESHOLD_OVER_TIME_32};
use bluedither::{ScalarMask, VectorMask, candidate};

/// Pictures of any size.
#[unsafe(no_mangle)]
pub extern "C" fn frames(seeds: &mut [u32; 99], n: usize, estimates: &[f32; 99], width: u32, first: u32, frame: u32) {
    let (Some(seeds), Some(estimates)) = (seeds.get_mut(..n), estimates.get(..n)) else { return };
    let rows = Rows { width, first };
    sort::<2>(seeds, estimates, rows, frame);
    sort::<4>(seeds, estimates, rows, frame);
    sort::<8>(seeds, estimates, rows, frame);
    retarget(seeds, rows, frame);
    permute::<8>(seeds, estimates, width, frame);
    let (pairs, _) = seeds.as_chunks_mut::<2>();
    candidate::fill_row(frame, first, [&[[1, 2]], &[]], pairs);
    let (fours, _) = seeds.as_chunks_mut::<4>();
    candidate::fill_row(frame, first, [&[], &[[1, 2, 3, 4]; 7]], fours);
}

/// Masks over time, and where seeds go.
#[unsafe(no_mangle)]
pub extern "C" fn places(x: u32, y: u32, frame: u32) -> u32 {
    static MASK: ScalarMask<2> = ScalarMask::new([[0, 1], [2, 3]]);
    static OWN: TimeMask<'_, 2, 2> = TimeMask::new([&MASK, &MASK]);
    let mut sum = THRESHOLD_OVER_TIME_32.frame(frame).value_fx(x, y) ^ OWN.frames()[1].value_fx(x, y);
    static PAIR: VectorMask<2, 2> = VectorMask::new([[[0, 1], [1, 0]], [[2, 3], [3, 2]]]);
    static PAIRS: VectorTimeMask<'_, 2, 2> = VectorTimeMask::new([&PAIR, &PAIR]);
    sum ^= PAIRS.frame(frame).value_fx(x, y)[0] ^ PAIRS.frames()[1].value_fx(x, y)[1];
    sum ^= SEED_PERMUTATION.rounds();
    sum ^= SEED_PERMUTATION.place(frame)[1] ^ u32::from(SEED_PERMUTATION.codes()[3][4]);
    sum ^= SEED_PERMUTATION.partner(frame, x, y).map_or(0, |(right, down)| right as u32 ^ down as u32);
    sum ^ u32::from(begins_block::<4>(y, frame))
}
