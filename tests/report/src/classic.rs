//! The integrands of the literature, one by one: discs, a triangle, bumps, a singular one, and of one dimension.

use crate::bench::Bench;
use crate::error_part::short;
use crate::filter::SIGMA_1;
use crate::frozen;
use crate::images::{self, Pixels};
use crate::power::Squares;
use crate::progress::Progress;
use crate::samplers::WHITE;
use crate::table::Table;
use core::f64::consts::{FRAC_2_PI, PI};

const COUNTS: [u32; 3] = [1, 4, 16];

/// Name, exact value, function. An even number of them.
type Function = (&'static str, f64, fn(f64, f64) -> f64);
const FUNCTIONS: [Function; 12] = [
    ("quarter disc", 0.5, |x, y| step(x * x + y * y < FRAC_2_PI)),
    ("disc", 0.5, |x, y| step((x - 0.5).powi(2) + (y - 0.5).powi(2) < 0.25 * FRAC_2_PI)),
    ("triangle", 0.5, |x, y| step(x + y < 1.0)),
    ("exp(-x²-y²)", 0.557_746_285_351_03, |x, y| (-x * x - y * y).exp()),
    ("centred bump", 0.851_120_663_492_2, |x, y| (-(x - 0.5).powi(2) - (y - 0.5).powi(2)).exp()),
    ("xy", 0.25, |x, y| x * y),
    ("x²y²", 1.0 / 9.0, |x, y| x * x * y * y),
    ("sin π(x+y)", 0.0, |x, y| (PI * (x + y)).sin()),
    // Oscillates without end at the corner; by 2²⁴ Sobol points.
    ("sin π/r", -0.220_242, |x, y| (PI / x.hypot(y).max(1e-9)).sin()),
    ("step at 1/π", 1.0 / PI, |x, _| step(x < 1.0 / PI)),
    ("exp(-x²)", 0.746_824_132_812_427, |x, _| (-x * x).exp()),
    ("sin 2πx", 0.0, |x, _| (2.0 * PI * x).sin()),
];

fn step(lit: bool) -> f64 {
    f64::from(u8::from(lit))
}

struct Classic {
    count: u32,
}

impl Pixels for Classic {
    fn count(&self) -> usize {
        FUNCTIONS.len()
    }

    fn errors(&self, _: usize, point: impl Fn(u32) -> [f32; 2], out: &mut [f32]) {
        let mut sums = [0.0; FUNCTIONS.len()];
        for index in 0..self.count {
            let [x, y] = point(index).map(f64::from);
            sums.iter_mut().zip(FUNCTIONS).for_each(|(sum, (_, _, f))| *sum += f(x, y));
        }
        for ((out, sum), (_, exact, _)) in out.iter_mut().zip(sums).zip(FUNCTIONS) {
            *out = (sum / f64::from(self.count) - exact) as f32;
        }
    }
}

/// W at sigma 1 of each function, a table a sample count.
pub fn tables(bench: &Bench, names: &[&'static str], seeds: [u32; 2]) -> Vec<Table> {
    let progress = Progress::new("classic integrands", COUNTS.len() * (1 + names.len()));
    let table = |count: u32| {
        let measure = |name: &str| {
            progress.add(1);
            images::squares(bench, name, &Classic { count }, count, seeds)
        };
        let white = measure(WHITE);
        let row = |name: &&'static str| {
            let ratio = |(found, white): (&Squares, &Squares)| found.filtered[SIGMA_1] / white.filtered[SIGMA_1];
            let cells = measure(name).iter().zip(&white).map(|pair| short(ratio(pair).sqrt())).collect::<Vec<_>>();
            core::iter::once((*name).to_string()).chain(cells).collect()
        };
        let mut rows: Vec<Vec<String>> = names.iter().map(row).collect();
        rows.extend(frozen::classic_rows(count, &FUNCTIONS.map(|(name, ..)| name)));
        Table {
            id: format!("classic-{count}"),
            title: format!("W, sigma 1, {count} samples"),
            about:
                "Filtered error over that of white noise; rows marked as frozen are earlier measurements of one tile."
                    .into(),
            head: core::iter::once("sampler".to_string()).chain(FUNCTIONS.map(|(name, ..)| name.to_string())).collect(),
            rows,
        }
    };
    COUNTS.map(table).to_vec()
}

#[cfg(test)]
mod checks {
    /// Exact values against a million Owen-scrambled points, which have no diagonals as the plain ones do.
    #[test]
    fn exact_values_are_exact() {
        const COUNT: u32 = 1 << 20;
        for (name, exact, f) in super::FUNCTIONS {
            let value = |index| {
                let [x, y] = bluedither::sobol::owen_point(index, 0x3a5f_91c7).map(bluedither::unit::to_f64);
                f(x, y)
            };
            let mean = (0..COUNT).map(value).sum::<f64>() / f64::from(COUNT);
            assert!((mean - exact).abs() < 1e-4, "{name}: {mean}, {exact}");
        }
    }
}
