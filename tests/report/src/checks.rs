//! Tests of the analysis itself.

use crate::analysis::integrands::{evaluation_half_plane_2d, evaluation_smooth_2d};
use crate::analysis::random::Random;
use crate::arguments::Arguments;
use crate::bench::{Bench, Measured, Setting};
use crate::charts::front;
use crate::family::{ALL, FIXED, Family, Integrands, LINES, SMOOTH};
use crate::field::{Drawn, PIXELS, SIZE, error_images};
use crate::figures::figures;
use crate::filter::{FILTERS, Filter};
use crate::page::{Chapter, page};
use crate::plot::{Axis, Series, plot};
use crate::power::{Analyser, Squares};
use crate::samplers::WHITE;
use crate::shape::shapes;
use crate::table::Table;
use clap::Parser;

/// The program itself, quickly and of one sampler beside white noise.
#[test]
fn a_quick_run_writes_what_was_asked_for() {
    let out = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/report-check");
    _ = std::fs::remove_dir_all(&out);
    let path = out.to_str().expect("a path in UTF-8");
    let words = ["report", "error", "speed", "frames", "--quick", "--only", "sampler", "--out", path];
    crate::run(&Arguments::parse_from(words)).expect("a run");
    let read = |name: &str| std::fs::read_to_string(out.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    for name in ["w-sigma-1-smooth.csv", "speed.csv"] {
        let table = read(name);
        let row = table.lines().find(|line| line.starts_with("sampler,")).expect("the sampler's row");
        assert!(row.split(',').skip(1).all(|cell| cell.contains(|c: char| c.is_ascii_digit())), "{name}: {row}");
        assert!(table.contains("\nwhite,") && !table.contains("\nkeys,"), "{name}: {table}");
    }
    assert!(read("time-thresholds.csv").contains("\nwhite noise,"));
    assert!(read("report.html").matches("<svg").count() > 1 && read("report.md").contains("| sampler |"));
}

/// The fast integrands are the slow ones, in their order.
#[test]
fn integrands_are_those_of_the_analysis() {
    let fast = Integrands::new();
    let mut slow = evaluation_smooth_2d();
    // Draws of ten: six fixed ones, four edges. Kept: the first six, all edges.
    let edges = slow.iter().enumerate().filter(|(k, _)| k % 10 >= FIXED).map(|(k, _)| k);
    let order: Vec<usize> = (0..FIXED).chain(edges).chain(slow.len()..slow.len() + 64).collect();
    slow.extend(evaluation_half_plane_2d());
    assert_eq!(order.len(), ALL);
    let mut random = Random::new(9);
    for _ in 0..200 {
        let point = [random.uniform() as f32, random.uniform() as f32];
        let mut sums = [0.0; ALL];
        fast.add(point, &mut sums);
        let errors = fast.errors(&sums, 1.0);
        for (k, &from) in order.iter().enumerate() {
            let expected = slow[from].at(point.map(f64::from)) - slow[from].exact;
            assert!((f64::from(errors[k]) - expected).abs() < 2e-6, "{} at {point:?}", slow[from].name);
        }
    }
}

/// A wave has its power in two bins; a filter leaves of it what its response says.
#[test]
fn a_wave_is_found_where_it_is() {
    let wave = |fx: f64, fy: f64, p: usize| {
        (std::f64::consts::TAU * (fx * (p % SIZE) as f64 + fy * (p / SIZE) as f64) / SIZE as f64).cos()
    };
    let a: Vec<f32> = (0..PIXELS).map(|p| wave(5.0, 9.0, p) as f32).collect();
    let b: Vec<f32> = (0..PIXELS).map(|p| 0.5 + 2.0 * wave(20.0, 0.0, p) as f32).collect();
    let analyser = Analyser::new();
    let (mut largest, mut dc) = ([(0.0f32, 0); 2], [0.0; 2]);
    let squares = analyser.pair([&a, &b], &mut analyser.scratch(), |k, powers| {
        for image in 0..2 {
            if k == 0 {
                dc[image] = powers[image];
            } else if powers[image] > largest[image].0 {
                largest[image] = (powers[image], k);
            }
        }
    });
    // Axes are swapped.
    assert!([5 * SIZE + 9, (SIZE - 5) * SIZE + SIZE - 9].contains(&largest[0].1) && (largest[0].0 - 0.25).abs() < 1e-4);
    assert!([20 * SIZE, (SIZE - 20) * SIZE].contains(&largest[1].1) && (largest[1].0 - 1.0).abs() < 1e-4);
    assert!(dc[0] < 1e-6 && (dc[1] - 0.25).abs() < 1e-4);
    assert!((squares[0].plain - 0.5).abs() < 1e-4 && (squares[1].plain - 2.25).abs() < 1e-4);
    for (k, filter) in FILTERS.into_iter().enumerate() {
        let response = |f: f64| match filter {
            // The sampled Gaussian's transform: Gaussians that repeat, over their sum at 0.
            Filter::Gauss(sigma) => {
                let gauss = |f: f64| (-2.0 * (std::f64::consts::PI * sigma * f / SIZE as f64).powi(2)).exp();
                let sum = |f: f64| (-2..3).map(|turn| gauss(f + f64::from(turn) * SIZE as f64)).sum::<f64>();
                sum(f) / sum(0.0)
            }
            Filter::Box(side) => {
                let turn = std::f64::consts::TAU * f / SIZE as f64;
                (0..side).map(|d| (turn * (d as f64 - (side / 2) as f64)).cos()).sum::<f64>() / side as f64
            }
        };
        let expected = [0.5 * (response(5.0) * response(9.0)).powi(2), 0.25 + 2.0 * response(20.0).powi(2)];
        for image in 0..2 {
            let found = squares[image].filtered[k];
            assert!((found - expected[image]).abs() < 2e-4, "{filter:?}: {found}, {}", expected[image]);
        }
    }
}

/// The filters agree with the direct ones of the analysis.
#[test]
fn filters_are_those_of_the_analysis() {
    let mut random = Random::new(3);
    let image: Vec<f32> = (0..PIXELS).map(|_| random.normal() as f32).collect();
    let analyser = Analyser::new();
    let [squares, _] = analyser.pair([&image, &image], &mut analyser.scratch(), |_, _| ());
    let direct = crate::analysis::error::ErrorImage { size: SIZE, errors: image.iter().map(|&e| e.into()).collect() };
    for (k, filter) in FILTERS.into_iter().enumerate() {
        if let Filter::Gauss(sigma) = filter {
            let (found, expected) = (squares.filtered[k].sqrt(), direct.filtered_rms(sigma));
            assert!((found / expected - 1.0).abs() < 1e-4, "{filter:?}: {found} for {expected}");
        }
    }
}

/// White noise against white noise of other seeds: W and G are 1 within their errors, the spike is that of chance.
#[test]
fn white_against_white_is_one() {
    let bench = Bench::new();
    for count in [1, 4] {
        let [one, other] = [100, 200]
            .map(|seed| Drawn::all_of(seed, count))
            .map(|first| bench.measure(WHITE, Setting { first, seeds: 8 }));
        for family in Family::BOTH {
            let found = figures(&one, &other, family);
            for (f, w) in found.w.into_iter().enumerate() {
                assert!((w.mean - 1.0).abs() < 4.0 * w.error, "{family:?} {:?}: {w:?}", FILTERS[f]);
                assert!(w.error > 0.0 && w.error < 0.05, "{family:?} {:?}: {w:?}", FILTERS[f]);
                assert!((found.g[f] - 1.0).abs() < 0.1, "{family:?} {:?}: {}", FILTERS[f], found.g[f]);
            }
        }
        for spike in one.spikes {
            // The largest of 8192 sums of 8 exponential numbers.
            assert!((2.4..6.0).contains(&spike), "{spike}");
        }
    }
}

/// No error at all leaves zeros: no figure is infinite or none.
#[test]
fn an_error_of_nothing_leaves_numbers() {
    let nothing = Squares { plain: 0.0, filtered: [0.0; FILTERS.len()] };
    let measured = |squares| Measured { count: 4, squares, spikes: [0.0; LINES], radial: [vec![], vec![]] };
    let white = Bench::new().measure(WHITE, Setting { first: Drawn::all_of(1, 4), seeds: 2 });
    for family in Family::BOTH {
        let found = figures(&measured(vec![[nothing; ALL]; 2]), &white, family);
        assert!(found.w.iter().all(|w| w.mean == 0.0 && w.error == 0.0), "{:?}", found.w);
        assert!(found.g.iter().chain(&found.filtered).all(|&g| g == 0.0), "{found:?}");
        assert_eq!((found.rms, found.rms_over_white.mean), (0.0, 0.0));
    }
}

/// A moving average is that of the frames' errors, and one that keeps all is their mean.
#[test]
fn frames_are_averaged() {
    let integrands = Integrands::new();
    let frames = 3;
    let image = |drawn| error_images(&bluedither::White::new(5), drawn, &integrands);
    let drawn = |keep| Drawn { frames, keep, ..Drawn::all_of(5, 2) };
    // One frame alone, by a sampler that counts frames from there on.
    struct From(u32);
    impl From {
        fn pixel(&self, x: u32, y: u32, frame: u32) -> bluedither::sampler::WhitePixel {
            bluedither::White::new(5).pixel(x, y, self.0 + frame)
        }
    }
    shapes! { From, bluedither::sampler::WhitePixel; }
    let alone: Vec<Vec<f32>> = (0..frames).map(|f| error_images(&From(f), Drawn::all_of(5, 2), &integrands)).collect();
    for (keep, weights) in [(1.0, [1.0 / 3.0; 3]), (0.5, [1.0 / 7.0, 2.0 / 7.0, 4.0 / 7.0])] {
        for (k, &error) in image(drawn(keep)).iter().enumerate().step_by(1009) {
            let expected: f32 = alone.iter().zip(weights).map(|(image, weight)| weight * image[k]).sum();
            assert!((error - expected).abs() < 1e-5, "keep {keep}, {k}: {error} for {expected}");
        }
    }
}

/// The order of the integrands: the smooth ones first, both parts even.
#[test]
fn families_are_even() {
    assert_eq!((SMOOTH % 2, ALL % 2), (0, 0));
    assert_eq!(Family::Smooth.range().len() + Family::HalfPlanes.range().len(), ALL);
}

/// The front keeps what no other point beats in both ways.
#[test]
fn the_front_is_a_falling_stair() {
    let points = vec![[4.0, 1.0], [1.0, 5.0], [2.0, 6.0], [3.0, 2.0], [2.0, 3.0], [5.0, 1.0]];
    let expected = [[1.0, 5.0], [2.0, 5.0], [2.0, 3.0], [3.0, 3.0], [3.0, 2.0], [4.0, 2.0], [4.0, 1.0]];
    assert_eq!(front(points), expected);
}

/// A page needs nothing from elsewhere, runs nothing, and shows its numbers.
#[test]
fn the_page_stands_alone() {
    let points = vec![[1.0, 0.5], [16.0, 0.05], [256.0, 0.004]];
    let series = Series { name: "a & b".into(), hue: Some(10), dashed: false, thin: false, dots: true, points };
    let axis = |label: &str, logarithmic| Axis { label: label.into(), logarithmic, ticks: vec![] };
    let figure = plot([&axis("x", true), &axis("y", true)], &[series]);
    assert_eq!(figure.matches("<circle").count(), 3);
    let table = Table {
        id: "t".into(),
        title: "T".into(),
        about: "1 < 2".into(),
        head: vec!["a".into(), "b".into()],
        rows: vec![vec!["x, \"y\"".into(), ".25".into()]],
    };
    assert_eq!(table.csv(), "a,b\n\"x, \"\"y\"\"\",.25\n");
    assert!(table.markdown().ends_with("| a | b |\n| --- | ---: |\n| x, \"y\" | .25 |\n"));
    let chapter = Chapter { title: "C".into(), figures: vec![figure], tables: vec![table], ..Chapter::default() };
    let page = page("P", "about", &[chapter]);
    assert!(page.contains("<td>.25</td>") && page.contains("1 &lt; 2") && page.contains("prefers-color-scheme:dark"));
    for foreign in ["http", "<script", "<link", "url(", "NaN", "inf"] {
        assert!(!page.contains(foreign), "{foreign}");
    }
}
