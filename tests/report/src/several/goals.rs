//! What was asked of the joint sampler, beside what it gives and what the best of the others gives in the same run.

use super::family::Id;
use super::numbers::Form;
use super::render::{self, Rendered};
use super::results::Results;
use super::tables::number;
use crate::figures::Value;
use crate::samplers::{OURS, WHITE};
use crate::table::Table;

/// Samples per pixel of the goals.
const COUNTS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];

/// Where a figure comes from.
#[derive(Clone, Copy)]
enum From {
    /// A family after sigma 1, numbers from one domain.
    Family(Id),
    /// The render example after the filter of this place.
    Render(usize),
}

/// The most that mean and two standard errors may be, for known numbers of samples.
const GOALS: [(&str, From, [f64; 7]); 8] = [
    ("own pair, half-planes", From::Family(Id::Own), [0.60, 0.66, 0.70, 0.71, 0.71, 0.72, 0.70]),
    ("own pair, smooth", From::Family(Id::SmoothPair), [0.42, 0.42, 0.42, 0.42, 0.36, 0.32, 0.24]),
    ("across pairs, half-planes", From::Family(Id::Across), [0.72, 0.73, 0.73, 0.68, 0.58, 0.50, 0.44]),
    ("half-spaces, 5-D", From::Family(Id::Space5), [0.70, 0.77, 0.79, 0.78, 0.75, 0.69, 0.65]),
    ("smooth, 5-D", From::Family(Id::Smooth5), [0.62, 0.58, 0.56, 0.48, 0.40, 0.32, 0.22]),
    ("render example", From::Render(0), [0.48, 0.56, 0.66, 0.66, 0.66, 0.59, 0.53]),
    ("render example, sigma 2.1", From::Render(1), [0.40, 0.48, 0.58, 0.60, 0.60, 0.57, 0.50]),
    ("direct light, one number picks", From::Family(Id::Light), [0.68, 0.66, 0.62, 0.55, 0.48, 0.42, 0.36]),
];

/// A row a goal, for each of ours that was measured; none if none was.
pub fn table(results: &Results, rendered: &[Rendered]) -> Table {
    let counts: Vec<(usize, u32)> =
        COUNTS.into_iter().enumerate().filter(|(_, count)| results.counts.contains(count)).collect();
    let find = |name: &str, from: From, count: u32| -> Option<Value> {
        match from {
            From::Family(id) => {
                let cell = results.row(name, Form::One).iter().find(|cell| cell.count == count)?;
                Some(cell.w[id as usize][1])
            }
            From::Render(filter) => {
                let found = rendered.iter().find(|one| one.name == name && one.count == count)?;
                Some(found.w[render::SIGMAS[filter]])
            }
        }
    };
    let others: Vec<&str> = results.names.iter().copied().filter(|name| !OURS.contains(name)).collect();
    let row = |(ours, (goal, from, most)): (&&str, &(&str, From, [f64; 7]))| {
        let cell = |&(place, count): &(usize, u32)| {
            let Some(value) = find(ours, *from, count) else { return "–".to_string() };
            let mark = if value.mean + 2.0 * value.error > most[place] { "!" } else { "" };
            let best = others
                .iter()
                .filter(|name| **name != WHITE)
                .filter_map(|name| Some((find(name, *from, count)?, *name)));
            let best = best.min_by(|a, b| a.0.mean.total_cmp(&b.0.mean));
            let best = best.map_or(String::new(), |(value, name)| format!(", {} {name}", number(value, false)));
            let most = Value { mean: most[place], error: 0.0 };
            format!("{}{mark} ({}{best})", number(value, true), number(most, false))
        };
        core::iter::once(format!("{ours}: {goal}")).chain(counts.iter().map(cell)).collect()
    };
    let measured = OURS.iter().filter(|name| results.names.contains(name));
    let head =
        core::iter::once("samples".to_string()).chain(counts.iter().map(|(_, count)| count.to_string())).collect();
    Table {
        id: "several-goals".into(),
        title: "What was asked".into(),
        about: "W after sigma 1 if no other is named, with its standard error in thousandths; in brackets the goal and the \
                best of the others here. \"!\" where mean and two standard errors are above the goal."
            .into(),
        head,
        rows: measured.flat_map(|ours| GOALS.iter().map(move |goal| (ours, goal))).map(row).collect(),
    }
}
