//! The linear pixel order's constants: what is frozen is what the search finds, and what the theory says is what pixels
//! do.

#![allow(missing_docs, clippy::cast_possible_truncation, clippy::std_instead_of_core, reason = "a test on the host")]
#![allow(unreachable_pub, dead_code, reason = "shares the bake with build.rs")]

use std::path::PathBuf;

use bluedither::{effort, hash, linear, sobol, strata};

#[path = "../src/bake/mod.rs"]
mod bake;

use bake::linear_order::LinearOrder;

fn tables() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tables")
}

#[test]
#[ignore = "writes tables/linear_order.txt after minutes of search"]
fn write_linear_order() {
    let start = std::time::Instant::now();
    let found = bake::columns::find(&|line| eprintln!("{:4.0} s  {line}", start.elapsed().as_secs_f64()));
    std::fs::write(tables().join("linear_order.txt"), found.text()).expect("tables/ can be written");
}

#[test]
#[ignore = "searches for minutes"]
fn frozen_constants_are_what_the_search_finds() {
    let found = bake::columns::find(&|line| eprintln!("{line}"));
    assert_eq!(found, LinearOrder::read(&tables()).expect("frozen constants"));
}
