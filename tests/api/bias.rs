//! No sampler is biased: the mean over seeds is the integral.

use crate::common::for_every_sampler;
use bluedither::unit;

#[test]
fn the_mean_over_seeds_is_right() {
    // x² in one dimension, xy in two and a product of all eight: by all samples of a pass, by the first ones alone,
    // and by those after the pass. Within four standard errors.
    const ROUNDS: u32 = 1024;
    for spp in [1u32, 2, 3, 4] {
        for (from, to) in [(0, spp), (0, 1), (spp, spp + 1)] {
            let mut sums: Vec<(&str, [[f64; 2]; 3])> = Vec::new();
            let mut add = |name: &'static str, estimates: [f64; 3]| {
                let at = sums.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
                    sums.push((name, [[0.0; 2]; 3]));
                    sums.len() - 1
                });
                for (sum, e) in sums[at].1.iter_mut().zip(estimates) {
                    *sum = [sum[0] + e, sum[1] + e * e];
                }
            };
            for seed in 0..ROUNDS {
                for_every_sampler!(seed, spp, |name, sampler| {
                    let pixel = sampler.pixel(17, 40, 3);
                    let mut mean = [0.0; 3];
                    for index in from..to {
                        let [x] = pixel.draw_fx::<1>(2, index).map(unit::to_f64);
                        let all = pixel.draw_fx::<8>(2, index).map(unit::to_f64);
                        let weight = f64::from(to - from).recip();
                        [x * x, all[0] * all[1], all.iter().map(|v| 0.5 + v).product()]
                            .iter()
                            .zip(&mut mean)
                            .for_each(|(v, m)| *m += v * weight);
                    }
                    add(name, mean);
                });
            }
            for (name, families) in sums {
                for ([sum, squares], exact) in families.into_iter().zip([1.0 / 3.0, 0.25, 1.0]) {
                    let n = f64::from(ROUNDS);
                    let mean = sum / n;
                    let error = ((squares / n - mean * mean).max(0.0) / n).sqrt();
                    // A stratified pass may hit the exact value; a mask's centres are 2⁻²⁶ off at most.
                    let off = (mean - exact).abs();
                    assert!(off < 4.0 * error + 1e-7, "{name}, {from}..{to} of {spp}: {mean} ± {error} for {exact}");
                }
            }
        }
    }
}
