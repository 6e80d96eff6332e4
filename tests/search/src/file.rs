//! The file of columns, `tables/net.txt`: what stands above them stays as it is.

use std::path::Path;

use bluedither::net::Digits;

use crate::frames;
use crate::map::Map;

/// Columns of all orders, then of frames, which go with the last one; and the seal.
pub fn write(maps: &[Map]) -> std::io::Result<()> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tables/net.txt");
    let mut columns: Vec<Digits> = Vec::new();
    for order in maps.iter().map(Map::order) {
        columns.extend(order.samples.iter().chain(&order.inside).chain(&order.place));
    }
    columns.extend(maps.last().into_iter().flat_map(frames::columns));
    let old = std::fs::read_to_string(&path)?;
    let mut text: String = old.lines().filter(|line| line.starts_with('#')).map(|line| format!("{line}\n")).collect();
    for [a, b, c, d] in &columns {
        text += &format!("{a:08x} {b:08x} {c:08x} {d:08x}\n");
    }
    text += &format!("seal {:016x}\n", seal(columns.as_flattened()));
    std::fs::write(path, text)
}

/// FNV-1a (Fowler, Noll and Vo) of the words as eight little-endian bytes each, as `src/bake/digest.rs` has it.
fn seal(words: &[u32]) -> u64 {
    let bytes = words.iter().flat_map(|&word| u64::from(word).to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}
