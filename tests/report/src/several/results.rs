//! From mean squares to W: what the filters leave of the error, over what they leave of white noise's.

use super::family::{ALL, FAMILIES, Family};
use super::measure::{Judge, Measured, Setting};
use super::numbers::Form;
use crate::figures::{Value, mean, root_of_ratio};
use crate::filter::Filter;
use crate::power::Squares;
use crate::progress::Progress;
use crate::samplers::WHITE;

/// Standard deviations of the filters in pixels; the first is none.
pub const SIGMAS: [f64; 5] = [0.0, 1.0, 2.1, 4.0, 8.0];
/// The baseline has seeds of its own, and twice as many, so that white noise as a sampler is not compared with itself.
pub const BASELINE: u32 = 0x4000_0000;

/// A sampler at one number of samples, its numbers from one domain or several.
#[derive(Debug)]
pub struct Cell {
    pub name: &'static str,
    pub form: Form,
    pub count: u32,
    /// Of each family, after each filter.
    pub w: Vec<[Value; SIGMAS.len()]>,
    /// The error itself, not over white noise's.
    pub errors: Vec<[Value; SIGMAS.len()]>,
    /// Median and worst local spike of each family.
    pub spikes: Vec<[f32; 2]>,
    /// Of the first seed, the error of each family's first integrand.
    pub images: Vec<Vec<f32>>,
    /// White noise's root mean square of each of those.
    pub scales: Vec<f32>,
}

/// Everything that was found: samplers, then forms, then numbers of samples.
#[derive(Debug)]
pub struct Results {
    pub names: Vec<&'static str>,
    pub counts: Vec<u32>,
    pub cells: Vec<Cell>,
}

/// White noise at one number of samples.
struct Baseline {
    measured: Measured,
    /// Mean square of each integrand.
    plain: Vec<f64>,
}

impl Results {
    pub fn measure(names: &[&'static str], counts: &[u32], [seed, seeds]: [u32; 2]) -> Self {
        let cost = |name: &str| if name == WHITE { 2 } else { 1 };
        let steps: usize = names.iter().map(|name| cost(name)).sum();
        let progress = Progress::new("several dimensions", 2 * steps + 2);
        let judge = Judge::new();
        let setting = Setting { form: Form::Several, counts, seeds: [seed.wrapping_add(BASELINE), 2 * seeds] };
        let baseline: Vec<Baseline> = judge.measure(WHITE, setting).into_iter().map(Baseline::new).collect();
        progress.add(2);
        let mut cells = Vec::new();
        for &name in names {
            for form in Form::BOTH {
                let found = judge.measure(name, Setting { form, counts, seeds: [seed, seeds] });
                for ((measured, baseline), &count) in found.into_iter().zip(&baseline).zip(counts) {
                    let w = FAMILIES.iter().map(|family| baseline.w(&measured, family)).collect();
                    let errors = FAMILIES.iter().map(|family| errors(&measured, family)).collect();
                    let scales = FAMILIES.iter().map(|family| baseline.plain[family.first].sqrt() as f32).collect();
                    let Measured { spikes, images, .. } = measured;
                    cells.push(Cell { name, form, count, w, errors, spikes, images, scales });
                }
                progress.add(cost(name));
            }
        }
        Self { names: names.to_vec(), counts: counts.to_vec(), cells }
    }

    /// The cells of a sampler and form, in the order of the counts; none if it was not measured.
    pub fn row(&self, name: &str, form: Form) -> &[Cell] {
        let first = self.cells.iter().position(|cell| cell.name == name && cell.form == form);
        first.map_or(&[], |first| &self.cells[first..first + self.counts.len()])
    }
}

impl Baseline {
    fn new(measured: Measured) -> Self {
        let seeds = measured.squares.len() as f64;
        let plain = |k: usize| measured.squares.iter().map(|all| all[k].plain).sum::<f64>() / seeds;
        Self { plain: (0..ALL).map(plain).collect(), measured }
    }

    /// W of a family after each filter.
    fn w(&self, found: &Measured, family: &Family) -> [Value; SIGMAS.len()] {
        let unit = |k: usize| if family.normalised { self.plain[k] } else { 1.0 };
        SIGMAS.map(|sigma| {
            let of = |measured: &Measured| mean_square(measured, family, sigma, unit);
            root_of_ratio(of(found), of(&self.measured))
        })
    }
}

/// Root mean squares of a family after each filter.
fn errors(found: &Measured, family: &Family) -> [Value; SIGMAS.len()] {
    let one = Value { mean: 1.0, error: 0.0 };
    SIGMAS.map(|sigma| root_of_ratio(mean_square(found, family, sigma, |_| 1.0), one))
}

/// Over the integrands of a family, each divided by its unit: mean and standard error over the seeds.
fn mean_square(measured: &Measured, family: &Family, sigma: f64, unit: impl Fn(usize) -> f64) -> Value {
    let square = |s: &Squares| if sigma > 0.0 { s.filtered[Filter::Gauss(sigma).place()] } else { s.plain };
    let weight = |k: usize| family.weight(k - family.first);
    let weights: f64 = family.range().map(weight).sum();
    let seed =
        |all: &Vec<Squares>| family.range().map(|k| weight(k) * square(&all[k]) / unit(k)).sum::<f64>() / weights;
    mean(&measured.squares.iter().map(seed).collect::<Vec<f64>>())
}
