//! No table without a check: every input is derived again from its formula and every table baked again, and both are
//! held against `tables/`. `write_tables` writes them anew after a recipe was changed on purpose.

use core::cmp::Reverse;

use bluedither::{lattice, sequence, sobol};

use crate::bake::anneal::LANES;
use crate::bake::features::{Column, Pattern};
use crate::bake::filter::Filter;
use crate::bake::inputs::{ANNEAL, COSINE, Inputs, VOID_AND_CLUSTER};
use crate::bake::recipe::{self, Recipe};
use crate::bake::record::Digests;
use crate::bake::sequence::Columns;
use crate::effort::Effort;
use crate::{recorded, tables};
use rayon::prelude::*;

fn check(effort: Effort) {
    let (digests, inputs) = recorded();
    let differing: Vec<String> = recipe::all()
        .into_par_iter()
        .filter(|recipe| {
            let digest = crate::bake::digest::of_ranks(&recipe.bake(effort, &inputs));
            digests.get(effort.name(), &recipe.name()) != Some(digest)
        })
        .map(Recipe::name)
        .collect();
    assert!(differing.is_empty(), "not what tables/digests.txt says at {} effort: {differing:?}", effort.name());
}

#[test]
fn quick_tables_are_as_recorded() {
    check(Effort::Quick);
}

#[test]
fn normal_tables_are_as_recorded() {
    check(Effort::Normal);
}

#[test]
#[ignore = "bakes for a minute"]
fn thorough_tables_are_as_recorded() {
    check(Effort::Thorough);
}

/// What this build embedded is what it should have baked, whatever its optimisation level and threads.
#[test]
fn embedded_tables_are_as_recorded() {
    let (digests, inputs) = recorded();
    for (name, ranks) in embedded() {
        // Those for a filter of the user's own have no digest: they are baked once more.
        #[cfg(any(feature = "threshold-filtered-64", feature = "threshold-filtered-over-time-64"))]
        if name.contains("filtered") && bluedither::tables::FILTER != Filter::default().name() {
            let filter = Filter::parse(bluedither::tables::FILTER).expect("as the build has read it");
            let recipe = recipe::all().into_iter().find(|recipe| recipe.name() == name).expect("a recipe");
            let again = recipe.bake(bluedither::tables::EFFORT, &Inputs { filter, ..inputs.clone() });
            assert!(ranks == again, "{name} for {}", filter.name());
            continue;
        }
        _ = &inputs;
        let recorded = digests.get(bluedither::tables::EFFORT.name(), name);
        assert_eq!(recorded, Some(crate::bake::digest::of_ranks(&ranks)), "{name}");
    }
}

fn embedded() -> Vec<(&'static str, Vec<u16>)> {
    #[allow(unused_mut, reason = "without a mask feature there is no mask")]
    let mut all = Vec::new();
    let mut known = Vec::new();
    macro_rules! table {
        ($feature:literal, $name:literal, $table:ident, $kind:ident) => {
            known.push($name.to_string());
            #[cfg(feature = $feature)]
            all.push(($name, table!($table, $kind)));
        };
        ($table:ident, scalar) => {
            bluedither::tables::$table.ranks().as_flattened().to_vec()
        };
        ($table:ident, keys) => {
            numbers(&bluedither::tables::$table)
        };
        ($table:ident, frames) => {
            bluedither::tables::$table.frames().iter().flat_map(|mask| mask.ranks().as_flattened().to_vec()).collect()
        };
        ($table:ident, pairs) => {
            bluedither::tables::$table
                .frames()
                .iter()
                .flat_map(|mask| mask.ranks().as_flattened().as_flattened().to_vec())
                .collect()
        };
        ($table:ident, codes) => {
            bluedither::tables::$table.codes().as_flattened().to_vec()
        };
        ($table:ident, vector) => {
            bluedither::tables::$table.ranks().as_flattened().as_flattened().to_vec()
        };
    }
    table!("threshold-16", "threshold_16", THRESHOLD_16, scalar);
    table!("threshold-32", "threshold_32", THRESHOLD_32, scalar);
    table!("threshold-64", "threshold_64", THRESHOLD_64, scalar);
    table!("threshold-128", "threshold_128", THRESHOLD_128, scalar);
    table!("threshold-256", "threshold_256", THRESHOLD_256, scalar);
    table!("offset-1d-16", "offset_1d_16", OFFSET_1D_16, scalar);
    table!("offset-1d-32", "offset_1d_32", OFFSET_1D_32, scalar);
    table!("offset-1d-64", "offset_1d_64", OFFSET_1D_64, scalar);
    table!("offset-1d-128", "offset_1d_128", OFFSET_1D_128, scalar);
    table!("offset-2d-16", "offset_2d_16", OFFSET_2D_16, vector);
    table!("offset-2d-32", "offset_2d_32", OFFSET_2D_32, vector);
    table!("offset-2d-64", "offset_2d_64", OFFSET_2D_64, vector);
    table!("offset-2d-128", "offset_2d_128", OFFSET_2D_128, vector);
    table!("keys-64", "keys_64", KEYS_64, keys);
    table!("keys-128", "keys_128", KEYS_128, keys);
    table!("lattice-64", "lattice_64", LATTICE_64, vector);
    table!("threshold-over-time-32", "threshold_over_time_32", THRESHOLD_OVER_TIME_32, frames);
    table!("threshold-over-time-64", "threshold_over_time_64", THRESHOLD_OVER_TIME_64, frames);
    table!("threshold-over-time-128", "threshold_over_time_128", THRESHOLD_OVER_TIME_128, frames);
    table!("offset-2d-over-time-32", "offset_2d_over_time_32", OFFSET_2D_OVER_TIME_32, pairs);
    table!("offset-2d-over-time-64", "offset_2d_over_time_64", OFFSET_2D_OVER_TIME_64, pairs);
    table!("threshold-filtered-64", "threshold_filtered_64", THRESHOLD_FILTERED_64, scalar);
    table!(
        "threshold-filtered-over-time-64",
        "threshold_filtered_over_time_64",
        THRESHOLD_FILTERED_OVER_TIME_64,
        frames
    );
    table!("seed-permutation", "seed_permutation", SEED_PERMUTATION, codes);
    assert_eq!(known, recipe::all().into_iter().map(Recipe::name).collect::<Vec<_>>(), "a recipe without a line here");
    all
}

