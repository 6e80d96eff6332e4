//! Masks by themselves: spectra, low-frequency power, the time to make one.
//!
//! Low-frequency power: mean over 0 < |f| < .125 cycles a pixel over the mean for |f| > 0; white is 1.

use crate::analysis::spectrum::Spectrum;
use crate::page::Chapter;
use crate::plot::{Axis, Series, hue, plot};
use crate::table::Table;
use bluedither::tables;

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
        seconds: None,
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

/// The `blue-noise` package's void and cluster; behind a feature, for it brings every image format with it.
#[cfg(feature = "void-and-cluster")]
fn peers() -> Vec<Mask> {
    let start = std::time::Instant::now();
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

#[cfg(not(feature = "void-and-cluster"))]
fn peers() -> Vec<Mask> {
    Vec::new()
}

pub fn chapter() -> Chapter {
    let masks: Vec<Mask> = own().into_iter().chain(peers()).collect();
    let spectra: Vec<Spectrum> = masks.iter().map(|mask| Spectrum::new(&mask.values, mask.size)).collect();
    let row = |(mask, spectrum): (&Mask, &Spectrum)| {
        let seconds = mask.seconds.map_or("by build.rs".to_string(), |s| format!("{s:.2} s"));
        let low = spectrum.low_frequency(0.125);
        vec![mask.name.clone(), format!("{low:.1e}"), format!("{:.1}", spectrum.spike()), seconds]
    };
    let line = |(k, (mask, spectrum)): (usize, (&Mask, &Spectrum))| Series {
        name: mask.name.clone(),
        hue: Some(hue(k, masks.len())),
        dashed: false,
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
            rows: masks.iter().zip(&spectra).map(row).collect(),
        }],
    }
}
