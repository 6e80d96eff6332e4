//! Figures that are not measured here: samplers that are no Rust code, taken from earlier measurements by the same
//! definitions (2026-11). Marked as frozen wherever they are shown.

use crate::error_part::short;

/// The best published sampler in each cell of the W tables, at `error_part::COUNTS`: W at sigma 1, and whose it is.
const BEST: [(&str, [(f64, &str); 8]); 2] = [
    (
        "smooth",
        [
            (0.285, "2016 mask"),
            (0.381, "2019"),
            (0.462, "2019"),
            (0.526, "pbrt"),
            (0.535, "pbrt"),
            (0.567, "pbrt"),
            (0.552, "Cycles"),
            (0.517, "Cycles"),
        ],
    ),
    (
        "half-planes",
        [
            (0.471, "2016 mask"),
            (0.572, "2019"),
            (0.601, "2016 mask on a grid"),
            (0.712, "2019 and OpenQMC lattice"),
            (0.662, "OpenQMC lattice"),
            (0.744, "OpenQMC lattice"),
            (0.664, "OpenQMC lattice"),
            (0.731, "OpenQMC lattice"),
        ],
    ),
];

/// The row of a family's W table.
pub fn row(family: &str) -> Vec<String> {
    let (_, cells) = BEST.iter().find(|(name, _)| *name == family).expect("both families are there");
    let cells = cells.iter().map(|(w, whose)| format!("{} ({whose})", short(*w)));
    core::iter::once("best published (frozen figures)".to_string()).chain(cells).collect()
}
