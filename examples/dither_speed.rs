//! What a dithered pixel costs, beside copying memory: frames larger than any cache, one thread.
//!
//! ```text
//! cargo run --release --example dither_speed
//! ```
//!
//! All take turns in every round, and medians are printed: compare them within one run.
#![allow(clippy::std_instead_of_core, clippy::cast_possible_truncation, reason = "for desktops, on small numbers")]

use bluedither::Dither;
use bluedither::dither::RowError;
use bluedither::tables::THRESHOLD_64;
use std::hint::black_box;
use std::time::Instant;

const WIDTH: usize = 8192;
const ROUNDS: usize = 9;

fn main() -> Result<(), RowError> {
    let methods = [
        ("blue 64x64", Dither::blue(&THRESHOLD_64)),
        ("Bayer 64x64", Dither::ordered(6)),
        ("constant", Dither::constant(1 << 31)),
        ("random", Dither::random(1)),
    ];
    // 256 million pixels of grey, 85 million of RGB.
    let source: Vec<u8> = (0..WIDTH * 32768).map(|i| (i * 7 + i / WIDTH * 13) as u8).collect();

    let mut bits = vec![1; source.len() / 8];
    let gray = |dither: Dither<'_>| {
        for (y, (row, bits)) in (0..).zip(source.chunks_exact(WIDTH).zip(bits.chunks_exact_mut(WIDTH / 8))) {
            dither.gray1_row(y, row, bits)?;
        }
        Ok(())
    };
    compare("8-bit grey to 1 bit", &source, source.len(), 9 * source.len() / 8, &methods, gray)?;

    let pixels = source.len() / (3 * WIDTH) * WIDTH;
    let mut words = vec![1; pixels];
    let color = |dither: Dither<'_>| {
        for (y, (row, words)) in (0..).zip(source.chunks_exact(3 * WIDTH).zip(words.chunks_exact_mut(WIDTH))) {
            dither.rgb565_row(y, row, words)?;
        }
        Ok(())
    };
    compare("RGB888 to RGB565", &source, pixels, 5 * pixels, &methods, color)
}

/// Times every method and a copy that reads and writes as many bytes together, `moved`.
fn compare(
    title: &str,
    source: &[u8],
    pixels: usize,
    moved: usize,
    methods: &[(&str, Dither<'_>)],
    mut dither: impl FnMut(Dither<'_>) -> Result<(), RowError>,
) -> Result<(), RowError> {
    let half = &source[..(moved / 2).min(source.len())];
    let mut copy = vec![1; half.len()];
    let mut times = vec![Vec::new(); methods.len() + 1];
    for _ in 0..ROUNDS {
        let start = Instant::now();
        copy.copy_from_slice(black_box(half));
        black_box(&mut copy);
        times[0].push(start.elapsed().as_secs_f64());
        for ((_, method), times) in methods.iter().zip(&mut times[1..]) {
            let start = Instant::now();
            dither(*method)?;
            times.push(start.elapsed().as_secs_f64());
        }
    }
    let medians: Vec<f64> = times.iter_mut().map(|times| median(times)).collect();
    println!("{title}, ns a pixel and times the copy:");
    for (name, time) in ["copy of as many bytes"].into_iter().chain(methods.iter().map(|m| m.0)).zip(&medians) {
        println!("  {name:22} {:7.3} {:6.1}", time * 1e9 / pixels as f64, time / medians[0]);
    }
    Ok(())
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
