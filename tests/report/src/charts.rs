//! The pictures of the error chapter: error against time, error against samples, spectra.

use crate::error_part::{Entry, Errors};
use crate::family::Family;
use crate::filter::SIGMA_1;
use crate::plot::{Axis, Series, hue, plot};
use crate::samplers::PEERS;
use crate::speed::Speeds;

/// The place of a family in the figures of an entry.
const FAMILIES: [(usize, Family); 2] = [(0, Family::Smooth), (1, Family::HalfPlanes)];

fn axis(label: &str, logarithmic: bool, ticks: Vec<f64>) -> Axis {
    Axis { label: label.into(), logarithmic, ticks }
}

/// One line a sampler; `point` is `None` where there is nothing to show.
fn lines(errors: &Errors, point: impl Fn(&Entry) -> Option<[f64; 2]>) -> Vec<Series> {
    let samplers: Vec<&[Entry]> = errors.entries.chunks(errors.counts.len()).collect();
    let line = |(k, row): (usize, &&[Entry])| Series {
        name: row[0].name.into(),
        hue: Some(hue(k, samplers.len())),
        dashed: false,
        thin: PEERS.contains(&row[0].name),
        dots: true,
        points: row.iter().filter_map(&point).filter(|p| p.iter().all(|v| *v > 0.0)).collect(),
    };
    samplers.iter().enumerate().map(line).filter(|series| !series.points.is_empty()).collect()
}

/// Filtered error against the nanoseconds that a pixel's pairs take, with the best that is to be had for each time.
pub fn error_against_time(errors: &Errors, speeds: &Speeds) -> Vec<String> {
    let of = |(k, family): (usize, Family)| {
        let mut series = lines(errors, |entry| {
            let time = speeds.of_set(entry.name, 2, entry.measured.count)?;
            Some([time, entry.figures[k].filtered[SIGMA_1]])
        });
        let points = series.iter().flat_map(|s| s.points.iter().copied()).collect();
        series.push(Series {
            name: "Pareto front".into(),
            hue: None,
            dashed: true,
            thin: false,
            dots: false,
            points: front(points),
        });
        let x = axis("nanoseconds a pixel for its pairs of numbers", true, vec![]);
        let y = axis(&format!("filtered error (sigma 1), {}", family.name()), true, vec![]);
        plot([&x, &y], &series)
    };
    FAMILIES.map(of).to_vec()
}

/// The points that no other is better than in both ways, as a stair.
pub fn front(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut stairs: Vec<[f64; 2]> = Vec::new();
    for [x, y] in points {
        match stairs.last() {
            Some(&[_, best]) if y >= best => {}
            Some(&[_, best]) => stairs.extend([[x, best], [x, y]]),
            None => stairs.push([x, y]),
        }
    }
    stairs
}

/// Error against samples, over that of white noise: W at sigma 1.
pub fn error_against_samples(errors: &Errors) -> Vec<String> {
    let of = |(k, family): (usize, Family)| {
        // What is far worse than white noise would squeeze the rest together.
        let w = |entry: &Entry| Some(entry.figures[k].w[SIGMA_1].mean).filter(|w| *w < 3.0);
        let series = lines(errors, |entry| Some([f64::from(entry.measured.count), w(entry)?]));
        let x = axis("samples per pixel", true, errors.counts.iter().map(|&c| c.into()).collect());
        let y = axis(&format!("W, sigma 1, {} (white noise is 1; up to 3)", family.name()), true, vec![]);
        plot([&x, &y], &series)
    };
    FAMILIES.map(of).to_vec()
}

/// Radially averaged spectra of the errors at some sample count.
pub fn spectra(errors: &Errors, count: u32) -> Vec<String> {
    let of = |(k, family): (usize, Family)| {
        let entries: Vec<&Entry> = errors.entries.iter().filter(|entry| entry.measured.count == count).collect();
        let line = |(place, entry): (usize, &&Entry)| Series {
            name: entry.name.into(),
            hue: Some(hue(place, entries.len())),
            dashed: false,
            thin: PEERS.contains(&entry.name),
            dots: false,
            points: radial(&entry.measured.radial[k]),
        };
        let series: Vec<Series> = entries.iter().enumerate().map(line).collect();
        let x = axis("cycles a pixel", false, vec![]);
        let y = axis(&format!("power of the error, {}, {count} samples (mean 1)", family.name()), false, vec![]);
        plot([&x, &y], &series)
    };
    FAMILIES.map(of).to_vec()
}

/// Rings as points, up to 3: spikes of some samplers would flatten the rest.
fn radial(rings: &[f64]) -> Vec<[f64; 2]> {
    let ring = |(k, power): (usize, &f64)| [k as f64 / crate::field::SIZE as f64, power.min(3.0)];
    rings.iter().enumerate().skip(1).map(ring).filter(|p| p[1].is_finite()).collect()
}
