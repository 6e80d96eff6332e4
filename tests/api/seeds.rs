//! Seed permutation: no seed is ever lost, blocks are in the order of the mask, and what it is for.
#![cfg(all(feature = "seed-permutation", feature = "warp"))] // which the room of paths needs

use crate::analysis::SIGMAS;
use crate::analysis::error::ErrorImage;
use crate::analysis::random::Random;
use bluedither::frames::seeds::{self, Rows};
use bluedither::tables::{SEED_PERMUTATION, THRESHOLD_64};
use bluedither::{White, hash};
use proptest::prelude::*;

fn estimates(count: usize, seed: u64) -> Vec<f32> {
    let special = [f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, f32::MAX, f32::MIN_POSITIVE];
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| {
            // Any float at all, often one of the special ones, often an equal one.
            let choice = random.below(24);
            special.get(choice).copied().unwrap_or_else(|| f32::from_bits(random.bits_32() & [!0, 7][choice & 1]))
        })
        .collect()
}

fn all_are_there(seeds: &[u32]) -> bool {
    let mut sorted = seeds.to_vec();
    sorted.sort_unstable();
    sorted.iter().enumerate().all(|(i, &seed)| i as u32 == seed)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the size, the part, the frame and the estimates: each step is a bijection.
    #[test]
    fn no_seed_is_lost(
        width in 0u32..40,
        count in 0usize..900,
        missing in 0usize..50,
        first in prop_oneof![0u32..200, Just(u32::MAX), Just(u32::MAX - 5), any::<u32>()],
        frame in prop_oneof![0u32..130, Just(u32::MAX), any::<u32>()],
        seed in any::<u64>(),
    ) {
        let rows = Rows { width, first };
        let mut seeds: Vec<u32> = (0..count as u32).collect();
        for step in 0..3u32 {
            let estimates = estimates(count.saturating_sub(missing), seed ^ u64::from(step));
            let frame = frame.wrapping_add(step);
            seeds::sort::<2>(&mut seeds, &estimates, rows, frame);
            prop_assert!(all_are_there(&seeds));
            seeds::sort::<4>(&mut seeds, &estimates, rows, frame);
            prop_assert!(all_are_there(&seeds));
            seeds::sort::<8>(&mut seeds, &estimates, rows, frame);
            prop_assert!(all_are_there(&seeds));
            seeds::retarget(&mut seeds, rows, frame);
            prop_assert!(all_are_there(&seeds));
        }
    }
}

/// Sorting as the paper says it, with lists of pixels. Blocks begin at multiples of SIDE less `origin`.
fn twin<const SIDE: usize>(seeds: &mut [u32], estimates: &[f32], rows: Rows, frame: u32, origin: [usize; 2]) {
    let width = rows.width as usize;
    let block = |p: &usize| {
        let (x, y) = (p % width, p / width + rows.first as usize);
        [(y + origin[1]) / SIDE, (x + origin[0]) / SIDE]
    };
    let mut blocks: Vec<_> = (0..seeds.len()).map(|p| block(&p)).collect();
    blocks.sort_unstable();
    blocks.dedup();
    let before = seeds.to_vec();
    for number in blocks {
        let mut dark: Vec<usize> = (0..seeds.len()).filter(|p| block(p) == number).collect();
        let mut low = dark.clone();
        dark.sort_by(|&p, &q| estimates[p].total_cmp(&estimates[q]));
        let [dx, dy] = SEED_PERMUTATION.place(frame);
        low.sort_by_key(|&p| THRESHOLD_64.rank(p as u32 % rows.width + dx, p as u32 / rows.width + rows.first + dy));
        dark.iter().zip(low).for_each(|(&from, to)| seeds[to] = before[from]);
    }
}

