//! Masks by themselves: spectra, low-frequency power, the time to make one.
//!
//! Low-frequency power: mean over 0 < |f| < .125 cycles a pixel over the mean for |f| > 0; white is 1.

use crate::analysis::spectrum::Spectrum;
use crate::page::Chapter;
use crate::plot::{Axis, Series, hue, plot};
use crate::table::Table;
use crate::void_and_cluster::void_and_cluster;
use bluedither::tables;
use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;
use std::hint::black_box;
use std::time::Instant;

/// A mask's values, one channel, and its side.
struct Mask {
    name: String,
    size: usize,
    values: Vec<f64>,
    seconds: Option<f64>,
}

fn own() -> Vec<Mask> {
    let scalar = Mask {
        name: "threshold-64 (void and cluster)".into(),
        size: 64,
        values: grid(64).map(|[x, y]| tables::THRESHOLD_64.value(x, y).into()).collect(),
        seconds: Some(own_seconds()),
    };
    let vector = |k: usize| Mask {
        name: format!("offset-2d-64, channel {k}"),
        size: 64,
        values: grid(64).map(|[x, y]| tables::OFFSET_2D_64.value(x, y)[k].into()).collect(),
        seconds: None,
    };
    vec![scalar, vector(0), vector(1)]
}

fn grid(size: u32) -> impl Iterator<Item = [u32; 2]> {
    (0..size * size).map(move |p| [p % size, p / size])
}

/// The `blue-noise` package's void and cluster; behind a feature, for it brings every image format.
#[cfg(feature = "blue-noise")]
fn peers() -> Vec<Mask> {
    let start = Instant::now();
    let config =
        blue_noise::BlueNoiseConfig { width: 64, height: 64, seed: Some(1), verbose: false, ..Default::default() };
    let made = blue_noise::BlueNoiseGenerator::new(config).and_then(blue_noise::BlueNoiseGenerator::generate);
    let seconds = Some(start.elapsed().as_secs_f64());
    let mask = |made: blue_noise::BlueNoiseResult| Mask {
        name: "blue-noise package, 8 bits".into(),
        size: 64,
        values: made.data.iter().map(|&v| f64::from(v)).collect(),
        seconds,
    };
    made.map(mask).into_iter().collect()
}

#[cfg(not(feature = "blue-noise"))]
fn peers() -> Vec<Mask> {
    Vec::new()
}

/// What is known of that package without it: an earlier measurement.
const FROZEN: [&str; 4] = ["blue-noise package (frozen figure)", "–", "–", "0.036 s"];

/// Seconds that the crate's own void and cluster takes, optimised, for the mask that build.rs makes; a kernel of its
/// shape.
fn own_seconds() -> f64 {
    let weight = |r2: f64| 1_048_576.0 * ((-r2 / 3.92).exp() + 0.1 * (-r2 / 12.5).exp());
    let kernel: Vec<i32> = (0..101).map(|r2| weight(f64::from(r2)).round() as i32).collect();
    let start = Instant::now();
    black_box(void_and_cluster(6, &kernel, &mut Xoshiro256PlusPlus::seed_from_u64(1)));
    start.elapsed().as_secs_f64()
}

pub fn chapter() -> Chapter {
    let masks: Vec<Mask> = own().into_iter().chain(peers()).collect();
    let spectra: Vec<Spectrum> = masks.iter().map(|mask| Spectrum::new(&mask.values, mask.size)).collect();
    let row = |(mask, spectrum): (&Mask, &Spectrum)| {
        let seconds = mask.seconds.map_or("by build.rs".to_string(), |s| format!("{s:.3} s"));
        let low = spectrum.low_frequency(0.125);
        vec![mask.name.clone(), format!("{low:.1e}"), format!("{:.1}", spectrum.spike()), seconds]
    };
    let line = |(k, (mask, spectrum)): (usize, (&Mask, &Spectrum))| Series {
        name: mask.name.clone(),
        hue: Some(hue(k, masks.len())),
        dashed: false,
        thin: false,
        dots: false,
        points: (0..)
            .zip(spectrum.radial())
            .skip(1)
            .map(|(k, power)| [f64::from(k) / mask.size as f64, power])
            .collect(),
    };
    let x = Axis { label: "cycles a pixel".into(), logarithmic: false, ticks: vec![] };
    let y = Axis { label: "power of the mask (mean 1)".into(), logarithmic: true, ticks: vec![] };
    let series: Vec<Series> = masks.iter().zip(&spectra).enumerate().map(line).collect();
    let mut rows: Vec<Vec<String>> = masks.iter().zip(&spectra).map(row).collect();
    if !cfg!(feature = "blue-noise") {
        rows.push(FROZEN.map(String::from).to_vec());
    }
    Chapter {
        title: "Masks".into(),
        text: "Spectra of the masks themselves, averaged over directions.".into(),
        figures: vec![plot([&x, &y], &series)],
        tables: vec![Table {
            id: "masks".into(),
            title: "Masks".into(),
            about: "Power below .125 cycles a pixel over the mean (white 1); largest bin over the mean; time to make."
                .into(),
            head: ["mask", "low frequencies", "spike", "made in"].map(String::from).to_vec(),
            rows,
        }],
    }
}
