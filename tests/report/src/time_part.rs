//! Ways through time, side by side: what frames leave by themselves and averaged, and what a pixel of a frame costs.

use crate::analysis::error::{ErrorImage, kernel_norm};
use crate::analysis::integrands::{
    Integrand, evaluation_half_plane_2d, evaluation_smooth_1d, evaluation_smooth_2d, evaluation_step_1d,
};
use crate::error_part::short;
use crate::paths;
use crate::table::Table;
use bluedither::frames::seeds;
use bluedither::{Dithered, White, candidate, hash, tables, unit};
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Pixels on a side.
const SIZE: usize = 128;
/// What a new frame weighs in the moving average.
const PART: f64 = 0.1;

/// D numbers of every pixel of a frame, row by row.
type Frame<'a, const D: usize> = &'a (dyn Fn(u32) -> Vec<[f64; D]> + Sync);
/// A way and its name.
type Way<'a, const D: usize> = (&'a str, Frame<'a, D>);

/// The tables of thresholds and of pairs, and of paths.
pub fn tables(seed: u32, quick: bool) -> Vec<Table> {
    let frames: &[u32] = if quick { &[1, 2, 4, 16] } else { &[1, 2, 4, 8, 16, 64] };
    let golden = |x, y, frame: u32| [tables::THRESHOLD_64.value_fx(x, y).wrapping_add(frame.wrapping_mul(0x9e37_79b9))];
    // The R2 sequence, M. Roberts 2018.
    let r2 = |x, y, frame: u32| {
        let [a, b] = tables::OFFSET_2D_64.value_fx(x, y);
        [a.wrapping_add(frame.wrapping_mul(0xc13f_a9a9)), b.wrapping_add(frame.wrapping_mul(0x91e1_0da5))]
    };
    let sampler = Dithered::new(seed);
    let singles: &[Way<1>] = &[
        ("white noise", &|frame| picture(|x, y| White::new(seed).pixel(x, y, frame).draw_fx(0, 0))),
        ("best candidate, anew", &|frame| candidates(hash::combine(seed, frame))),
        ("mask, place moved", &|frame| picture(|x, y| sampler.pixel(x, y, frame).draw_fx(0, 0))),
        ("mask, values moved (golden ratio)", &|frame| picture(|x, y| golden(x, y, frame))),
        ("masks over time, 64×64×16", &|frame| {
            picture(|x, y| [tables::THRESHOLD_OVER_TIME_64.frame(frame).value_fx(x, y)])
        }),
        ("the same for box:3+ema:0.1", &|frame| {
            picture(|x, y| [tables::THRESHOLD_FILTERED_OVER_TIME_64.frame(frame).value_fx(x, y)])
        }),
    ];
    let pairs: &[Way<2>] = &[
        ("white noise", &|frame| picture(|x, y| White::new(seed).pixel(x, y, frame).draw_fx(0, 0))),
        ("best candidate, anew", &|frame| candidates(hash::combine(seed, frame))),
        ("mask, place moved", &|frame| picture(|x, y| sampler.pixel(x, y, frame).draw_fx(0, 0))),
        ("mask, values moved (R2)", &|frame| picture(|x, y| r2(x, y, frame))),
        ("masks over time, 32×32×16", &|frame| {
            picture(|x, y| tables::OFFSET_2D_OVER_TIME_32.frame(frame).value_fx(x, y))
        }),
    ];
    let families = (evaluation_smooth_1d(), evaluation_step_1d(), evaluation_smooth_2d(), evaluation_half_plane_2d());
    let singles = table("thresholds", singles, [&families.0[..12], &families.1[..12]], frames, |[x]| x);
    let pairs = table("pairs", pairs, [&families.2[..12], &families.3[..12]], frames, |p| p);
    vec![singles, pairs, permutation(seed, quick)]
}

fn picture<const D: usize>(pixel: impl Fn(u32, u32) -> [u32; D]) -> Vec<[f64; D]> {
    (0..SIZE * SIZE).map(|p| pixel((p % SIZE) as u32, (p / SIZE) as u32).map(unit::to_f64)).collect()
}