#[test]
fn blocks_are_sorted_as_the_paper_says() {
    fn check<const SIDE: usize>() {
        let half = SIDE / 2;
        let mut seen = Vec::new();
        for (width, height, first) in [(1, 1, 0), (8, 8, 0), (13, 7, 3), (64, 70, 0), (3, 100, 17), (70, 9, 5)] {
            for (frame, origin) in [(0, [0, 0]), (1, [half, half]), (6, [0, half]), (11, [half, 0])] {
                let rows = Rows { width, first };
                let estimates = estimates((width * height) as usize, u64::from(width + frame));
                let mut ours: Vec<u32> = (0..width * height).collect();
                let mut theirs = ours.clone();
                seeds::sort::<SIDE>(&mut ours, &estimates, rows, frame);
                twin::<SIDE>(&mut theirs, &estimates, rows, frame, origin);
                assert_eq!(ours, theirs, "{SIDE}: {width}x{height} from row {first}, frame {frame}");
                let start = (first..first + 2 * SIDE as u32).find(|&row| seeds::begins_block::<SIDE>(row, frame));
                assert_eq!((start.expect("a block") as usize + origin[1]) % SIDE, 0);
                seen.push(origin);
            }
        }
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen.len(), 4, "blocks begin elsewhere in every frame");
    }
    check::<2>();
    check::<4>();
    check::<8>();
}

/// A part is retargeted as it is in the whole, but for six rows where it begins: two a round miss their partners.
#[test]
fn parts_are_retargeted_where_they_stand() {
    let (width, first, height) = (70u32, 21u32, 64u32);
    for frame in [0, 5] {
        let mut whole: Vec<u32> = (0..width * (first + height)).collect();
        let mut part = whole.split_off((width * first) as usize);
        whole.extend_from_slice(&part);
        seeds::retarget(&mut whole, Rows { width, first: 0 }, frame);
        seeds::retarget(&mut part, Rows { width, first }, frame);
        let common = (width * (height - 6)) as usize;
        assert!(whole[whole.len() - common..] == part[part.len() - common..], "frame {frame}");
    }
}

#[test]
fn parts_give_what_the_whole_does() {
    let (width, height) = (37u32, 41u32);
    for frame in 0..8 {
        let estimates = estimates((width * height) as usize, 5);
        let mut whole: Vec<u32> = (0..width * height).collect();
        let mut parts = whole.clone();
        seeds::sort::<8>(&mut whole, &estimates, Rows { width, first: 0 }, frame);
        let starts: Vec<u32> =
            (0..height).filter(|&row| row == 0 || row % 3 == 0 && seeds::begins_block::<8>(row, frame)).collect();
        assert!(starts.len() > 1, "several parts");
        for (i, &first) in starts.iter().enumerate() {
            let end = starts.get(i + 1).copied().unwrap_or(height);
            let part = (first * width) as usize..(end * width) as usize;
            seeds::sort::<8>(&mut parts[part.clone()], &estimates[part], Rows { width, first }, frame);
        }
        assert_eq!(whole, parts, "frame {frame}");
    }
}

#[test]
fn nothing_happens_without_whole_rows() {
    for width in [0, 5, u32::MAX] {
        let mut seeds = [3, 1, 2];
        seeds::permute::<8>(&mut seeds, &[0.3, 0.1, 0.2], width, 1);
        assert_eq!(seeds, [3, 1, 2], "{width}");
    }
}

/// In every round each place is in one pair at most.
#[test]
fn swaps_are_disjoint() {
    for round in 0..SEED_PERMUTATION.rounds() {
        let mut pairs = vec![0; 4096];
        for p in 0..4096u32 {
            if let Some((right, down)) = SEED_PERMUTATION.partner(round, p & 63, p >> 6) {
                assert!(right.abs() <= 2 && down <= 2 && (down > 0 || right > 0), "{right}, {down}");
                let (x, y) = ((p as usize % 64 + 64).wrapping_add_signed(right) % 64, (p as usize / 64 + down) % 64);
                let q = y * 64 + x;
                pairs[p as usize] += 1;
                pairs[q] += 1;
            }
        }
        assert!(pairs.iter().all(|&count| count <= 1), "round {round}");
        println!("round {round}: {} pairs", pairs.iter().sum::<i32>() / 2);
    }
    assert_eq!(SEED_PERMUTATION.partner(SEED_PERMUTATION.rounds(), 0, 0), None);
    assert_eq!(SEED_PERMUTATION.partner(u32::MAX, 0, 0), None);
}

