//! The search for the rows of the sequence.
//!
//! First for little power in what the prefixes leave over, then together with one map of the progressive order: the
//! rows decide which characters a map has to place.

use rayon::prelude::*;

use super::anneal::{Anneal, Map, Random, random_map};
use super::cooling::cool;
use super::net::{Candidates, Duals, Rows, add_a_row, prefix, sobol};
use super::power::Power;
use super::response::Responses;
use super::{COUNTS, lane, table};

const FIRST_TRIES: usize = 1500;
/// Independent searches, the best of which counts.
const ISLANDS: u64 = 2;
const STEPS: usize = 1500;

/// Smooth integrands at 128 and 256 samples are below what is asked for with almost any rows.
fn judged(m: usize, family: usize) -> Option<(usize, f64)> {
    lane(m, family).filter(|_| family == 0 || m < 7)
}

/// Finds the rows, and a map that goes with them. Some minutes.
pub fn find(power: &Power, responses: &Responses, say: &(dyn Fn(String) + Sync)) -> (Rows, Map) {
    let candidates = Candidates::all(power);
    let islands = (0..ISLANDS).into_par_iter().map(|seed| {
        let rows = of_little_power(&candidates, seed);
        with_columns(&candidates, responses, rows, seed, say)
    });
    let found: Vec<(f64, (Rows, Map))> = islands.collect();
    let best = found.into_iter().reduce(|a, b| if b.0 < a.0 { b } else { a });
    best.expect("there is an island").1
}

/// Rows whose prefixes leave over little: half-planes first, most at few samples.
fn of_little_power(candidates: &[Candidates], seed: u64) -> Rows {
    let weight = |m: usize| if m <= 2 { [2.0, 0.1] } else { [1.0, 0.02] };
    let cost = |rows: &Rows| -> f64 {
        let of = |m: usize| {
            let [half_planes, smooth] = candidates[m].left_over(&prefix(rows, m));
            weight(m)[0] * libm::log(half_planes) + weight(m)[1] * libm::log(smooth)
        };
        (1..COUNTS).map(of).sum()
    };
    cool(sobol(seed), FIRST_TRIES, 0.3, &mut Random::new(seed), add_a_row, cost).1
}

/// Changes rows, anneals a map briefly, keeps both if they are better together.
fn with_columns(
    candidates: &[Candidates],
    responses: &Responses,
    mut rows: Rows,
    seed: u64,
    say: &(dyn Fn(String) + Sync),
) -> (f64, (Rows, Map)) {
    let duals = |rows: &Rows| -> Vec<Duals> { (0..COUNTS).map(|m| candidates[m].duals(&prefix(rows, m))).collect() };
    let search = |rows: &Rows| Anneal::new(&duals(rows), responses, judged, 0.985, 24);
    let mut random = Random::new(seed);
    let mut map: [Map; 1] = [random_map(seed)];
    let mut current = search(&rows).run(&mut map, seed, 300_000, 0.1);
    let mut best = (current, rows, map);
    for step in 0..STEPS {
        let mut new_rows = rows;
        // Now and then the map alone.
        if step % 4 != 3 {
            for _ in 0..1 + random.below(2) {
                add_a_row(&mut new_rows, &mut random);
            }
        }
        let mut new_map = map;
        let heat = [0.004, 0.015, 0.04][random.below(3)];
        let new = search(&new_rows).run(&mut new_map, seed << 32 | step as u64, 12_000, heat);
        let temperature = 0.004 * (1.0 - step as f64 / STEPS as f64);
        if new - current < -temperature * libm::log(random.uniform().max(1e-12)) {
            (current, rows, map) = (new, new_rows, new_map);
            if current < best.0 {
                best = (current, rows, map);
            }
        }
        if step % 500 == 499 {
            let w = table(&duals(&best.1), &best.2, responses);
            say(format!("rows {seed}, step {}: {:.4}, W {w}", step + 1, best.0));
        }
    }
    (best.0, (best.1, best.2[0]))
}
