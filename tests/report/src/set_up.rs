//! What a pixel costs before its first number: medians of rounds in which all samplers take turns.

use crate::samplers;
use crate::shape::{Sampler, Task};
use crate::speed::median;
use crate::table::Table;
use std::hint::black_box;
use std::time::Instant;

/// Pixels of one measurement, in rows.
const PIXELS: u32 = 1 << 14;
const WIDTH: u32 = 256;

struct SetUp;

impl Task for SetUp {
    /// Nanoseconds a pixel.
    type Output = f64;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> f64 {
        let made = black_box(make(black_box(7), black_box(16)));
        let start = Instant::now();
        for pixel in 0..PIXELS {
            black_box(made.pixel(pixel % WIDTH, pixel / WIDTH, 0));
        }
        start.elapsed().as_secs_f64() * 1e9 / f64::from(PIXELS)
    }
}

/// A row a sampler.
pub fn table(names: &[&'static str], rounds: usize) -> Table {
    let mut times = vec![Vec::new(); names.len()];
    for _ in 0..rounds {
        for (name, times) in names.iter().zip(&mut times) {
            times.push(samplers::with(name, &SetUp));
        }
    }
    let row = |(name, times): (&&str, Vec<f64>)| vec![(*name).to_string(), format!("{:.1}", median(times))];
    Table {
        id: "set-up".into(),
        title: "Nanoseconds to set up a pixel".into(),
        about: "Made and stored, 16 samples per pixel, row by row.".into(),
        head: ["sampler", "ns"].map(String::from).to_vec(),
        rows: names.iter().zip(times).map(row).collect(),
    }
}