/// Keys as they are baked: the upper halves of two numbers.
#[allow(dead_code, reason = "without a feature of keys there are none")]
fn numbers<const S: usize>(keys: &bluedither::Keys<S>) -> Vec<u16> {
    (0..S * S).flat_map(|p| keys.key((p % S) as u32, (p / S) as u32)).map(|key| (key >> 16) as u16).collect()
}

#[test]
fn directions_are_as_recorded() {
    let (digests, _) = recorded();
    let all = crate::bake::directions::read(&tables(), &digests).expect("joe_kuo");
    assert_eq!(all.len(), 1024);
    macro_rules! table {
        ($feature:literal, $table:ident) => {
            #[cfg(feature = $feature)]
            for (d, numbers) in (0..).zip(&all) {
                let embedded: [u32; 32] = core::array::from_fn(|bit| bluedither::tables::$table.dimension(1 << bit, d));
                let first = &all[d as usize % (size_of_val(&bluedither::tables::$table) / 128)];
                assert_eq!(&embedded, first, "dimension {d} of {}: {numbers:?}", $feature);
            }
        };
    }
    table!("sobol-16", SOBOL_16);
    table!("sobol-64", SOBOL_64);
    table!("sobol-256", SOBOL_256);
    table!("sobol-1024", SOBOL_1024);
}

#[test]
fn threads_make_no_difference() {
    let (_, inputs) = recorded();
    let bake_all =
        || -> Vec<Vec<u16>> { recipe::all().par_iter().map(|recipe| recipe.bake(Effort::Quick, &inputs)).collect() };
    let with =
        |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool").install(bake_all);
    assert_eq!(with(1), with(3));
}

#[test]
fn inputs_are_their_formulas() {
    let (_, inputs) = recorded();
    assert_eq!(inputs, derived());
}

#[test]
fn kernels_over_time_are_their_formulas() {
    let weight = |scale: f64, t: usize| libm::round(scale * recipe::OWN * libm::exp(-((t * t) as f64) / 4.5)) as i32;
    assert_eq!(recipe::TIME_KERNEL, core::array::from_fn(|t| weight(1_048_576.0, t)));
    assert_eq!(recipe::OFFSET_TIME_KERNEL, core::array::from_fn(|t| weight(128.0, t)));
}

fn derived() -> Inputs {
    let list =
        |(_, count, entry): (&str, usize, fn(f64) -> f64)| (0..count).map(move |i| libm::round(entry(i as f64)) as i32);
    Inputs {
        void_and_cluster_kernel: list(VOID_AND_CLUSTER).collect(),
        anneal_kernel: list(ANNEAL).collect(),
        cosine: list(COSINE).collect(),
        features_1d: columns(Pattern::Regular, 48, [1.0, 0.3, 0.1]),
        features_2d: columns(Pattern::Sobol, 12, [1.0, 0.4, 0.15]),
        features_keys: key_columns([1.0, 0.5, 0.5, 0.5]),
        features_lattice: columns(Pattern::Lattice, 12, [1.0, 0.4, 0.15]),
        // Not a formula: sequence_file.rs checks it.
        sequence: Columns::read(&tables()).expect("the sequence"),
        filter: Filter::default(),
    }
}

