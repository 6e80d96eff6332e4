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

/// W at sigma 1 on single integrands at 1, 4 and 16 samples (root mean square times gain, over the root mean square of
/// white noise): OpenQMC's blue-noise variants, and the 2016 mask on a grid.
const CLASSIC_COUNTS: [u32; 3] = [1, 4, 16];
const CLASSIC_NAMES: [&str; 3] = ["xy", "exp(-x²-y²)", "quarter disc"];
const CLASSIC: [(&str, [[Option<f64>; 3]; 3]); 3] = [
    (
        "OpenQMC Sobol",
        [
            [Some(0.51), Some(0.47), Some(0.61)],
            [Some(0.66), Some(0.71), Some(0.67)],
            [Some(0.86), Some(0.86), Some(0.80)],
        ],
    ),
    (
        "OpenQMC lattice",
        [
            [Some(0.52), Some(0.47), Some(0.63)],
            [Some(0.93), Some(1.03), Some(0.53)],
            [Some(1.76), Some(1.95), Some(0.68)],
        ],
    ),
    ("2016 mask on a grid", [[Some(0.30), Some(0.25), Some(0.45)], [Some(0.64), Some(0.84), Some(0.50)], [None; 3]]),
];

/// The rows of a table of single integrands; what was not measured is a dash.
pub fn classic_rows(count: u32, names: &[&str]) -> Vec<Vec<String>> {
    let Some(at) = CLASSIC_COUNTS.iter().position(|&c| c == count) else { return Vec::new() };
    let known = CLASSIC.iter().filter(|(_, cells)| cells[at].iter().any(Option::is_some));
    let cell = |cells: &[Option<f64>; 3], name: &str| {
        let place = CLASSIC_NAMES.iter().position(|known| *known == name);
        place.and_then(|k| cells[k]).map_or("–".to_string(), short)
    };
    let row = |(whose, cells): &(&str, [[Option<f64>; 3]; 3])| {
        let cells = names.iter().map(|name| cell(&cells[at], name));
        core::iter::once(format!("{whose} (frozen)")).chain(cells).collect()
    };
    known.map(row).collect()
}