/// What stands in one frame's order of the mask stands nearly in the next one's: within .05 of the range, of .41
/// before.
#[test]
fn retargeting_follows_the_mask() {
    const SIZE: u32 = 128;
    for frame in [0, 1, 77, u32::MAX] {
        let order = |frame: u32| -> Vec<u32> {
            let [dx, dy] = SEED_PERMUTATION.place(frame);
            let rank = |p: u32| THRESHOLD_64.rank((p % SIZE).wrapping_add(dx), (p / SIZE).wrapping_add(dy)).into();
            (0..SIZE * SIZE).map(rank).collect()
        };
        let (before, wanted) = (order(frame), order(frame.wrapping_add(1)));
        let mut after = before.clone();
        seeds::retarget(&mut after, Rows { width: SIZE, first: 0 }, frame);
        let apart = |a: &[u32]| {
            // Pairs that reach beyond an edge stay: without the six pixels along it.
            let inside = |p: &u32| [p % SIZE, p / SIZE].iter().all(|c| (6..SIZE - 6).contains(c));
            let apart = |p: u32| f64::from(a[p as usize].abs_diff(wanted[p as usize])) / 4096.0;
            let squares: Vec<f64> = (0..SIZE * SIZE).filter(inside).map(|p| apart(p).powi(2)).collect();
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        };
        println!("frame {frame}: {:.3} before, {:.3} after", apart(&before), apart(&after));
        assert!(apart(&before) > 0.38, "frame {frame}: places of successive frames have nothing in common");
        assert!(apart(&after) < 0.05, "frame {frame}: {}", apart(&after));
    }
}

/// Side of the part of the picture that is rendered below, and lines of the whole.
const SIZE: usize = 128;
const LINES: u32 = 512;

/// One picture of paths of ten bounces, from one seed a pixel.
fn render(seeds: &[u32], pan: f32, spp: u32) -> Vec<f32> {
    let corner = (LINES - SIZE as u32) / 2;
    let pixel = |(p, &seed): (usize, &u32)| {
        let sampler = White::new(seed).pixel(0, 0, 0);
        let place = [(p % SIZE) as u32 + corner, (p / SIZE) as u32 + corner];
        let path = |index| crate::paths::luminance(place, [LINES; 2], pan, |bounce| sampler.draw::<2>(bounce, index));
        (0..spp).map(path).sum::<f32>() / spp as f32
    };
    seeds.iter().enumerate().map(pixel).collect()
}

fn first_seeds(seed: u32) -> Vec<u32> {
    (0..(SIZE * SIZE) as u32).map(|p| hash::combine(seed, p)).collect()
}

/// The filtered error of a frame over that of white noise, at both sigmas, with the second step or without. White is
/// the first frame.
fn after_frames<const SIDE: usize>(frames: u32, retarget: bool, exact: &[f32]) -> [f64; 2] {
    let error = |image: &[f32]| ErrorImage {
        size: SIZE,
        errors: image.iter().zip(exact).map(|(&a, &b)| f64::from(a) - f64::from(b)).collect(),
    };
    let mut seeds = first_seeds(1);
    let mut image = render(&seeds, 0.0, 1);
    let white = error(&image);
    for frame in 0..frames {
        if retarget {
            seeds::permute::<SIDE>(&mut seeds, &image, SIZE as u32, frame);
        } else {
            seeds::sort::<SIDE>(&mut seeds, &image, Rows { width: SIZE as u32, first: 0 }, frame);
        }
        image = render(&seeds, 0.0, 1);
    }
    SIGMAS.map(|sigma| error(&image).filtered_rms(sigma) / white.filtered_rms(sigma))
}

/// Twenty dimensions, one sample a pixel, a static picture: the part of a wall that lies in its middle, since what
/// counts is how alike neighbouring pixels are. With corners in it and half as many lines, .5 to .6 is left.
#[test]
fn six_frames_halve_the_filtered_error_of_paths() {
    let exact = render(&first_seeds(99), 0.0, 64);
    let eight = after_frames::<8>(6, true, &exact);
    let four = after_frames::<4>(6, true, &exact);
    let sorted = [after_frames::<8>(6, false, &exact), after_frames::<4>(6, false, &exact)];
    println!("8x8 {eight:.3?}, 4x4 {four:.3?}; by sorting alone {sorted:.3?}");
    assert!(eight[0] <= 0.52 && eight[1] <= 0.48, "8x8: {eight:?}");
    assert!(four[0] <= 0.48 && four[1] <= 0.56, "4x4, which sorting alone does not reach: {four:?}");
    assert!(
        sorted[0][0] < eight[0] && sorted[0][1] > eight[1],
        "8x8: narrow by sorting alone, wide by both: {sorted:?}"
    );
    assert!(sorted[1][0] > 0.48, "4x4 by sorting alone: {sorted:?}");
}
