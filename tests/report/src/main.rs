//! Measures every sampler of the crate and its peers on the same integrands, in the same process.
//!
//! ```text
//! cargo run --release -p report
//! ```
//!
//! The definitions are those of `tests/analysis`; samplers are listed in `samplers.rs`, one line each.
#![allow(clippy::print_stdout, reason = "a program that prints tables")]

#[path = "../../analysis/mod.rs"]
mod analysis;
mod arguments;
#[cfg(test)]
mod checks;
mod error_part;
mod family;
mod field;
mod figures;
mod filter;
mod measure;
mod peers;
mod power;
#[path = "../../../examples/render/progress.rs"]
mod progress;
mod samplers;
mod shape;
mod table;

use arguments::{Arguments, Part};
use clap::Parser;
use std::process::ExitCode;
use table::Table;

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let names = arguments.samplers();
    let bench = measure::Bench::new();
    let mut tables: Vec<Table> = Vec::new();
    if arguments.has(Part::Error) {
        let counts: Vec<(u32, u32)> = error_part::COUNTS.map(|count| (count, count)).to_vec();
        tables.extend(error_part::measure(&bench, &names, &counts, arguments.seed, arguments.seeds()).tables());
    }
    for table in &tables {
        println!("{}", table.markdown());
    }
    Ok(())
}
