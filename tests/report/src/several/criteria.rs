//! What else was asked of the joint sampler, cell by cell over the plain families: to be no worse than the best of the
//! others, than its own known form, than fewer samples.

use super::family::FAMILIES;
use super::numbers::Form;
use super::results::{Cell, Results, SIGMAS};
use super::tables::number;
use crate::figures::Value;
use crate::samplers::{OURS, WHITE};
use crate::table::Table;

/// A cell that is not as asked: by how much, and what it is.
struct Miss {
    excess: f64,
    row: Vec<String>,
}

/// Every cell that is not as asked, the worst first; none if ours was not measured.
pub fn table(results: &Results) -> Table {
    let others: Vec<&str> =
        results.names.iter().copied().filter(|name| !OURS.contains(name) && *name != WHITE).collect();
    let mut misses = Vec::new();
    for ours in OURS {
        let cells = results.row(ours, Form::One);
        for (place, cell) in cells.iter().enumerate() {
            let at = |name: &str| results.row(name, Form::One).get(place);
            let earlier = |count: u32| cells.iter().find(|cell| cell.count == count);
            let mut check = |rule: &str, other: &Cell, family: usize, sigma: usize, most: f64| {
                // Of fewer samples the error itself counts: white noise's falls between powers of two as well.
                let figure =
                    |cell: &Cell| if rule == "fewer" { cell.errors[family][sigma] } else { cell.w[family][sigma] };
                let [found, held] = [cell, other].map(figure);
                let unit = if rule == "fewer" { held.mean } else { 1.0 };
                let [found, held] = [found, held].map(|v| Value { mean: v.mean / unit, error: v.error / unit });
                // Above by more than both errors explain.
                let excess = found.mean - most * held.mean - 2.0 * found.error.hypot(most * held.error);
                if excess > 0.0 {
                    let what = [ours.into(), rule.into(), FAMILIES[family].name.into(), cell.count.to_string()];
                    let against = format!("{} ({}, {} spp)", number(held, true), other.name, other.count);
                    let figures = [SIGMAS[sigma].to_string(), number(found, true), against];
                    misses.push(Miss { excess: excess / held.mean, row: [&what[..], &figures].concat() });
                }
            };
            let plain = || (0..FAMILIES.len()).filter(|family| FAMILIES[*family].plain);
            for (family, sigma) in plain().flat_map(|family| (0..SIGMAS.len()).map(move |sigma| (family, sigma))) {
                let of = |cell: &&Cell| cell.w[family][sigma].mean;
                let best = others.iter().filter_map(|name| at(name)).min_by(|a, b| of(a).total_cmp(&of(b)));
                if let Some(best) = best.filter(|_| cell.count > 1 && sigma > 0) {
                    check("best", best, family, sigma, if sigma == 1 { 1.0 } else { 1.1 });
                }
                if let Some(known) = at(OURS[0]).filter(|_| ours == OURS[1]) {
                    check("known", known, family, sigma, 1.15);
                }
            }
            for (family, sigma) in plain().flat_map(|family| (0..SIGMAS.len()).map(move |sigma| (family, sigma))) {
                if let Some(fewer) = earlier(64).filter(|_| cell.count == 256) {
                    check("64 spp", fewer, family, sigma, 1.0);
                }
                let power = 1 << cell.count.ilog2();
                if let Some(fewer) = earlier(power).filter(|_| cell.count != power) {
                    check("fewer", fewer, family, sigma, 1.0);
                }
            }
        }
    }
    misses.sort_by(|a, b| b.excess.total_cmp(&a.excess));
    Table {
        id: "several-criteria".into(),
        title: "Cells that are not as asked".into(),
        about: "\"best\": at or below the best of the others here after sigma 1, within 1.1 times it after wider filters, \
                from two samples on; \"known\": progressive within 1.15 times; \"64 spp\": W of 256 samples not above \
                that; \"fewer\": the error itself, between powers of two, not above that of the power below, which is made 1. By more than \
                two standard errors, the worst first."
            .into(),
        head: ["sampler", "rule", "family", "samples", "sigma", "W", "held against"].map(String::from).to_vec(),
        rows: misses.into_iter().map(|miss| miss.row).collect(),
    }
}

/// One sample: the geometric mean of W over the plain families after each filter, a row a sampler.
pub fn one_sample(results: &Results) -> Table {
    let row = |name: &&'static str| {
        let cell = results.row(name, Form::One).iter().find(|cell| cell.count == 1);
        let mean = |sigma: usize| {
            cell.map_or("–".to_string(), |cell| {
                let plain = || FAMILIES.iter().zip(&cell.w).filter(|(family, _)| family.plain);
                let sum: f64 = plain().map(|(_, w)| w[sigma].mean.ln()).sum();
                number(Value { mean: (sum / plain().count() as f64).exp(), error: 0.0 }, false)
            })
        };
        core::iter::once((*name).to_string()).chain((0..SIGMAS.len()).map(mean)).collect()
    };
    Table {
        id: "several-one-sample".into(),
        title: "One sample, all plain families".into(),
        about: "Geometric mean of W, numbers from one domain.".into(),
        head: core::iter::once("sigma".to_string()).chain(SIGMAS.map(|sigma| sigma.to_string())).collect(),
        rows: results.names.iter().map(row).collect(),
    }
}
