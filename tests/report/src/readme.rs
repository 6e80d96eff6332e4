//! The README's figures: tables between markers, written by the report and checked for their shape by a test.
//!
//! A block stands between `<!-- report: NAME -->` and `<!-- /report -->`. The same function makes its text from figures
//! and, for the test, from nothing: rows and columns are those of the list of samplers, whatever the numbers are.

use crate::error_part::{Errors, short};
use crate::family::Family;
use crate::filter::SIGMA_1;
use crate::samplers;
use crate::speed::Speeds;
use std::path::Path;

/// Sample counts of the error block, which all are in `error_part::COUNTS`.
const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];
/// Dimensions and samples per pixel of the cost block.
const COSTS: [(usize, u32); 6] = [(1, 1), (1, 16), (2, 1), (2, 16), (2, 256), (4, 16)];

/// The names of all blocks.
pub const BLOCKS: [&str; 2] = ["error", "cost"];

/// Not in the README: a second plain white noise, which is as the first, and peers that are there for what they do in
/// several dimensions at once.
const LEFT_OUT: [&str; 6] =
    ["rand", "sobol-joint", "openqmc-sobol-bn", "openqmc-lattice-bn", "openqmc-pmj-bn", "sobol-z"];

/// The rows.
fn names() -> Vec<&'static str> {
    samplers::NAMES.iter().copied().filter(|name| !LEFT_OUT.contains(name)).collect()
}

/// What a block is filled with; without figures every number is a 0.
#[derive(Clone, Copy, Debug)]
pub struct Figures<'a> {
    pub errors: &'a Errors,
    pub speeds: &'a Speeds,
}

/// The text at a row and a column.
type Cell<'a> = dyn Fn(usize, usize) -> String + 'a;

/// The text of a block.
pub fn block(name: &str, figures: Option<Figures>) -> Option<String> {
    let (head, cell): (Vec<String>, Box<Cell>) = match name {
        "error" => {
            let w = move |row: usize, column: usize| {
                let found = |k: usize| figures.map(|f| w(f.errors, names()[row], COUNTS[column], k));
                Family::BOTH.map(|family| short(found(family as usize).unwrap_or(0.0))).join(" / ")
            };
            (COUNTS.map(|count| format!("{count} spp")).to_vec(), Box::new(w))
        }
        "cost" => {
            let cost = move |row: usize, column: usize| {
                let (name, (dimensions, spp)) = (names()[row], COSTS.get(column).copied().unwrap_or((0, 0)));
                if column == COSTS.len() {
                    return samplers::bytes(names()[row]).to_string();
                }
                format!("{:.1}", figures.and_then(|f| f.speeds.of(name, dimensions, spp)).unwrap_or(0.0))
            };
            let heads = COSTS.map(|(dimensions, spp)| format!("{dimensions}D, {spp} spp"));
            (heads.into_iter().chain(["table bytes".into()]).collect(), Box::new(cost))
        }
        _ => return None,
    };
    let mut text = format!("| sampler | {} |\n|---|{}\n", head.join(" | "), "---:|".repeat(head.len()));
    for (row, name) in names().iter().enumerate() {
        let cells: Vec<String> = (0..head.len()).map(|column| cell(row, column)).collect();
        text += &format!("| {name} | {} |\n", cells.join(" | "));
    }
    Some(text)
}

fn w(errors: &Errors, name: &str, count: u32, family: usize) -> f64 {
    let found = errors.entries.iter().find(|entry| entry.name == name && entry.measured.count == count);
    found.map_or(0.0, |entry| entry.figures[family].w[SIGMA_1].mean)
}

/// Writes all blocks that a file has markers for; a line says what is wrong with them.
pub fn update(path: &Path, figures: Figures) -> Result<(), String> {
    let say = |error: std::io::Error| format!("{} cannot be updated ({error})", path.display());
    let text = std::fs::read_to_string(path).map_err(say)?;
    let text = replace(&text, |name| block(name, Some(figures)))?;
    std::fs::write(path, text).map_err(say)
}

/// Replaces what stands between markers.
fn replace(text: &str, block: impl Fn(&str) -> Option<String>) -> Result<String, String> {
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(OPEN) {
        let (name, after) = after.split_once(" -->\n").ok_or(format!("a marker \"{OPEN}\" does not end its line"))?;
        let (_, after) = after.split_once(CLOSE).ok_or(format!("block {name:?} is not closed: add \"{CLOSE}\""))?;
        let new = block(name).ok_or(format!("block {name:?} is unknown: {} are known", BLOCKS.join(", ")))?;
        out += &format!("{before}{OPEN}{name} -->\n{new}{CLOSE}");
        rest = after;
    }
    Ok(out + rest)
}

const OPEN: &str = "<!-- report: ";
const CLOSE: &str = "<!-- /report -->";

#[cfg(test)]
mod checks {
    use super::*;

    /// Every number made a 0, so that only the shape is left.
    fn shape(block: &str) -> String {
        let cell = |cell: &str| {
            let number = |part: &str| part.trim().parse::<f64>().is_ok();
            if cell.split('/').all(number) { "0".repeat(cell.split('/').count()) } else { cell.trim().to_string() }
        };
        block.lines().map(|line| line.split('|').map(cell).collect::<Vec<_>>().join("|") + "\n").collect()
    }

    /// The README's blocks have the rows and columns that the generator would write today.
    #[test]
    fn the_readme_has_the_shape_of_the_report() {
        let readme = include_str!("../../../README.md");
        let mut names = Vec::new();
        for part in readme.split(OPEN).skip(1) {
            let (name, after) = part.split_once(" -->\n").expect("a marker ends its line");
            let (found, _) = after.split_once(CLOSE).unwrap_or_else(|| panic!("block {name} is not closed"));
            let expected = block(name, None).unwrap_or_else(|| panic!("block {name} is unknown"));
            assert_eq!(
                shape(found),
                shape(&expected),
                "block {name}: cargo run --release -p report -- --readme README.md"
            );
            names.push(name);
        }
        assert_eq!(names, BLOCKS, "blocks of README.md");
    }

    #[test]
    fn blocks_are_replaced_and_the_rest_stays() {
        let text = "a\n<!-- report: error -->\nold\n<!-- /report -->\nb <!-- c -->\n";
        let new = replace(text, |name| (name == "error").then(|| "new\n".into()));
        assert_eq!(new.as_deref(), Ok("a\n<!-- report: error -->\nnew\n<!-- /report -->\nb <!-- c -->\n"));
        assert!(replace("<!-- report: x -->\n<!-- /report -->", |_| None).is_err_and(|line| line.contains("unknown")));
        assert!(replace("<!-- report: x -->\n", |_| None).is_err_and(|line| line.contains("not closed")));
    }

    #[test]
    fn a_missing_row_or_column_is_seen() {
        let whole = block("error", None).expect("known");
        let without_row: String =
            whole.lines().filter(|line| !line.contains("| white |")).map(|l| format!("{l}\n")).collect();
        assert_ne!(shape(&whole), shape(&without_row));
        assert_ne!(shape(&whole), shape(&whole.replace(" | 4 spp", "")));
        assert_eq!(shape(&whole), shape(&whole.replace(".000 / .000", "1.25 / .031")));
        assert_ne!(shape(&whole), shape(&whole.replacen(".000 / .000", ".5", 1)));
    }
}
