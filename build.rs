//! Bakes the tables that the enabled features ask for, side by side, and writes them where `src/tables.rs` includes
//! them. No mathematics here: see `src/bake`.

// Dependents compile this unoptimised, whatever their profile says; the hot loops are written for that.
#![allow(
    clippy::cast_possible_truncation,
    clippy::std_instead_of_core,
    unreachable_pub,
    reason = "runs on the host, and shares modules with the library"
)]

#[path = "src/bake/mod.rs"]
#[allow(dead_code, reason = "tests use the rest")]
mod bake;
#[path = "src/effort.rs"]
mod effort;
#[path = "src/hash.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod hash;
#[path = "src/lattice.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod lattice;
#[path = "src/net.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod net;
#[path = "src/sequence.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod sequence;
#[path = "src/sobol.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod sobol;
#[path = "src/strata.rs"]
#[allow(dead_code, reason = "the library uses the rest")]
mod strata;

use std::path::Path;
use std::time::Instant;

use bake::filter::{self, Filter};
use bake::inputs::Inputs;
use bake::net::Net;
use bake::recipe::Recipe;
use bake::record::Digests;
use bake::sequence::Columns;
use effort::Effort;

fn main() {
    println!("cargo::rerun-if-changed=tables");
    println!("cargo::rerun-if-env-changed=BLUEDITHER_EFFORT");
    println!("cargo::rerun-if-env-changed=BLUEDITHER_FILTER");
    if let Err(line) = run() {
        println!("cargo::error={line}");
    }
}

fn run() -> Result<(), String> {
    let (effort, filter) = (chosen_effort()?, chosen_filter()?);
    let recipes: Vec<Recipe> = bake::recipe::all().into_iter().filter(|recipe| asked_for(&recipe.name())).collect();
    let counts: Vec<usize> =
        bake::directions::COUNTS.into_iter().filter(|&count| asked_for(&bake::directions::name(count))).collect();
    let tables = Path::new(&var("CARGO_MANIFEST_DIR")).join("tables");
    let mut text = bake::embed::effort(effort) + &Net::read(&tables)?.embed();
    if recipes.is_empty() {
        // Nothing else is read: that is how damaged inputs can be recorded anew.
        text += &Columns::read(&tables)?.embed();
    } else {
        let digests = Digests::read(&tables)?;
        let inputs = Inputs { filter, ..Inputs::read(&tables, &digests)? };
        text += &inputs.sequence.embed();
        text += &bake_all(&recipes, effort, &inputs, &digests);
    }
    if recipes.iter().any(|recipe| recipe.is_filtered()) {
        text += &bake::embed::filter(filter);
    } else if std::env::var_os("BLUEDITHER_FILTER").is_some() {
        println!("cargo::warning=BLUEDITHER_FILTER changes nothing: add feature threshold-filtered-64");
    }
    if !counts.is_empty() {
        text += &directions(&counts, &tables)?;
    }
    let path = Path::new(&var("OUT_DIR")).join("tables.rs");
    std::fs::write(&path, text).map_err(|error| format!("{} cannot be written ({error})", path.display()))
}

fn bake_all(recipes: &[Recipe], effort: Effort, inputs: &Inputs, digests: &Digests) -> String {
    use_as_many_threads_as_cargo();
    let start = Instant::now();
    let mut texts = vec![String::new(); recipes.len()];
    let write = |recipe, ranks: &[u16], start| finish(recipe, effort, inputs, digests, ranks, start);
    let mut jobs: Vec<_> = texts.iter_mut().zip(recipes).filter(|(_, recipe)| recipe.base().is_none()).collect();
    // Large ones first, lest one be left for a single thread at the end.
    jobs.sort_by_key(|(_, recipe)| core::cmp::Reverse(recipe.bytes()));
    rayon::scope_fifo(|scope| {
        for (text, &recipe) in jobs {
            scope.spawn_fifo(move |_| {
                let start = Instant::now();
                let ranks = recipe.bake(effort, inputs);
                *text = write(recipe, &ranks, start);
                for derived in recipes.iter().filter(|derived| derived.base() == Some(recipe)) {
                    *text += &write(*derived, &derived.derive(&ranks), start);
                }
            });
        }
    });
    println!("baked {} tables at {} effort in {} ms", recipes.len(), effort.name(), start.elapsed().as_millis());
    texts.concat()
}

/// The text of a table; what it cost and how good it is goes to the log (`cargo build -vv`).
fn finish(recipe: Recipe, effort: Effort, inputs: &Inputs, digests: &Digests, ranks: &[u16], start: Instant) -> String {
    let time = start.elapsed().as_millis();
    let name = recipe.name();
    let gain = recipe.still(ranks).map(|still| bake::quality::gain(still, recipe.channels(), recipe.size()));
    let gain = gain.map_or_else(String::new, |gain| format!(", gain {gain:.3} at sigma 1 (white is 1)"));
    println!("baked {name}: {} bytes{gain}, {time} ms beside others", recipe.bytes());
    let recorded = digests.get(effort.name(), &name);
    if recipe.is_recorded(inputs) && recorded != Some(bake::digest::of_ranks(ranks)) {
        println!("cargo::warning={name} differs from its recorded digest: renders will not match other builds' bits");
    }
    bake::embed::table(recipe, effort, ranks)
}

fn chosen_effort() -> Result<Effort, String> {
    let Some(word) = std::env::var_os("BLUEDITHER_EFFORT") else { return Ok(Effort::Normal) };
    let found = Effort::ALL.into_iter().find(|effort| word == effort.name());
    found.ok_or_else(|| format!("BLUEDITHER_EFFORT is {word:?}: set it to quick, normal or thorough, or unset it"))
}

fn chosen_filter() -> Result<Filter, String> {
    let Some(text) = std::env::var_os("BLUEDITHER_FILTER") else { return Ok(Filter::default()) };
    let found = text.to_str().and_then(Filter::parse);
    found.ok_or_else(|| format!("BLUEDITHER_FILTER is {text:?}: {}", filter::CURE))
}

fn directions(counts: &[usize], tables: &Path) -> Result<String, String> {
    let all = bake::directions::read(tables, &Digests::read(tables)?)?;
    Ok(counts.iter().map(|&count| bake::embed::directions(count, &all)).collect())
}

/// Whether the feature of a table is on.
fn asked_for(table: &str) -> bool {
    std::env::var_os(format!("CARGO_FEATURE_{}", table.to_uppercase())).is_some()
}

fn use_as_many_threads_as_cargo() {
    let jobs = var("NUM_JOBS").parse().unwrap_or(1);
    // Fails only where a pool exists already, which then serves as well.
    let _ = rayon::ThreadPoolBuilder::new().num_threads(jobs).build_global();
}

fn var(name: &str) -> String {
    std::env::var(name).unwrap_or_else(|_| panic!("cargo sets {name} for build scripts"))
}
