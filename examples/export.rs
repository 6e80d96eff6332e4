//! Writes tables and functions for shaders, other engines, languages and tools; with every table there is.
//!
//! ```text
//! cargo run --example export -- --out DIR
//! ```
//!
//! Hands over to the package in `examples/export`, which stands apart because it needs what tests should not wait for.
#![allow(clippy::std_instead_of_core, reason = "for desktops")]

use std::path::Path;
use std::process::{Command, ExitCode};

fn main() -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/export/Cargo.toml");
    let run = ["run", "--features", "all", "--manifest-path"];
    match Command::new(cargo).args(run).arg(manifest).arg("--").args(std::env::args_os().skip(1)).status() {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE, // which has said why
        Err(error) => {
            eprintln!("error: cargo does not run ({error}): install it, or set CARGO to its path");
            ExitCode::FAILURE
        }
    }
}
