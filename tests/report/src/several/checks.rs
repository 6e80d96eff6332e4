//! Tests of the judge itself.

use super::family::{ALL, FAMILIES, Id};
use super::integrands::Integrands;
use super::numbers::Form;
use super::results::{Cell, Results, SIGMAS};
use super::tables;
use crate::analysis::random::seeds;
use crate::figures::Value;
use crate::samplers::WHITE;
use clap::Parser;

/// White noise against white noise of other seeds, from one domain and from several: 1, and spikes of chance.
#[test]
fn white_is_one() {
    let results = Results::measure(&[WHITE], &[1, 4], [1, 8]);
    for cell in &results.cells {
        for (family, w) in FAMILIES.iter().zip(&cell.w) {
            for (sigma, w) in SIGMAS.iter().zip(w) {
                let what = format!("{}, {:?}, {} samples, sigma {sigma}: {w:?}", family.name, cell.form, cell.count);
                assert!((w.mean - 1.0).abs() < 5.0 * w.error + 0.01, "{what}");
                assert!(w.error < 0.08, "{what}");
            }
        }
        for (family, [median, worst]) in FAMILIES.iter().zip(&cell.spikes) {
            assert!((6.0..9.0).contains(median) && *worst < 30.0, "{}: {median} {worst}", family.name);
        }
    }
}

/// Exact values against a Sobol integration of other points: formulas, and what was integrated with more.
#[test]
fn exact_values_are_exact() {
    let integrands = Integrands::new();
    let found = integrands.integrate(1 << 16, !seeds::INTEGRATION as u32);
    assert_eq!(found.len(), ALL);
    for family in FAMILIES {
        // What has an edge converges slowly; a smooth function nearly at once.
        let is_smooth = family.normalised && family.first != Id::Light.family().first;
        let bound = if is_smooth { 5e-4 } else { 3e-3 };
        for k in family.range() {
            let error = integrands.error(k, found[k] as f32, 1);
            assert!(error.abs() < bound, "{}, {}: {error}", family.name, k - family.first);
        }
    }
}

/// Families differ in what they ask for: an own pair reads one pair, a half-space of three three dimensions.
#[test]
fn families_read_their_dimensions() {
    let integrands = Integrands::new();
    let value = |x: &[f32; 8]| {
        let mut sums = vec![0.0; ALL];
        integrands.add(x, &mut sums);
        sums
    };
    // Which dimensions change a value, over many points.
    let mut random = crate::analysis::random::Random::new(3);
    let mut read = vec![0u32; ALL];
    for _ in 0..3000 {
        let mut x: [f32; 8] = core::array::from_fn(|_| random.uniform() as f32);
        let before = value(&x);
        let d = random.below(8);
        x[d] = random.uniform() as f32;
        for ((read, before), after) in read.iter_mut().zip(before).zip(value(&x)) {
            *read |= u32::from(before != after) << d;
        }
    }
    for (id, most) in [(Id::Own, 2), (Id::Across, 2), (Id::Space3, 3), (Id::Space5, 5), (Id::Product, 4)] {
        for read in &read[id.family().range()] {
            assert!(read.count_ones() <= most && *read != 0, "{}: {read:08b}", id.family().name);
        }
    }
    for (id, exactly) in [(Id::Below, 2), (Id::Xor, 2), (Id::Smooth5, 5), (Id::Smooth8, 8)] {
        for read in &read[id.family().range()] {
            assert_eq!(read.count_ones(), exactly, "{}: {read:08b}", id.family().name);
        }
    }
    let pair_of = |set: u32| (0..4).filter(|k| set >> (2 * k) & 3 != 0).count();
    assert!(read[Id::Own.family().range()].iter().all(|set| pair_of(*set) == 1));
    // A line may be so steep that one of its numbers never shows.
    assert!(read[Id::Across.family().range()].iter().all(|set| pair_of(*set) == set.count_ones() as usize));
    assert!(read[Id::Light.family().range()].iter().all(|set| *set == 0b1101));
}

/// A cell is harmful when it is above 1 by more than two standard errors, and the worst comes first.
#[test]
fn harm_is_listed() {
    let value = |mean: f64| Value { mean, error: 0.01 };
    let mut w = vec![[value(1.015); SIGMAS.len()]; FAMILIES.len()];
    w[Id::Own as usize][1] = value(1.05);
    w[Id::Light as usize][4] = value(1.25);
    w[Id::Xor as usize][2] = value(9.0);
    let cell = |form| Cell {
        name: "sampler",
        form,
        count: 4,
        w: w.clone(),
        errors: w.clone(),
        spikes: vec![],
        images: vec![],
        scales: vec![],
    };
    let cells = Form::BOTH.map(cell).into();
    let [count, list] = &tables::harm(&Results { names: vec!["sampler"], counts: vec![4], cells })[..] else {
        panic!("two tables")
    };
    assert_eq!(count.rows, [["sampler", "4 of 110", "2 of 20"]]);
    let families: Vec<&str> = list.rows.iter().map(|row| row[2].as_str()).collect();
    assert_eq!(families, [Id::Light, Id::Light, Id::Own, Id::Own].map(|id| id.family().name));
}

/// The chapter itself, quickly: a picture of six families beside each other, every figure in one file.
#[test]
fn a_run_writes_figures_and_pictures() {
    let out = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/report-several-check");
    _ = std::fs::remove_dir_all(&out);
    let path = out.to_str().expect("a path in UTF-8");
    let words =
        ["report", "several", "--quick", "--samplers", "sampler", "--spp", "2,1", "--seeds", "2", "--out", path];
    crate::run(&crate::arguments::Arguments::parse_from(words)).expect("a run");
    let text = std::fs::read_to_string(out.join("several.csv")).expect("figures");
    // Three samplers, two forms, two numbers of samples; of each family W after five filters and two spikes.
    assert_eq!(text.lines().count(), 1 + 3 * 2 * 2 * FAMILIES.len() * (SIGMAS.len() + 2));
    assert!(!text.contains("NaN") && !text.contains("inf"), "a figure is no number");
    let goals = std::fs::read_to_string(out.join("several-goals.csv")).expect("goals");
    assert_eq!(goals.lines().count(), 1 + 2 * 8, "{goals}");
    let picture = image::open(out.join("several/sampler-progressive-several-domains-001spp.png")).expect("a picture");
    assert_eq!([picture.width(), picture.height()], [6 * 512 + 5 * 8, 512]);
}
