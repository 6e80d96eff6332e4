//! The bake, which build.rs runs: algorithms against naive twins, what is frozen against what it finds, and how much of
//! the error its tables leave. `cargo test sizes::` runs one module.
#![allow(missing_docs, clippy::cast_possible_truncation, clippy::std_instead_of_core, reason = "tests on the host")]
#![allow(clippy::print_stdout, reason = "tables are printed on request")]

use bluedither::{effort, lattice, net, sequence, sobol, strata, torus}; // what the bake finds at the root of build.rs

#[path = "../analysis/mod.rs"]
mod analysis;
#[path = "../../src/bake/mod.rs"]
#[allow(dead_code, unreachable_pub, reason = "build.rs uses the rest")]
mod bake;
#[path = "../../src/bake/energy/mod.rs"]
mod energy;

mod anneal;
mod filtered;
mod joint_net;
mod keys;
mod keys_quality;
mod mask_quality;
mod net_file;
mod published_energy;
mod rebake;
mod sequence_file;
mod sizes;
mod void_and_cluster;

use bake::inputs::Inputs;
use bake::recipe::{Kind, Recipe};
use bake::record::Digests;

fn tables() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tables")
}

/// What `tables/` says.
fn recorded() -> (Digests, Inputs) {
    let digests = Digests::read(&tables()).expect("digests");
    let inputs = Inputs::read(&tables(), &digests).expect("inputs");
    (digests, inputs)
}

/// A table of 64² pixels as build.rs would bake it.
fn baked(kind: Kind, effort: effort::Effort) -> Vec<u16> {
    Recipe { kind, size_log2: 6 }.bake(effort, &recorded().1)
}