fn candidates<const D: usize>(seed: u32) -> Vec<[f64; D]> {
    let mut rows = [[[0; D]; SIZE]; 3];
    let mut all = Vec::with_capacity(SIZE * SIZE);
    for y in 0..SIZE as u32 {
        let [above_2, above, row] = &mut rows;
        candidate::fill_row(seed, y, [above_2, above], row);
        all.extend(row.iter().map(|sample| sample.map(unit::to_f64)));
        rows.rotate_left(1);
    }
    all
}

/// A row a way: means of so many frames, a moving average, nanoseconds. `point` is what integrands are asked.
fn table<P: Send + Sync, const D: usize>(
    what: &str,
    ways: &[Way<D>],
    families: [&[Integrand<P>]; 2],
    counts: &[u32],
    point: impl Fn([f64; D]) -> P + Sync,
) -> Table {
    let last = counts[counts.len() - 1];
    // Of an integrand: the error of each mean and of the moving average, unfiltered and at sigma 1, squared.
    let measure = |frames: &[Vec<[f64; D]>], integrand: &Integrand<P>| {
        let mut image = ErrorImage { size: SIZE, errors: vec![0.0; SIZE * SIZE] };
        let (mut sums, mut moving) = (image.errors.clone(), image.errors.clone());
        let (mut found, mut weight) = (Vec::new(), 0.0);
        for (count, frame) in (1u32..).zip(frames) {
            weight = (1.0 - PART) * weight + PART;
            for (p, sample) in frame.iter().enumerate() {
                let error = integrand.at(point(*sample)) - integrand.exact;
                sums[p] += error;
                moving[p] += PART * (error - moving[p]);
            }
            if counts.contains(&count) {
                image.errors = sums.iter().map(|sum| sum / f64::from(count)).collect();
                found.push([image.rms().powi(2), image.filtered_rms(1.0).powi(2)]);
            }
        }
        image.errors = moving.iter().map(|error| error / weight).collect();
        found.push([image.rms().powi(2), image.filtered_rms(1.0).powi(2)]);
        found
    };
    let mut rows = Vec::new();
    let mut white: Vec<f64> = Vec::new();
    let norm = kernel_norm(SIZE, 1.0).powi(2);
    let all: Vec<&Integrand<P>> = families.iter().flat_map(|family| *family).collect();
    for (name, way) in ways {
        // Not from frame 0 on, which is the still mask.
        let frames: Vec<Vec<[f64; D]>> = (3..3 + last).into_par_iter().map(way).collect();
        let found: Vec<Vec<[f64; 2]>> = all.par_iter().map(|integrand| measure(&frames, integrand)).collect();
        if white.is_empty() {
            white = found.iter().map(|of_integrand| of_integrand[0][0]).collect();
        }
        let cell = |k: usize| {
            let left = |integrands: core::ops::Range<usize>, sigma: usize| {
                let count = integrands.len() as f64;
                let over = |i: usize| found[i][k][sigma] / white[i] / [1.0, norm][sigma];
                short((integrands.map(over).sum::<f64>() / count).sqrt())
            };
            let [smooth, steps] = [0..families[0].len(), families[0].len()..all.len()];
            format!("{} {} / {} {}", left(smooth.clone(), 0), left(smooth, 1), left(steps.clone(), 0), left(steps, 1))
        };
        let cells = (0..=counts.len()).map(cell);
        rows.push(core::iter::once((*name).to_string()).chain(cells).chain([nanoseconds(*way)]).collect());
    }
    let heads = counts.iter().map(u32::to_string).chain([format!("moving, {last}"), "ns".into()]);
    Table {
        id: format!("time-{what}"),
        title: format!("Ways through time, {what}"),
        about: format!(
            "Mean of so many frames, and a moving average that takes {PART} of each: error without a filter and after \
             sigma 1, of smooth integrands / of steps, over that of white noise in one frame. Nanoseconds a pixel and \
             frame, on one core."
        ),
        head: core::iter::once("mean of frames".into()).chain(heads).collect(),
        rows,
    }
}