/// The 48 columns of largest variance over a 64² value set, the largest first. `shares` are the variances that the
/// errors at 1, 4 and 16 samples get in total.
fn columns(pattern: Pattern, k_max: u32, shares: [f64; 3]) -> Vec<Column> {
    let channels = if pattern == Pattern::Regular { 1 } else { 2 };
    let set: Vec<[f64; 2]> = crate::bake::features::value_set(channels, 6)
        .iter()
        .map(|value| value.map(|rank| (f64::from(rank) + 0.5) / 4096.0))
        .collect();
    let mut all: Vec<(f64, f64, Column)> = Vec::new();
    for (samples, share) in [1u32, 4, 16].into_iter().zip(shares) {
        let mut block = Vec::new();
        for kx in 0..=k_max {
            for ky in 0..=if channels == 1 { 0 } else { k_max } {
                let k_squared = f64::from(kx * kx + ky * ky);
                if k_squared == 0.0 {
                    continue;
                }
                let weight = libm::pow(k_squared, -(channels as f64 + 1.0) / 4.0);
                let power =
                    set.iter().map(|&v| libm::pow(weight * error(pattern, samples, [kx, ky], v), 2.0)).sum::<f64>();
                block.push((power / set.len() as f64, weight, [kx, ky]));
            }
        }
        let scale = share / block.iter().map(|column| column.0).sum::<f64>();
        for (variance, weight, k) in block {
            let column = Column { samples, k, weight: 0 };
            all.push((variance * scale, weight * scale.sqrt() / f64::from(samples), column));
        }
    }
    // Mirrored columns have equal variances: their order must not hang on a last digit.
    all.sort_by_key(|(variance, _, column)| (Reverse((variance * 1e9) as u64), column.samples, column.k));
    all.truncate(LANES);
    // The largest feature becomes 63: sums of products of two cosines in 2.14 fixed point, times this, over 2^24.
    let largest = |(_, scale, column): &(f64, f64, Column)| {
        let errors = set.iter().map(|&v| error(pattern, column.samples, column.k, v).abs());
        errors.fold(0.0, f64::max) * scale * f64::from(column.samples)
    };
    let unit = 63.0 * 1024.0 / all.iter().map(largest).fold(0.0, f64::max);
    all.into_iter().map(|(_, scale, column)| Column { weight: libm::round(scale * unit) as i64, ..column }).collect()
}

/// The same for keys: for each prefix the 32 columns of largest variance over all blocks of the first 4096 points;
/// `shares` are variances of all columns.
fn key_columns(shares: [f64; 4]) -> Vec<Column> {
    const K_MAX: u32 = 24;
    let columns = Columns::read(&tables()).expect("the sequence");
    let points = crate::bake::keys::points(&sequence::Sequence::new(&columns.0), 4096);
    let waves = |digits: fn(&u32) -> u32| -> Vec<Vec<f64>> {
        let wave =
            |k: u32, p: &u32| libm::cos(core::f64::consts::PI * f64::from(k) * (f64::from(digits(p)) + 0.5) / 65_536.0);
        (0..=K_MAX).map(|k| points.iter().map(|p| wave(k, p)).collect()).collect()
    };
    let (waves_x, waves_y) = (waves(|p| p >> 16), waves(|p| p & 0xffff));
    let mut all: Vec<(f64, f64, Column)> = Vec::new();
    for (samples, share) in crate::bake::keys::PREFIXES.into_iter().zip(shares) {
        let mut block = Vec::new();
        for (kx, ky) in (0..=K_MAX).flat_map(|kx| (0..=K_MAX).map(move |ky| (kx, ky))).skip(1) {
            // A cosine of both has half the square of one alone.
            let norm = if kx > 0 && ky > 0 { core::f64::consts::SQRT_2 } else { 1.0 };
            let weight = norm * libm::pow(f64::from(kx * kx + ky * ky), -0.75);
            let products: Vec<f64> =
                waves_x[kx as usize].iter().zip(&waves_y[ky as usize]).map(|(x, y)| x * y).collect();
            let errors: Vec<f64> = products
                .chunks(samples as usize)
                .map(|block| weight * block.iter().sum::<f64>() / f64::from(samples))
                .collect();
            let variance = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
            let largest = errors.iter().fold(0.0f64, |largest, e| largest.max(e.abs()));
            block.push((variance, largest, weight, [kx, ky]));
        }
        let scale = (share / block.iter().map(|column| column.0).sum::<f64>()).sqrt();
        // Mirrored columns may have equal variances: their order must not hang on a last digit.
        block.sort_by_key(|&(variance, .., k)| (Reverse((variance * 1e9) as u64), k));
        for (_, largest, weight, k) in block.into_iter().take(crate::bake::keys::LANES) {
            let column = Column { samples, k, weight: 0 };
            all.push((largest * scale, weight * scale / f64::from(samples), column));
        }
    }
    // Larger tiles have further points, whose errors may be a little larger.
    let unit = 60.0 * 1024.0 / all.iter().map(|column| column.0).fold(0.0, f64::max);
    all.into_iter().map(|(_, weight, column)| Column { weight: libm::round(weight * unit) as i64, ..column }).collect()
}

