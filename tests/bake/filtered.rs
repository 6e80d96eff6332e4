//! Masks for a filter: less error after it than the default mask leaves, on integrands that no optimiser saw.
//!
//! `cargo test --test bake filtered:: -- --nocapture` prints the figures: filtered error over that of the same values
//! in random places, of the default mask and of the one for the filter; white is 1.

use crate::analysis::integrands::{Integrand1, evaluation_smooth_1d, evaluation_step_1d};
use crate::bake::filter::{Filter, Space};
use crate::bake::inputs::Inputs;
use crate::bake::recipe::{Kind, Recipe};
use crate::effort::Effort;

const SIZE: usize = 64;

fn baked(kind: Kind, filter: &str) -> Vec<u16> {
    let filter = Filter::parse(filter).expect("a filter");
    let inputs = Inputs { filter, ..crate::recorded().1 };
    Recipe { kind, size_log2: 6 }.bake(Effort::Normal, &inputs)
}

/// The filter as a renderer has it: its taps along an axis, which sum to 1.
fn taps(space: Space) -> Vec<f64> {
    let taps: Vec<f64> = match space {
        Space::Gaussian(sigma) => {
            let (sigma, reach) = (f64::from(sigma) / 1000.0, sigma as i32 * 5 / 1000 + 1);
            (-reach..=reach).map(|i| libm::exp(-0.5 * (f64::from(i) / sigma).powi(2))).collect()
        }
        Space::Box(side) => vec![1.0; side as usize],
        Space::Binomial(taps) => (1..taps).fold(vec![1.0], |row, _| {
            let at = |i: usize| row.get(i).copied().unwrap_or(0.0);
            (0..=row.len()).map(|i| at(i) + if i == 0 { 0.0 } else { at(i - 1) }).collect()
        }),
    };
    let sum: f64 = taps.iter().sum();
    taps.iter().map(|tap| tap / sum).collect()
}

/// Along both axes on the torus. (Where an even number of taps is centred makes no difference.)
fn filtered(image: &[f64], taps: &[f64]) -> Vec<f64> {
    let rows = |image: &[f64]| -> Vec<f64> {
        let pixel = |p: usize| -> f64 {
            let place = |i: usize| p / SIZE * SIZE + (p + i + SIZE - taps.len() / 2) % SIZE;
            taps.iter().enumerate().map(|(i, tap)| tap * image[place(i)]).sum()
        };
        (0..SIZE * SIZE).map(pixel).collect()
    };
    let turned = |image: &[f64]| -> Vec<f64> { (0..SIZE * SIZE).map(|p| image[p % SIZE * SIZE + p / SIZE]).collect() };
    turned(&rows(&turned(&rows(image))))
}

fn mean_square(image: &[f64]) -> f64 {
    image.iter().map(|e| e * e).sum::<f64>() / image.len() as f64
}

/// R of smooth integrands and of steps, after the moving average over time (of all the mask's frames, some of which are
/// the last one) and the filter.
fn left(ranks: &[u16], space: Space, ema: f64) -> [f64; 2] {
    let (area, frames) = (SIZE * SIZE, ranks.len() / (SIZE * SIZE));
    let taps = taps(space);
    let mut ages = vec![0.0; frames];
    (0..1000).for_each(|age| ages[age % frames] += ema * (1.0 - ema).powi(age as i32));
    let norm = taps.iter().map(|tap| tap * tap).sum::<f64>().powi(2) * ema / (2.0 - ema);
    let family = |family: &[Integrand1]| {
        let (mut ours, mut white) = (0.0, 0.0);
        for integrand in family {
            let error = |&rank: &u16| integrand.at((f64::from(rank) + 0.5) / area as f64) - integrand.exact;
            let errors: Vec<f64> = ranks.iter().map(error).collect();
            for last in (0..frames).step_by(6) {
                let past = |(age, weight): (usize, &f64), p| weight * errors[(last + frames - age) % frames * area + p];
                let image: Vec<f64> =
                    (0..area).map(|p| ages.iter().enumerate().map(|age| past(age, p)).sum()).collect();
                ours += mean_square(&filtered(&image, &taps));
                white += mean_square(&errors) * norm;
            }
        }
        (ours / white).sqrt()
    };
    [family(&evaluation_smooth_1d()[..24]), family(&evaluation_step_1d()[..48])]
}

/// Prints a row; returns what is left of the default's error of both families, which count alike.
fn compare(default: &[u16], kind: Kind, text: &str, ema: f64) -> f64 {
    let space = Filter::parse(text).expect("a filter").space;
    let (before, after) = (left(default, space, ema), left(&baked(kind, text), space, ema));
    let ratio = (after[0].hypot(after[1])) / (before[0].hypot(before[1]));
    println!(
        "  {text:20} default {:.3} / {:.3}   for it {:.3} / {:.3}   ratio {ratio:.2}",
        before[0], before[1], after[0], after[1]
    );
    ratio
}

