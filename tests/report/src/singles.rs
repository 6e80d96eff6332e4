//! One dimension: smooth integrands and steps, by the numbers that samplers give one at a time.

use crate::analysis::integrands::{Integrand1, evaluation_smooth_1d, evaluation_step_1d};
use crate::bench::Bench;
use crate::error_part::short;
use crate::filter::SIGMA_1;
use crate::images::{self, Pixels};
use crate::power::Squares;
use crate::progress::Progress;
use crate::samplers::WHITE;
use crate::shape::Pixel;
use crate::table::Table;

const COUNTS: [u32; 5] = [1, 2, 4, 16, 64];

struct Singles<'a> {
    integrands: &'a [Integrand1],
    count: u32,
}

impl Pixels for Singles<'_> {
    fn count(&self) -> usize {
        self.integrands.len()
    }

    fn errors(&self, _: usize, point: impl Fn(u32) -> [f32; 2], out: &mut [f32]) {
        let points: Vec<f64> = (0..self.count).map(|index| point(index)[0].into()).collect();
        for (out, integrand) in out.iter_mut().zip(self.integrands) {
            let sum: f64 = points.iter().map(|&x| integrand.at(x)).sum();
            *out = (sum / f64::from(self.count) - integrand.exact) as f32;
        }
    }

    fn draw(pixel: impl Pixel, index: u32) -> [f32; 2] {
        let [x] = pixel.draw::<1>(0, index);
        [x, 0.0]
    }
}

/// W at sigma 1 of both families, a row a sampler; each smooth integrand counts divided by white noise's error.
pub fn table(bench: &Bench, names: &[&'static str], seeds: [u32; 2], quick: bool) -> Table {
    let counts: &[u32] = if quick { &[1, 4] } else { &COUNTS };
    let progress = Progress::new("one dimension", counts.len() * (1 + names.len()));
    let mut integrands = evaluation_smooth_1d();
    let smooth = integrands.len();
    integrands.extend(evaluation_step_1d());
    let measure = |name: &str| {
        let of_count = |&count: &u32| {
            progress.add(1);
            images::squares(bench, name, &Singles { integrands: &integrands, count }, count, seeds)
        };
        counts.iter().map(of_count).collect::<Vec<_>>()
    };
    let white = measure(WHITE);
    let row = |name: &&'static str| {
        let cell = |(found, white): (Vec<Squares>, &Vec<Squares>)| {
            let sum = |squares: &[Squares], family: core::ops::Range<usize>| -> f64 {
                let unit = |k: usize| if k < smooth { white[k].plain } else { 1.0 };
                family.map(|k| squares[k].filtered[SIGMA_1] / unit(k)).sum()
            };
            let both = [0..smooth, smooth..integrands.len()];
            both.map(|family| short((sum(&found, family.clone()) / sum(white, family)).sqrt())).join(" / ")
        };
        let cells = measure(name).into_iter().zip(&white).map(cell).collect::<Vec<_>>();
        core::iter::once((*name).to_string()).chain(cells).collect()
    };
    Table {
        id: "singles".into(),
        title: "W, sigma 1, one number a sample".into(),
        about: "Filtered error over that of white noise: smooth integrands / steps.".into(),
        head: core::iter::once("samples".to_string()).chain(counts.iter().map(u32::to_string)).collect(),
        rows: names.iter().map(row).collect(),
    }
}
