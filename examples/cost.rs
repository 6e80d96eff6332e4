//! What a number costs: nanoseconds per number, for every sampler and for plain mask look-ups.
//!
//! `cargo run --release --example cost` renders nothing: it draws all numbers of a 256×256 image in row order, sums
//! them up, and prints the median of several rounds, which take turns so that a busy moment hits all alike.
#![allow(clippy::std_instead_of_core, reason = "an example on the host")]

use std::hint::black_box;
use std::time::Instant;

use bluedither::tables::{OFFSET_2D_64, THRESHOLD_64};
use bluedither::{Constant, Dithered, Sampler, White, ZOrder};

const SIZE: u32 = 256;
const ROUNDS: usize = 15;
const SPP: [u32; 3] = [1, 4, 16];

/// A way to get numbers: its name, numbers a call, and the sum over an image at some samples per pixel.
type Row = (&'static str, u32, fn(u32) -> f32);

macro_rules! draws {
    ($dimensions:literal, |$spp:ident| $sampler:expr) => {
        |$spp| {
            let sampler = black_box($sampler);
            image(|x, y| {
                let pixel = sampler.pixel(x, y, 0);
                (0..$spp).map(|index| pixel.draw::<$dimensions>(0, index).iter().sum::<f32>()).sum()
            })
        }
    };
}

const ROWS: [Row; 17] = [
    ("threshold mask, look-up", 1, |spp| (0..spp).map(|_| image(|x, y| THRESHOLD_64.value(x, y))).sum()),
    ("offset mask, look-up", 2, |spp| (0..spp).map(|_| image(|x, y| OFFSET_2D_64.value(x, y).iter().sum())).sum()),
    ("Sampler::with_spp, 1D", 1, draws!(1, |spp| Sampler::with_spp(1, spp))),
    ("Sampler::with_spp, 2D", 2, draws!(2, |spp| Sampler::with_spp(1, spp))),
    ("Sampler::with_spp, 4D", 4, draws!(4, |spp| Sampler::with_spp(1, spp))),
    ("Dithered::with_spp, 1D", 1, draws!(1, |spp| Dithered::with_spp(1, spp))),
    ("Dithered::with_spp, 2D", 2, draws!(2, |spp| Dithered::with_spp(1, spp))),
    ("Dithered::with_spp, 4D", 4, draws!(4, |spp| Dithered::with_spp(1, spp))),
    ("Dithered::new, 1D", 1, draws!(1, |spp| Dithered::new(1))),
    ("Dithered::stratified, 1D", 1, draws!(1, |spp| Dithered::new(1).stratified(spp))),
    ("Dithered::stratified, 2D", 2, draws!(2, |spp| Dithered::new(1).stratified(spp))),
    ("White, 1D", 1, draws!(1, |spp| White::new(1))),
    ("White, 2D", 2, draws!(2, |spp| White::new(1))),
    ("White, 4D", 4, draws!(4, |spp| White::new(1))),
    ("ZOrder, 2D", 2, draws!(2, |spp| ZOrder::with_spp(1, spp))),
    ("ZOrder, 4D", 4, draws!(4, |spp| ZOrder::with_spp(1, spp))),
    ("Constant, 2D", 2, draws!(2, |spp| Constant::new(1))),
];

fn image(mut value: impl FnMut(u32, u32) -> f32) -> f32 {
    (0..SIZE).map(|y| (0..SIZE).map(|x| value(x, y)).sum::<f32>()).sum()
}

fn main() {
    println!("Nanoseconds per number, median of {ROUNDS}, at samples per pixel:\n");
    println!("| | {} |", SPP.map(|spp| spp.to_string()).join(" | "));
    println!("|---|---|---|---|");
    let mut times = vec![[const { Vec::new() }; SPP.len()]; ROWS.len()];
    for _ in 0..ROUNDS {
        for (&(_, numbers, sum), times) in ROWS.iter().zip(&mut times) {
            for (&spp, times) in SPP.iter().zip(times) {
                let start = Instant::now();
                black_box(sum(black_box(spp)));
                times.push(start.elapsed().as_secs_f64() * 1e9 / f64::from(SIZE * SIZE * spp * numbers));
            }
        }
    }
    for ((name, ..), times) in ROWS.iter().zip(times) {
        let medians = times.map(|mut times| {
            times.sort_by(f64::total_cmp);
            format!("{:.1}", times[ROUNDS / 2])
        });
        println!("| {name} | {} |", medians.join(" | "));
    }
}
