//! The shaders' texts as such, and the words of their tables. What the functions return is compared by `tests/gpu`.

use std::collections::BTreeSet;

use bluedither::shader::{self, Parts, Table};
use bluedither::tables::{NET, OFFSET_2D_64, SEQUENCE, THRESHOLD_64};
use bluedither::{ScalarMask, VectorMask, torus};

const PARTS: [(&str, Parts); 29] = [
    ("unit", shader::UNIT),
    ("wide", shader::WIDE),
    ("hash", shader::HASH),
    ("torus", shader::TORUS),
    ("sobol", shader::SOBOL),
    ("directions", shader::DIRECTIONS),
    ("lattice", shader::LATTICE),
    ("sequence", shader::KEYED_SEQUENCE),
    ("zorder", shader::ZORDER),
    ("net", shader::JOINT_NET),
    ("strata", shader::STRATA),
    ("shift", shader::SHIFT),
    ("mask/mod", shader::MASK),
    ("mask/scalar", shader::SCALAR),
    ("mask/vector", shader::VECTOR),
    ("keys", shader::KEYS),
    ("sampler/mod", shader::DOMAIN),
    ("sampler/net", shader::SAMPLER),
    ("sampler/keyed", shader::KEYED),
    ("sampler/dithered", shader::DITHERED),
    ("sampler/white", shader::WHITE),
    ("dither/quantise", shader::QUANTISE),
    ("dither/ordered", shader::ORDERED),
    ("dither/gamma", shader::GAMMA),
    ("dither/alpha", shader::ALPHA),
    ("dither/mod", shader::DITHER),
    ("frames/masks", shader::OVER_TIME),
    ("frames/seeds", shader::SEEDS),
    ("frames/seeds_pass", shader::SEEDS_PASS),
];

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

/// Text without comments.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or_default().to_string() + "\n").collect()
}

/// All names in it.
fn names(text: &str) -> BTreeSet<String> {
    let pieces = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    pieces.filter(|name| !name.is_empty()).map(String::from).collect()
}

/// Names that it declares at module scope.
fn declared(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in text.lines() {
        let line = line.split("//").next().unwrap_or_default();
        for keyword in ["fn ", "struct ", "const "] {
            if let Some(rest) = line.strip_prefix(keyword) {
                found.extend(names(rest.split(['(', ' ', ':']).next().unwrap_or_default()));
            }
        }
        if let Some((_, rest)) = line.split_once("var<").filter(|_| !line.starts_with(' ')) {
            let name = rest.split_once('>').map_or("", |(_, rest)| rest.trim().split(':').next().unwrap_or_default());
            found.extend(names(name));
        }
    }
    found
}

/// What a table's text declares, and its sizes.
fn given_by_tables() -> BTreeSet<String> {
    let texts = TABLES.iter().flat_map(|table| [table.storage, table.size_text(64)]);
    texts.flat_map(declared).chain(["BD_OVER_TIME_FRAMES".to_string()]).collect()
}

#[test]
fn every_part_holds_all_that_it_needs() {
    let given = given_by_tables();
    for (name, parts) in PARTS {
        let text: String = parts.texts().map(code).collect();
        let declared: BTreeSet<String> = declared(&text).into_iter().collect();
        let missing: Vec<String> = names(&text)
            .into_iter()
            .filter(|used| used.starts_with("bd_") || used.starts_with("BD_"))
            .filter(|used| !declared.contains(used) && !given.contains(used))
            .collect();
        assert!(missing.is_empty(), "{name} lacks {missing:?}");
    }
}

#[test]
fn parts_are_named_after_their_files_and_come_last() {
    for (name, parts) in PARTS {
        assert_eq!(parts.names().last(), Some(name));
    }
    assert_eq!(shader::ALL.names().collect::<Vec<_>>(), PARTS.map(|(name, _)| name));
}

#[test]
fn what_is_pasted_clashes_with_nothing() {
    let tables: String = TABLES.iter().map(|table| table.storage).collect();
    let text: String = shader::ALL.texts().map(code).chain([tables]).collect();
    let all = declared(&text);
    let different: BTreeSet<&String> = all.iter().collect();
    assert_eq!(all.len(), different.len(), "a name is declared twice");
    for name in all {
        assert!(name.starts_with("bd_") || name.starts_with("BD_"), "{name} may be a user's own");
    }
}

