//! The text that the library includes: typed arrays, right in alignment and byte order on every target, whose wrong
//! length would not compile.

use core::fmt::Write as _;

use super::directions;
use super::filter::Filter;
use super::recipe::{Kind, Recipe};
use super::retarget;
use crate::effort::Effort;

/// The constant that says at which level the tables below were baked.
pub fn effort(effort: Effort) -> String {
    format!(
        "/// The level at which the tables were baked.\n\
         pub const EFFORT: Effort = Effort::{effort:?};\n"
    )
}

/// The constant that says for which filter the filtered masks below were baked.
pub fn filter(filter: Filter) -> String {
    format!(
        "/// The filter for which the `threshold-filtered` masks were baked, see `BLUEDITHER_FILTER`.\n\
         pub const FILTER: &str = {:?};\n",
        filter.name()
    )
}

/// One `static` of the table's type, with its docs.
pub fn table(recipe: Recipe, effort: Effort, ranks: &[u16]) -> String {
    let (size, frames) = (recipe.size(), recipe.frames());
    let scalar = || format!("ScalarMask::<{size}>");
    let vector = || format!("VectorMask::<2, {size}>");
    let over_time = |mask| format!("crate::frames::masks::{mask}::<{size}, {frames}>");
    let keys = || format!("Keys::<{size}>");
    let (what, made) = match recipe.kind {
        Kind::Threshold => ("Threshold mask (void-and-cluster)", scalar()),
        Kind::Offset1d => ("Offset mask of one channel", scalar()),
        Kind::Offset2d => ("Offset mask of two channels", vector()),
        Kind::OverTime => ("Threshold masks over time (void-and-cluster)", over_time("TimeMask")),
        Kind::Offset2dOverTime => ("Offset masks of two channels over time", over_time("VectorTimeMask")),
        Kind::Filtered => ("Threshold mask for [`FILTER`]", scalar()),
        Kind::FilteredOverTime => ("Threshold masks over time for [`FILTER`]", over_time("TimeMask")),
        Kind::Retargeting => {
            ("Swaps of seeds between two frames, for [`THRESHOLD_64`]", "crate::frames::seeds::Retargeting".into())
        }
        Kind::Lattice => ("Shifts of a rank-1 lattice", vector()),
        Kind::Keys => ("Scrambling keys for any number of samples", keys()),
    };
    let several = if frames == 1 { String::new() } else { format!(", {frames} frames") };
    let tiles = ranks.chunks(ranks.len() / frames).map(|tile| rows(recipe, tile));
    let numbers = match recipe.kind {
        // A `static` a frame: larger ones cost the compiler much memory.
        Kind::OverTime | Kind::FilteredOverTime | Kind::Offset2dOverTime => {
            let mask = if recipe.channels() == 1 { scalar() } else { vector() };
            let kind = mask.replace("::<", "<");
            list(tiles.map(|tile| format!("{{ static FRAME: {kind} = {mask}::new({tile}); &FRAME }}")))
        }
        Kind::Retargeting => format!("{:?}, {}, {}", retarget::STEP, retarget::ROUNDS, tiles.collect::<String>()),
        _ => tiles.collect(),
    };
    let several_are = if frames == 1 { "" } else { " and a pointer a frame" };
    format!(
        "/// {what}, {size}×{size} pixels{several}, {} bytes{several_are}, baked at {} effort.\n\
         pub static {}: {} = {made}::new({numbers});\n",
        recipe.bytes(),
        effort.name(),
        recipe.name().to_uppercase(),
        made.replace("::<", "<"),
    )
}

/// The array of a tile, a row a line.
fn rows(recipe: Recipe, tile: &[u16]) -> String {
    let row = |row: &[u16]| {
        let mut text = String::from("\n[");
        for pixel in row.chunks(recipe.channels()) {
            match pixel {
                [rank] => write!(text, "{rank},"),
                _ => write!(text, "{pixel:?},"),
            }
            .expect("a String grows");
        }
        text + "]"
    };
    list(tile.chunks(recipe.size() * recipe.channels()).map(row))
}

fn list(items: impl Iterator<Item = String>) -> String {
    let mut text = String::from("[");
    for item in items {
        text += &item;
        text.push(',');
    }
    text + "]"
}

/// The `static` of the first `count` dimensions, with its docs.
pub fn directions(count: usize, all: &[[u32; 32]]) -> String {
    let mut text = format!(
        "/// Direction numbers of the first {count} dimensions (Joe and Kuo 2008), {} bytes.\n\
         pub static {}: Directions<{count}> = Directions::new([\n",
        directions::bytes(count),
        directions::name(count).to_uppercase(),
    );
    for numbers in &all[..count] {
        writeln!(text, "{numbers:?},").expect("a String grows");
    }
    text.push_str("]);\n");
    text
}
