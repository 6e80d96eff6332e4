//! What a table costs: pinned here, stated in Cargo.toml, in the docs and in the README, and all agree.

use bluedither::frames::masks::TimeMask;
use bluedither::{ScalarMask, VectorMask, sobol};

/// Feature and bytes.
const BYTES: [(&str, usize); 24] = [
    ("threshold-16", 512),
    ("threshold-32", 2_048),
    ("threshold-64", 8_192),
    ("threshold-128", 32_768),
    ("threshold-256", 131_072),
    ("offset-1d-16", 512),
    ("offset-1d-32", 2_048),
    ("offset-1d-64", 8_192),
    ("offset-1d-128", 32_768),
    ("offset-2d-16", 1_024),
    ("offset-2d-32", 4_096),
    ("offset-2d-64", 16_384),
    ("offset-2d-128", 65_536),
    ("keys-64", 16_384),
    ("keys-128", 65_536),
    ("lattice-64", 16_384),
    ("threshold-over-time-32", 65_536),
    ("threshold-over-time-64", 131_072),
    ("threshold-over-time-128", 2_097_152),
    ("offset-2d-over-time-32", 65_536),
    ("offset-2d-over-time-64", 131_072),
    ("threshold-filtered-64", 8_192),
    ("threshold-filtered-over-time-64", 131_072),
    ("seed-permutation", 8_192),
];

#[test]
fn recipes_cost_what_is_pinned() {
    let recipes: Vec<_> =
        crate::bake::recipe::all().iter().map(|recipe| (recipe.name().replace('_', "-"), recipe.bytes())).collect();
    let pinned: Vec<_> = BYTES.iter().map(|&(feature, bytes)| (feature.to_string(), bytes)).collect();
    assert_eq!(recipes, pinned);
}

/// Feature and bytes of the direction numbers.
const DIRECTION_BYTES: [(&str, usize); 4] =
    [("sobol-16", 2_048), ("sobol-64", 8_192), ("sobol-256", 32_768), ("sobol-1024", 131_072)];

#[test]
fn directions_cost_what_is_pinned() {
    for ((feature, bytes), count) in DIRECTION_BYTES.into_iter().zip(crate::bake::directions::COUNTS) {
        assert_eq!(crate::bake::directions::name(count).replace('_', "-"), feature);
        assert_eq!(crate::bake::directions::bytes(count), bytes);
    }
    assert_eq!(size_of::<sobol::Directions<16>>(), 2_048);
    assert_eq!(size_of::<sobol::Directions<1024>>(), 131_072);
}

#[test]
fn the_net_links_less_than_4_kib() {
    assert_eq!(size_of::<bluedither::net::Tables>(), 3_984);
    assert!(size_of::<bluedither::Sampler>() <= 24);
    let texts = [include_str!("../../README.md"), include_str!("../../src/sampler/net.rs")];
    assert!(texts.iter().all(|text| text.contains("3,984 bytes")), "README and docs state the bytes");
}

#[test]
fn masks_hold_nothing_but_ranks() {
    assert_eq!(size_of::<ScalarMask<16>>(), 512);
    assert_eq!(size_of::<ScalarMask<256>>(), 131_072);
    assert_eq!(size_of::<VectorMask<2, 64>>(), 16_384);
    assert_eq!(size_of::<TimeMask<'_, 32, 16>>(), 16 * size_of::<usize>());
    #[cfg(feature = "threshold-64")]
    assert_eq!(size_of_val(&bluedither::tables::THRESHOLD_64), 8_192);
    #[cfg(feature = "offset-2d-64")]
    assert_eq!(size_of_val(&bluedither::tables::OFFSET_2D_64), 16_384);
}

#[test]
fn manifest_docs_and_readme_state_the_bytes() {
    // Cargo drops comments from the manifest of a package, and keeps the original beside it.
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let original = std::fs::read_to_string(root.join("Cargo.toml.orig"));
    let manifest = original.or_else(|_| std::fs::read_to_string(root.join("Cargo.toml"))).expect("a manifest");
    let docs = include_str!("../../src/lib.rs");
    let readme = include_str!("../../README.md");
    for (feature, bytes) in BYTES.into_iter().chain(DIRECTION_BYTES) {
        let bytes = with_commas(bytes);
        let in_manifest =
            |line: &str| line.starts_with(&format!("{feature} =")) && line.ends_with(&format!(" {bytes} bytes"));
        assert!(manifest.lines().any(in_manifest), "Cargo.toml should state that {feature} costs {bytes} bytes");
        let in_docs = |line: &str| line.contains(&format!("| `{feature}`")) && line.ends_with(&format!("| {bytes} |"));
        assert!(docs.lines().any(in_docs), "lib.rs should state that {feature} costs {bytes} bytes");
        let (kind, size) = feature.rsplit_once('-').expect("a name of several words");
        let in_readme = |line: &str| {
            line.replace('*', "").contains(&format!(" {size}: {bytes} ")) && line.starts_with(&format!("| `{kind}-S`"))
                || line.starts_with(&format!("| `{feature}`")) && line.contains(&format!(" {bytes} "))
        };
        assert!(readme.lines().any(in_readme), "README.md should state that {feature} costs {bytes} bytes");
    }
}

fn with_commas(bytes: usize) -> String {
    if bytes < 1000 { bytes.to_string() } else { format!("{},{:03}", with_commas(bytes / 1000), bytes % 1000) }
}