#[test]
fn still_masks() {
    let default = baked(Kind::Threshold, "box:3");
    println!("smooth / steps, after the filter");
    for text in [
        "gaussian:0.7",
        "gaussian:2",
        "gaussian:3",
        "gaussian:4",
        "box:2",
        "box:3",
        "box:5",
        "box:9",
        "binomial:3",
        "binomial:15",
    ] {
        let ratio = compare(&default, Kind::Filtered, text, 1.0);
        assert!(ratio <= if text == "box:3" { 0.72 } else { 0.95 }, "{text}: {ratio} of the default's error");
    }
    // What the default mask is made for: little to win, and nothing to lose.
    for text in ["gaussian:1", "gaussian:1.5", "binomial:5", "binomial:7"] {
        let ratio = compare(&default, Kind::Filtered, text, 1.0);
        assert!(ratio <= 1.03, "{text}: {ratio} of the default's error");
    }
}

#[test]
fn masks_over_time() {
    let default = baked(Kind::OverTime, "box:3");
    println!("smooth / steps, after the filter and the moving average");
    for (text, ema) in [
        ("box:3+ema:0.1", 0.1),
        ("gaussian:1+ema:0.1", 0.1),
        ("gaussian:2+ema:0.2", 0.2),
        ("binomial:3+ema:0.05", 0.05),
    ] {
        let ratio = compare(&default, Kind::FilteredOverTime, text, ema);
        assert!(ratio <= if ema == 0.1 { 0.7 } else { 0.95 }, "{text}: {ratio} of the default's error");
        let ranks = baked(Kind::FilteredOverTime, text);
        for frame in ranks.chunks(SIZE * SIZE) {
            let mut sorted = frame.to_vec();
            sorted.sort_unstable();
            assert!(sorted.iter().enumerate().all(|(i, &rank)| i == usize::from(rank)), "{text}: every rank once");
        }
        // One frame by itself is about as good as one of the default.
        let space = Filter::parse(text).expect("a filter").space;
        let [one, ours] = [&default, &ranks].map(|ranks| left(&ranks[..SIZE * SIZE], space, 1.0));
        assert!(ours[0].hypot(ours[1]) <= 1.05 * one[0].hypot(one[1]), "{text}: one frame {ours:?}, {one:?}");
    }
}

/// The kernel is the autocorrelation of the taps; what Gaussians are given besides is narrow and shrinks away.
#[test]
fn kernels_are_autocorrelations() {
    for space in
        [Space::Box(2), Space::Box(3), Space::Box(8), Space::Binomial(2), Space::Binomial(5), Space::Gaussian(1800)]
    {
        let taps = taps(space);
        let product = |d: usize| -> f64 { taps.iter().zip(&taps[d.min(taps.len())..]).map(|(a, b)| a * b).sum() };
        for d in 0..12 {
            let expected = product(d) / product(0);
            assert!((space.along(d) - expected).abs() < 1e-6, "{space:?} at {d}: {} for {expected}", space.along(d));
        }
    }
}

#[test]
fn filters_are_read_or_refused() {
    for (text, name) in [
        ("box:3+ema:0.1", "box:3+ema:0.1"),
        ("ema:0.1", "box:3+ema:0.1"),
        ("ema:1", "box:3+ema:1"),
        ("box:3", "box:3+ema:0.1"),
        ("gaussian:1.50", "gaussian:1.5+ema:0.1"),
        ("ema:.02+gaussian:4", "gaussian:4+ema:0.02"),
        ("binomial:15+ema:0.25", "binomial:15+ema:0.25"),
    ] {
        assert_eq!(Filter::parse(text).map(Filter::name).as_deref(), Some(name), "{text}");
    }
    let wrong = [
        "",
        "box",
        "box:",
        "box:1",
        "box:16",
        "box:-3",
        "box:3.5",
        "gaussian:0",
        "gaussian:0.4",
        "gaussian:4.01",
        "gaussian:nan",
        "gaussian:inf",
        "gauss:1",
        "binomial:0",
        "ema:0",
        "ema:1.1",
        "ema:0.019",
        "box:3+box:3",
        "box:3+",
        "ema:0.1+ema:0.2",
        "box:3+ema:0.1+ema:0.1",
        "box:3,ema:0.1",
        "Box:3",
        "box:3 ",
        "box:99999999999999999999",
    ];
    for text in wrong {
        assert_eq!(Filter::parse(text), None, "{text:?}");
    }
}

/// The widest of all, and the ends of what can be written: sums of weights stay within an `i32`, ranks within the mask.
#[test]
fn the_ends_of_the_range_make_masks() {
    for text in ["gaussian:4+ema:0.02", "box:15+ema:0.02", "binomial:2+ema:1", "gaussian:0.5+ema:1"] {
        let inputs = Filter::parse(text).expect("a filter");
        let recipe = |windows: &[crate::bake::void_and_cluster::Window]| {
            let mut rng = <rand::rngs::Xoshiro256PlusPlus as rand::SeedableRng>::seed_from_u64(1);
            let mut ranks = crate::bake::void_and_cluster::over_time([4, 2], windows, &mut rng);
            ranks.sort_unstable();
            assert!(ranks.iter().enumerate().all(|(i, &rank)| i / 4 == usize::from(rank)), "{text}");
        };
        recipe(&[inputs.still()]);
        recipe(&inputs.over_time(2));
    }
}