/// The error of the mean of Π cos(π k_j x_j) over the pattern's first points, moved by `value`.
fn error(pattern: Pattern, samples: u32, k: [u32; 2], value: [f64; 2]) -> f64 {
    let term = |i: u32| -> f64 {
        let in_unit = |x: u32| f64::from(x) / 4_294_967_296.0;
        let point = match pattern {
            Pattern::Regular => [f64::from(i) / f64::from(samples), 0.0],
            Pattern::Sobol => sobol::point(i).map(in_unit),
            Pattern::Lattice => [lattice::EXEW[0], lattice::EXEW[1]].map(|z| in_unit(lattice::extensible(i, z))),
        };
        (0..2)
            .map(|j| {
                let x = point[j] + value[j];
                libm::cos(core::f64::consts::PI * f64::from(k[j]) * (x - x.floor()))
            })
            .product()
    };
    (0..samples).map(term).sum::<f64>() / f64::from(samples)
}

#[test]
#[ignore = "writes tables/"]
fn write_tables() {
    let inputs = derived();
    let mut digests = Digests::default();
    let mut input = |name: &str, head: &str, numbers: Vec<i64>, columns: usize| {
        digests.lines.push(("input".into(), name.into(), crate::bake::digest::digest(numbers.iter().copied())));
        let rows =
            numbers.chunks(columns).map(|row| row.iter().map(i64::to_string).collect::<Vec<_>>().join(" ") + "\n");
        let text = head.lines().map(|line| format!("# {line}\n")).chain(rows).collect::<String>();
        std::fs::write(tables().join(format!("{name}.txt")), text).expect("tables/ can be written");
    };
    let wide = |list: &[i32]| list.iter().map(|&v| i64::from(v)).collect::<Vec<_>>();
    let flat = |list: &[Column]| {
        let row = |c: &Column| [i64::from(c.samples), i64::from(c.k[0]), i64::from(c.k[1]), c.weight];
        list.iter().flat_map(row).collect::<Vec<_>>()
    };
    let derivation = "Written and checked by tests/bake/rebake.rs.";
    let formula = |what: &str| format!("{what}\n{derivation}");
    input(
        VOID_AND_CLUSTER.0,
        &formula(
            "round(2^20 * (exp(-r2 / (2 * 1.4^2)) + exp(-r2 / (2 * 2.5^2)) / 10)) at squared distance r2 = 0, 1, 2, ...",
        ),
        wide(&inputs.void_and_cluster_kernel),
        11,
    );
    input(
        ANNEAL.0,
        &formula("round(128 * exp(-r2 / 2.2^2)) at squared distance r2 = 0, 1, 2, ..."),
        wide(&inputs.anneal_kernel),
        5,
    );
    input(COSINE.0, &formula("round(2^14 * cos(pi * i / 512)), i = 0..=256."), wide(&inputs.cosine), 16);
    for (name, columns) in [
        ("features_1d", &inputs.features_1d),
        ("features_2d", &inputs.features_2d),
        ("features_keys", &inputs.features_keys),
        ("features_lattice", &inputs.features_lattice),
    ] {
        let head =
            "samples, kx, ky, weight: the features of the annealer (src/bake/features.rs), largest variance first.";
        input(name, &formula(head), flat(columns), 4);
    }
    // Not ours to derive: recorded as it stands.
    let words: Vec<i64> = include_str!("../../tables/joe_kuo.txt")
        .lines()
        .flat_map(|line| line.split('#').next().unwrap_or("").split_whitespace())
        .map(|word| word.parse().expect("an integer"))
        .collect();
    digests.lines.push(("input".into(), "joe_kuo".into(), crate::bake::digest::digest(words)));
    for effort in Effort::ALL {
        let recipes = recipe::all();
        let baked: Vec<u64> =
            recipes.par_iter().map(|recipe| crate::bake::digest::of_ranks(&recipe.bake(effort, &inputs))).collect();
        for (recipe, digest) in recipes.iter().zip(baked) {
            digests.lines.push((effort.name().into(), recipe.name(), digest));
        }
    }
    std::fs::write(tables().join("digests.txt"), digests.text()).expect("tables/ can be written");
}
