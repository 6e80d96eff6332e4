//! The crate's functions and tables, added to a shader that uses them: naga tells what it misses, one name at a time.

use bluedither::shader::{self, Table};

use crate::translate::parse;

const TABLES: [Table; 9] = [
    shader::NET,
    shader::SEQUENCE,
    shader::SCALAR_MASK,
    shader::VECTOR_MASK,
    shader::KEYS_TILE,
    shader::DIRECTION_NUMBERS,
    shader::TIME_MASK,
    shader::LINEAR_LIGHT,
    shader::SEED_SWAPS,
];
/// Pixels a side of masks, and dimensions of direction numbers.
const SIZE: usize = 64;
/// What exported passes read and fill: `bd_fill` and `bd_filled`.
const FILL: &str = include_str!("../../../../examples/export/fill.wgsl");
/// What samplers are compared with.
const PEERS: &str = include_str!("peers.wgsl");

/// A name and its text.
pub type Declaration = (String, String);

/// All that can be added: functions, structures, constants and bindings.
pub fn library() -> Vec<Declaration> {
    let texts = shader::ALL.texts().map(String::from);
    let tables = TABLES.iter().map(|table| format!("{}{}", table.size_text(SIZE), table.storage));
    texts.chain(tables).chain([FILL, PEERS].map(String::from)).flat_map(|text| declarations(&text)).collect()
}

/// `wgsl` with what it misses. What it declares itself is not added: so it may replace any function.
pub fn linked(wgsl: &str, library: &[Declaration]) -> Result<String, String> {
    let mut text = wgsl.to_string();
    loop {
        let Err(error) = parse(&text) else { return Ok(text) };
        let missing =
            error.split_once("no definition in scope for identifier: `").and_then(|(_, rest)| rest.split_once('`'));
        let found = library.iter().find(|(name, _)| missing.is_some_and(|(missing, _)| missing == name));
        text += &found.ok_or(error)?.1;
    }
}

/// Those of a text that is formatted as ours are.
fn declarations(text: &str) -> Vec<Declaration> {
    let mut found = Vec::new();
    let mut whole = String::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with("//")) {
        whole += line;
        whole.push('\n');
        if line == "}" || (line.ends_with(';') && !line.starts_with(' ')) {
            let whole = std::mem::take(&mut whole);
            found.extend(name(&whole).map(|name| (name, whole)));
        }
    }
    found
}

/// None of an entry point, which is not for others.
fn name(declaration: &str) -> Option<String> {
    let keywords = ["fn ", "struct ", "const ", "> "];
    let (_, rest) = keywords.iter().find_map(|keyword| declaration.split_once(keyword))?;
    let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_')?;
    (!declaration.contains("@compute")).then(|| rest[..end].to_string())
}