#[test]
fn tables_have_bindings_of_their_own() {
    let numbers: BTreeSet<u32> = TABLES.iter().map(|table| table.binding).collect();
    assert_eq!(numbers.len(), TABLES.len());
    for table in TABLES {
        for text in [table.storage, table.texture] {
            assert!(text.contains(&format!("@group(0) @binding({})", table.binding)), "{text}");
        }
    }
}

#[test]
fn sizes_are_written_as_the_text_reads_them() {
    for (side, log2) in [(0, 0), (1, 0), (2, 1), (64, 6), (100, 6), (256, 8), (usize::MAX, 8)] {
        assert_eq!(shader::SCALAR_MASK.size_text(side), format!("const BD_SCALAR_LOG2 = {log2}u;\n"));
    }
    assert_eq!(shader::DIRECTION_NUMBERS.size_text(1024), "const BD_DIRECTIONS_COUNT = 1024u;\n");
    assert_eq!(shader::NET.size_text(64), "");
}

#[test]
fn parts_are_pasted_once() {
    let both = shader::SAMPLER.and(shader::DITHER).and(shader::SAMPLER);
    let names: Vec<&str> = both.names().collect();
    assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
    let either: BTreeSet<&str> = shader::SAMPLER.names().chain(shader::DITHER.names()).collect();
    assert_eq!(names.into_iter().collect::<BTreeSet<_>>(), either);
}

#[test]
fn words_are_little_endian_bytes() {
    let bytes = |words: Vec<u32>| words.into_iter().flat_map(u32::to_le_bytes).collect::<Vec<_>>();
    let scalar = THRESHOLD_64.ranks().as_flattened().iter().flat_map(|rank| rank.to_le_bytes());
    assert_eq!(bytes(shader::scalar_words(&THRESHOLD_64).collect()), scalar.collect::<Vec<_>>());
    let vector = OFFSET_2D_64.ranks().as_flattened().as_flattened().iter().flat_map(|rank| rank.to_le_bytes());
    assert_eq!(bytes(shader::vector_words(&OFFSET_2D_64).collect()), vector.collect::<Vec<_>>());
    // Padded to whole words.
    assert_eq!(shader::scalar_words(&ScalarMask::new([[0]])).collect::<Vec<_>>(), [0]);
    assert_eq!(shader::vector_words(&VectorMask::new([[[7, 9]]])).collect::<Vec<_>>(), [9 << 16 | 7]);
}

#[test]
fn the_sequence_is_laid_out_as_its_shader_reads_it() {
    let words: Vec<u32> = shader::sequence_words().collect();
    assert_eq!(words.len(), 112);
    let long = |i: usize| u64::from(words[i + 1]) << 32 | u64::from(words[i]);
    for index_rev in [0, 1, 0x1234_5678, u32::MAX, 0xf000_0000, 0x0080_0000] {
        let nibbles = [index_rev >> 28, 16 + (index_rev >> 24 & 15)].map(|k| long(2 * k as usize));
        let singles = (0..24).filter(|k| index_rev >> (23 - k) & 1 == 1).map(|k| long(64 + 2 * k));
        let sum = nibbles.into_iter().chain(singles).fold(0, |sum, word| sum ^ word);
        assert_eq!(sum, SEQUENCE.packed_rev(index_rev));
    }
}

#[test]
fn the_net_is_laid_out_as_its_shader_reads_it() {
    let words: Vec<u32> = shader::net_words().collect();
    assert_eq!(words.len(), 996);
    for (k, order) in NET.known.iter().chain([&NET.progressive]).enumerate() {
        let order_words = &words[104 * k..104 * (k + 1)];
        assert_eq!(&order_words[..64], order.samples.as_flattened());
        assert_eq!(&order_words[64..80], order.inside.as_flattened());
        assert_eq!(&order_words[80..], order.place.as_flattened());
    }
    assert_eq!(&words[936..], NET.frames.as_flattened());
}

fn files(folder: &str, ending: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of the crate") {
            let path = entry.expect("an entry of a folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == ending) {
                let text = std::fs::read_to_string(&path).expect("a text of the crate");
                found.push((path.to_string_lossy().into_owned(), text));
            }
        }
    }
    found
}

