//! The text that the library includes: typed arrays, right in alignment and byte order on every target, whose wrong
//! length would not compile.

use core::fmt::Write as _;

use super::directions;
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

/// One `static` of the table's type, with its docs.
pub fn table(recipe: Recipe, effort: Effort, ranks: &[u16]) -> String {
    match recipe.kind {
        Kind::Retargeting => return retargeting(recipe, ranks),
        Kind::OverTime => return over_time(recipe, effort, ranks),
        _ => {}
    }
    let size = recipe.size();
    let (what, mask) = match recipe.kind {
        Kind::Threshold => ("Threshold mask (void-and-cluster)", format!("ScalarMask<{size}>")),
        Kind::Offset1d => ("Offset mask of one channel", format!("ScalarMask<{size}>")),
        Kind::Lattice => ("Shifts of a rank-1 lattice", format!("VectorMask<2, {size}>")),
        Kind::OverTime | Kind::Retargeting => unreachable!("have texts of their own"),
        Kind::Offset2d => ("Offset mask of two channels", format!("VectorMask<2, {size}>")),
        Kind::Keys => ("Scrambling keys for any number of samples", format!("Keys<{size}>")),
        Kind::Keys4 => ("Scrambling keys for 4 samples, and the first 1 and 2 of them", format!("Keys<{size}>")),
        Kind::Keys16 => ("Scrambling keys for 16 samples, and the first 1 to 8 of them", format!("Keys<{size}>")),
    };
    let mut text = format!(
        "/// {what}, {size}×{size} pixels, {} bytes, baked at {} effort.\n\
         pub static {}: {mask} = {}::new([\n",
        recipe.bytes(),
        effort.name(),
        recipe.name().to_uppercase(),
        mask.replace('<', "::<"),
    );
    for row in ranks.chunks(size * recipe.channels()) {
        text.push('[');
        for pixel in row.chunks(recipe.channels()) {
            match pixel {
                [rank] => write!(text, "{rank},"),
                _ => write!(text, "{pixel:?},"),
            }
            .expect("a String grows");
        }
        text.push_str("],\n");
    }
    text.push_str("]);\n");
    text
}

/// One `static` of masks for several frames.
fn over_time(recipe: Recipe, effort: Effort, ranks: &[u16]) -> String {
    let (size, frames) = (recipe.size(), recipe.frames());
    let mut text = format!(
        "/// Threshold masks over time (void-and-cluster), {size}×{size} pixels, {frames} frames, {} bytes, baked at {} \
         effort.\n\
         pub static {}: crate::frames::masks::TimeMask<{size}, {frames}> = crate::frames::masks::TimeMask::new([\n",
        recipe.bytes(),
        effort.name(),
        recipe.name().to_uppercase(),
    );
    for frame in ranks.chunks(size * size) {
        text.push_str("ScalarMask::new([\n");
        for row in frame.chunks(size) {
            writeln!(text, "{row:?},").expect("a String grows");
        }
        text.push_str("]),\n");
    }
    text.push_str("]);\n");
    text
}

/// The `static` of the swaps between seeds, with its docs.
fn retargeting(recipe: Recipe, codes: &[u16]) -> String {
    let mut text = format!(
        "/// Swaps of seeds between two frames, for [`THRESHOLD_64`], {} bytes.\n\
         pub static {}: crate::frames::seeds::Retargeting = crate::frames::seeds::Retargeting::new({:?}, [\n",
        recipe.bytes(),
        recipe.name().to_uppercase(),
        retarget::STEP,
    );
    for row in codes.chunks(recipe.size()) {
        writeln!(text, "{row:?},").expect("a String grows");
    }
    text.push_str("]);\n");
    text
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