fn nanoseconds<const D: usize>(way: Frame<D>) -> String {
    let once = |frame| {
        let start = Instant::now();
        black_box(way(black_box(frame)));
        start.elapsed().as_secs_f64() * 1e9 / (SIZE * SIZE) as f64
    };
    format!("{:.1}", (0..9).map(once).fold(f64::INFINITY, f64::min))
}

/// One picture of paths from a seed a pixel, and its error.
fn paths_of(seeds: &[u32], pan: f32, spp: u32) -> Vec<f32> {
    let pixel = |(p, &seed): (usize, &u32)| {
        let sampler = White::new(seed).pixel(0, 0, 0);
        let place = [p as u32 % SIZE as u32, p as u32 / SIZE as u32];
        let path = |index| paths::luminance(place, [SIZE as u32; 2], pan, |bounce| sampler.draw::<2>(bounce, index));
        (0..spp).map(path).sum::<f32>() / spp as f32
    };
    seeds.par_iter().enumerate().map(pixel).collect()
}

/// Seed permutation: paths of ten bounces through a whole room, whose corners are in the picture.
fn permutation(seed: u32, quick: bool) -> Table {
    const SPEEDS: [f32; 3] = [0.0, 0.5, 2.0];
    const FRAMES: u32 = 6;
    let first = |seed: u32| -> Vec<u32> { (0..(SIZE * SIZE) as u32).map(|p| hash::combine(seed, p)).collect() };
    let mut rows =
        vec![vec!["new white noise".to_string()], vec!["blocks of 4×4".into()], vec!["blocks of 8×8".into()]];
    for speed in SPEEDS {
        let pan = |frame: u32| speed * frame as f32;
        let exact = paths_of(&first(!seed), pan(FRAMES), if quick { 64 } else { 512 });
        let left = |image: &[f32]| {
            let errors = image.iter().zip(&exact).map(|(a, b)| f64::from(a - b)).collect();
            let image = ErrorImage { size: SIZE, errors };
            [1.0, 2.1].map(|sigma| image.filtered_rms(sigma))
        };
        let white = left(&paths_of(&first(hash::combine(seed, FRAMES)), pan(FRAMES), 1));
        for (row, permute) in rows.iter_mut().zip([None, Some(permute::<4> as Permute), Some(permute::<8>)]) {
            let Some(permute) = permute else {
                row.push("1.000 / 1.000".into());
                continue;
            };
            let mut seeds = first(seed);
            for frame in 0..FRAMES {
                let image = paths_of(&seeds, pan(frame), 1);
                permute(&mut seeds, &image, frame);
            }
            let found = left(&paths_of(&seeds, pan(FRAMES), 1));
            row.push(format!("{} / {}", short(found[0] / white[0]), short(found[1] / white[1])));
        }
    }
    let image = paths_of(&first(seed), 0.0, 1);
    let mut seeds = first(seed);
    let mut time = |permute: Permute| {
        let once = |frame| {
            let start = Instant::now();
            permute(black_box(&mut seeds), &image, frame);
            start.elapsed().as_secs_f64() * 1e9 / (SIZE * SIZE) as f64
        };
        format!("{:.1}", (0..9).map(once).fold(f64::INFINITY, f64::min))
    };
    let times = ["0".to_string(), time(permute::<4>), time(permute::<8>)];
    rows.iter_mut().zip(times).for_each(|(row, time)| row.push(time));
    Table {
        id: "time-paths".into(),
        title: "Seed permutation, paths of ten bounces".into(),
        about: format!(
            "After {FRAMES} frames of one sample a pixel: error of the next, after sigma 1 / 2.1, over that of white \
             noise. The camera stands, or pans so many pixels a frame; seeds stay where they are. {SIZE}×{SIZE} pixels \
             of a whole room; of finer pictures, whose neighbours are more alike, less is left."
        ),
        head: ["seeds", "still", "half a pixel", "two pixels", "ns"].map(String::from).to_vec(),
        rows,
    }
}

/// Moves the seeds by a frame's estimates.
type Permute = fn(&mut [u32], &[f32], u32);

fn permute<const SIDE: usize>(seeds: &mut [u32], image: &[f32], frame: u32) {
    seeds::permute::<SIDE>(seeds, image, SIZE as u32, frame);
}