/// Constants that stand in both: numbers without a pattern are somewhere in Rust, by themselves or as half of a word,
/// so that one that is changed there alone is noticed without a device.
#[test]
fn constants_are_those_of_rust() {
    let rust: String = files("src", "rs").into_iter().map(|(_, text)| text.replace('_', "")).collect();
    let mut count = 0;
    for (path, text) in files("src/wgsl", "wgsl") {
        let code = code(&text);
        for literal in code.split(|c: char| !c.is_ascii_alphanumeric()).filter_map(|word| word.strip_prefix("0x")) {
            let digits = literal.trim_end_matches('u');
            let Ok(value) = u32::from_str_radix(digits, 16) else { continue }; // a float
            // Runs of ones are masks and shifts.
            let turned = value >> value.trailing_zeros().min(31);
            if digits.len() > 4 && turned & turned.wrapping_add(1) != 0 && value != 0x5555_5555 {
                assert!(rust.contains(digits), "{path}: {literal} is not in Rust");
                count += 1;
            }
        }
    }
    assert!(count > 40, "{count}");
}

/// The steps of the torus, each by its name: a search for numbers would not see two of them exchanged.
#[test]
fn steps_of_the_torus_are_those_of_rust() {
    let text: String = shader::TORUS.texts().collect();
    let start = torus::offset(0, 0, 0, 0, 32);
    for (name, [domain, pad, frame]) in [("domain", [1, 0, 0]), ("pad", [0, 1, 0]), ("frame", [0, 0, 1])] {
        let place = torus::offset(0, domain, pad, frame, 32);
        let [x, y] = [0, 1].map(|k: usize| place[k].wrapping_sub(start[k]));
        assert!(text.contains(&format!("{name} * vec2<u32>({x:#010x}u, {y:#010x}u)")), "{name}: {x:#x} {y:#x}");
    }
}

/// What no shader needs, or has by another name. Everything else that is public has a function of its name.
const LEFT_OUT: &[(&str, &str)] = &[
    ("fill", "rows and lists"),
    ("fill_fx", "rows and lists"),
    ("over_row", "rows and lists"),
    ("pattern", "rows and lists"),
    ("draw_fx", "draw1_fx to draw8_fx"),
    ("r_64", "r1_64 to r4_64"),
    ("with_masks", "the tables that are bound"),
    ("with_keys", "the tables that are bound"),
    ("from_slice", "the tables that are bound"),
    ("ranks", "the tables that are bound"),
    ("bytes", "the tables that are bound"),
    ("codes", "the tables that are bound"),
    ("frames", "the tables that are bound"),
    ("known", "inside with_spp"),
    ("directions", "the tables that are bound"),
    ("rounds", "a constant of the pass"),
    ("gamma", "bd_gamma_level"),
    ("retarget", "the pass"),
];

/// A name that is new in Rust, of whatever type, is new in WGSL, or stands above.
#[test]
fn public_names_occur_in_wgsl() {
    let all: String = shader::ALL.texts().map(code).collect();
    let declared: Vec<String> = all.lines().filter_map(|line| line.strip_prefix("fn bd_")).map(String::from).collect();
    let has = |name: &str| {
        // bd_…_name, or with the number of components behind it.
        declared.iter().any(|line| {
            let line = line.split('(').next().unwrap_or_default();
            line.trim_end_matches(|c: char| c.is_ascii_digit())
                .ends_with(&format!("_{}", name.trim_end_matches(|c: char| c.is_ascii_digit())))
        })
    };
    // The bake, what bits depend on the device, rows, pictures, and what only tells of tables.
    let skipped = [
        "/bake/",
        "/shader/",
        "/warp.rs",
        "/candidate.rs",
        "/pattern.rs",
        "/effort.rs",
        "/tables.rs",
        "/rows.rs",
        "/samples.rs",
        "/target.rs",
        "/kernel.rs",
        "/bits.rs",
        "/row.rs",
    ];
    let (mut missing, mut found) = (Vec::new(), BTreeSet::new());
    for (path, text) in files("src", "rs") {
        let path = path.trim_start_matches(env!("CARGO_MANIFEST_DIR")).replace('\\', "/");
        if skipped.iter().any(|part| path.contains(part)) {
            continue;
        }
        for line in text.lines().map(str::trim_start) {
            let rest = line.strip_prefix("pub const fn ").or_else(|| line.strip_prefix("pub fn "));
            let Some(name) = rest.and_then(|rest| rest.split(['(', '<']).next()) else { continue };
            found.insert(name.to_string());
            if !has(name) && !LEFT_OUT.iter().any(|(left_out, _)| *left_out == name) {
                missing.push(format!("{name} of {path}"));
            }
        }
    }
    assert!(missing.is_empty(), "neither in src/wgsl nor in LEFT_OUT: {missing:#?}");
    let idle: Vec<_> = LEFT_OUT.iter().filter(|(name, _)| !found.contains(*name) || has(name)).collect();
    assert!(idle.is_empty(), "LEFT_OUT for nothing: {idle:?}");
}
