//! Finds the constants of the joint net (`bluedither::net`) and writes them to `tables/net.txt`: an order for each
//! number of samples, then the columns of frames. A quarter of an hour of two cores.
//!
//! ```sh
//! cargo run --release -p search
//! ```
//! The integrands are random half-spaces and smooth functions of two, three and five numbers; the evaluation (`report
//! -- several`) uses others, and nothing here is taken from it. All sums are in a fixed order and all functions libm's,
//! so that the outcome is the same on every machine.

mod anneal;
mod energy;
mod file;
mod frames;
mod map;
mod power;
mod random;
mod response;
mod ridge;

use energy::{Model, Training};
use map::Map;
use power::{COUNTS, Family};
use rayon::prelude::*;

/// log₂ of the numbers of samples that have an order, and tries; the last order is for any number.
const ORDERS: [(Option<usize>, usize); 9] = [
    (Some(0), 300_000),
    (Some(1), 200_000),
    (Some(2), 200_000),
    (Some(3), 150_000),
    (Some(4), 150_000),
    (Some(5), 120_000),
    (Some(6), 120_000),
    (Some(8), 100_000),
    (None, 300_000),
];

fn main() -> std::io::Result<()> {
    let training = Training {
        pair: [Family::new(101, 2, false, 400), Family::new(102, 2, true, 200)],
        several: [Family::new(104, 3, false, 200), Family::new(105, 5, false, 200), Family::new(106, 5, true, 160)],
    };
    eprintln!("power of the training integrands");
    let costs = response::costs();
    // The longest first.
    let mut found: Vec<(usize, Map)> = ORDERS
        .into_par_iter()
        .enumerate()
        .with_max_len(1)
        .rev()
        .map(|(place, (count, tries))| (place, find(&training, &costs, count, tries)))
        .collect();
    found.sort_by_key(|&(place, _)| place);
    let maps: Vec<Map> = found.into_iter().map(|(_, map)| map).collect();
    file::write(&maps)
}

fn find(training: &Training, costs: &[f32], count: Option<usize>, tries: usize) -> Map {
    let (counts, columns) = match count {
        Some(m) => (m..m + 1, m),
        None => (0..COUNTS, 10),
    };
    let models: Vec<Model> = counts.map(|m| Model::new(training, m, count.is_some(), costs)).collect();
    let (energy, map) = anneal::anneal(&models, Map::random(3), columns, tries, 1);
    eprintln!("order for {count:?}: energy {energy:.4} after {tries} tries");
    map
}
