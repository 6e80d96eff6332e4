//! From mean squares to figures: W, G, root-mean-square errors and spikes, with their standard errors.

use crate::bench::Measured;
use crate::family::{ALL, Family, LINES};
use crate::filter::FILTERS;
use crate::power::Squares;

/// A mean and its standard error over the seeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    pub mean: f64,
    pub error: f64,
}

/// The figures of one family.
#[derive(Clone, Copy, Debug)]
pub struct Figures {
    /// Filtered error over that of white noise at the same number of samples, after each filter.
    pub w: [Value; FILTERS.len()],
    /// Gain: filtered error over what the filter would leave of white noise of the same size.
    pub g: [f64; FILTERS.len()],
    /// Root-mean-square error, and the same over that of white noise.
    pub rms: f64,
    pub rms_over_white: Value,
    /// Filtered error itself.
    pub filtered: [f64; FILTERS.len()],
}

/// The figures of a family. `white` was measured at the same number of samples.
///
/// Each smooth integrand counts divided by white noise's error, half-planes as they are.
pub fn figures(found: &Measured, white: &Measured, family: Family) -> Figures {
    let unit = match family {
        Family::Smooth => white.plain(),
        Family::HalfPlanes => [1.0; ALL],
    };
    let mean_squares = |measured: &Measured, unit: &[f64; ALL], of: &dyn Fn(&Squares) -> f64| {
        let seeds: Vec<f64> = (0..measured.squares.len()).map(|seed| measured.family(seed, family, unit, of)).collect();
        mean(&seeds)
    };
    let relative =
        |of: &dyn Fn(&Squares) -> f64| root_of_ratio(mean_squares(found, &unit, of), mean_squares(white, &unit, of));
    let plain = mean_squares(found, &unit, &|s| s.plain).mean;
    let raw = |of: &dyn Fn(&Squares) -> f64| mean_squares(found, &[1.0; ALL], of).mean.sqrt();
    Figures {
        w: core::array::from_fn(|f| relative(&|s| s.filtered[f])),
        g: core::array::from_fn(|f| {
            let filtered = mean_squares(found, &unit, &|s| s.filtered[f]).mean;
            if plain > 0.0 { (filtered / plain).sqrt() / FILTERS[f].norm() } else { 0.0 }
        }),
        rms: raw(&|s| s.plain),
        rms_over_white: relative(&|s| s.plain),
        filtered: core::array::from_fn(|f| raw(&|s| s.filtered[f])),
    }
}

/// Mean over the half-planes and the worst of them.
pub fn spikes(spikes: &[f64; LINES]) -> [f64; 2] {
    [spikes.iter().sum::<f64>() / LINES as f64, spikes.iter().copied().fold(0.0, f64::max)]
}

/// Mean and standard error of a mean.
pub fn mean(values: &[f64]) -> Value {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / (n - 1.0).max(1.0);
    Value { mean, error: (variance / n).sqrt() }
}

/// √(a/b), with the error that the errors of both leave (to first order).
pub fn root_of_ratio(a: Value, b: Value) -> Value {
    if a.mean <= 0.0 || b.mean <= 0.0 {
        return Value { mean: 0.0, error: 0.0 };
    }
    let root = (a.mean / b.mean).sqrt();
    Value { mean: root, error: 0.5 * root * (a.error / a.mean).hypot(b.error / b.mean) }
}
