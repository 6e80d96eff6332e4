//! Finds the constants of the linear pixel order. Run by `tests/bake/linear_order.rs`, which freezes them in `tables/`.
//!
//! The points of all pixels of a block are sums modulo 2 of columns and a random digital shift, so that the error of an
//! estimate is Σ f̂(c)·χ_c(shift)·χ_w(c)(pixel) over the characters c of the dual net: the pairs of digit sets that all
//! samples of a pixel leave odd or all leave even. In the mean over shifts the signs of different c are independent,
//! and the power of the filtered error is
//!
//! ```text
//! J = Σ_c |f̂(c)|²·A(w(c))      w(c) = XOR of w over the digits in c: a Walsh function over the block
//!                              A(w) = what a Gaussian leaves of that function, white noise 1
//! ```
//! Both the dual net and w are linear in the digits, so that an evaluation is a sum over some thousand table entries:
//! 10⁵ a second, without rendering. Three searches follow each other, all by simulated annealing:
//!
//! 1. [`net`]: rows of Sobol's matrices, scrambled (Matoušek 1998), for little power in the dual nets of all prefixes;
//! 2. [`rows`]: these rows again, together with the columns of the progressive order;
//! 3. [`anneal`]: sets of columns for each number of samples, whose mean spectrum must have no spikes.
//!
//! The training integrands are random half-planes and random smooth functions; the evaluation uses others, and nothing
//! here is taken from it. All sums
//! are in a fixed order and all functions libm's, so that the outcome is the same on every machine.

pub mod anneal;
pub mod cooling;
pub mod net;
pub mod power;
pub mod response;
pub mod rows;

use rayon::prelude::*;

use crate::bake::linear_order::LinearOrder;
use crate::linear::{BLOCK_LOG2, Columns, ORDERS, Order, SETS};
use anneal::{Anneal, Map};
use net::{Duals, Rows};
use power::Power;
use response::Responses;

/// Numbers of samples 2⁰ … 2⁸.
pub const COUNTS: usize = ORDERS - 1;
/// The two families of integrands, half-planes and smooth.
pub const FAMILIES: usize = 2;

/// W at sigma 1 that counts as 1, for half-planes and smooth integrands at 1, 2, 4, …, 256 samples: what the best of the
/// published methods reach (the frozen figures of `tests/report`; at 128 the geometric mean of 64 and 256). First
/// samples count for less: half as much again is asked of them.
const GOALS: [[f64; COUNTS]; FAMILIES] = [
    [1.5 * 0.471, 0.572, 0.601, 0.712, 0.662, 0.744, 0.664, 0.697, 0.731],
    [1.5 * 0.285, 0.381, 0.462, 0.526, 0.535, 0.567, 0.552, 0.534, 0.517],
];
/// What smooth integrands weigh beside half-planes at known numbers of samples: little at 2, where half-planes are hard.
const SMOOTH: [f64; COUNTS] = [0.3, 0.03, 0.3, 0.3, 0.2, 0.2, 0.2, 0.2, 0.2];

/// Finds them all: some minutes. `say` is told what is done.
pub fn find(say: &(dyn Fn(String) + Sync)) -> LinearOrder {
    let power = Power::of_training();
    say("power of the training integrands".into());
    let responses = Responses::new();
    let (rows, map) = rows::find(&power, &responses, say);
    finish(&power, &responses, &rows, &map, say)
}

/// Finds the orders for these rows.
fn finish(power: &Power, responses: &Responses, rows: &Rows, map: &Map, say: &(dyn Fn(String) + Sync)) -> LinearOrder {
    let duals: Vec<Duals> = (0..COUNTS).map(|m| Duals::new(power, m, &net::prefix(rows, m))).collect();
    let orders: Vec<Order> =
        (0..ORDERS).into_par_iter().map(|which| order(which, map, &duals, responses, say)).collect();
    LinearOrder { sequence: net::sequence(rows), orders: orders.try_into().expect("one for each") }
}

/// The sets for 2^`which` samples, or, last, for any number.
fn order(which: usize, start: &Map, duals: &[Duals], responses: &Responses, say: &(dyn Fn(String) + Sync)) -> Order {
    let progressive = which == ORDERS - 1;
    let mut search = if progressive {
        Anneal::new(duals, responses, lane, 0.99, 24)
    } else {
        Anneal::new(
            &duals[which..=which],
            responses,
            |m, family| (m == 0).then_some((family, [1.0, SMOOTH[which]][family])),
            0.98,
            1,
        )
    };
    search.limit_spectrum(0.05, [8.0, 18.0]);
    // Sets of the progressive order begin with the map that was found together with the rows: from elsewhere none is as
    // good.
    let first = |set| if progressive { *start } else { anneal::random_map((which * SETS + set) as u64) };
    let mut maps: Vec<Map> = (0..SETS).map(first).collect();
    let (tries, heat) = if progressive { (25_000, 0.006) } else { (15_000, 0.1) };
    let energy = search.run(&mut maps, which as u64, tries, heat);
    say(format!(
        "order {which}: {energy:.4}, W {}, spikes {:.0?}",
        table(duals, &maps, responses),
        search.spikes(&maps)
    ));
    maps.iter().map(columns).collect::<Vec<_>>().try_into().expect("one for each")
}

/// Where a family at 2^`m` samples is summed, and with which weight.
fn lane(m: usize, family: usize) -> Option<(usize, f64)> {
    Some((family * COUNTS + m, (GOALS[family][m] * GOALS[family][m]).recip()))
}

/// W of half-planes and smooth integrands for every number of samples, as predicted.
fn table(duals: &[Duals], maps: &[Map], responses: &Responses) -> String {
    let w = |dual: &Duals| {
        let sums = maps.iter().map(|map| dual.filtered(map, &responses.sigma_1));
        let total = sums.fold([0.0; FAMILIES], |a, b| [a[0] + b[0], a[1] + b[1]]);
        let w = total.map(|sum| (sum / maps.len() as f64).sqrt());
        format!("{:.3}/{:.3}", w[0], w[1])
    };
    duals.iter().map(w).collect::<Vec<_>>().join(" ")
}

/// From digits to words: the transpose.
fn columns(map: &Map) -> Columns {
    core::array::from_fn(|place| {
        let bit = place / 2 + place % 2 * BLOCK_LOG2 as usize;
        let digits = |dimension: usize| {
            (0..net::ROWS).fold(0, |word: u32, j| word | (u32::from(map[dimension][j]) >> bit & 1) << (15 - j))
        };
        digits(0) << 16 | digits(1)
    })
}
