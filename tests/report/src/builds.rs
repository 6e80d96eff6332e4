//! Build seconds by features: a crate that depends on this one and does nothing, unoptimised, as its user builds it.

use crate::progress::Progress;
use crate::table::Table;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

/// A name, and how the dependency is written.
const SETS: [(&str, &str); 4] = [
    ("none", "default-features = false"),
    ("the default", ""),
    ("offset-2d-128", "default-features = false, features = [\"offset-2d-128\"]"),
    ("sobol-1024", "default-features = false, features = [\"sobol-1024\"]"),
];

/// The table, or why there is none, in a line.
pub fn table(out: &Path) -> Result<Table, String> {
    let progress = Progress::new("builds", SETS.len());
    let mut rows = Vec::new();
    for (name, dependency) in SETS {
        let [whole, again] = seconds(&out.join("build"), dependency)?;
        rows.push(vec![name.to_string(), format!("{whole:.1}"), format!("{again:.1}")]);
        progress.add(1);
    }
    Ok(Table {
        id: "builds".into(),
        title: "Build seconds".into(),
        about:
            "Of a dependent at opt-level 0, with everything that is needed to bake; and again, with this crate alone \
                to be built."
                .into(),
        head: ["features", "all", "this crate"].map(String::from).to_vec(),
        rows,
    })
}

/// With all dependencies, then after this crate alone was cleaned.
fn seconds(folder: &Path, dependency: &str) -> Result<[f64; 2], String> {
    let say = |what: &dyn core::fmt::Display| format!("Builds are not measured: {what}.");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder.join("src")).map_err(|error| say(&error))?;
    let comma = if dependency.is_empty() { "" } else { ", " };
    let manifest = format!(
        "[package]\nname = \"dependent\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\nbluedither = {{ path = {:?}{comma}{dependency} }}\n",
        root.display().to_string(),
    );
    std::fs::write(folder.join("Cargo.toml"), manifest).map_err(|error| say(&error))?;
    std::fs::write(folder.join("src/lib.rs"), "#![no_std]\npub use bluedither::White;\n")
        .map_err(|error| say(&error))?;
    // The same versions, and nothing to download.
    std::fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).map_err(|error| say(&error))?;
    let cargo = |arguments: &[&str]| -> Result<f64, String> {
        let start = Instant::now();
        let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(program)
            .args(arguments)
            .args(["--quiet", "--offline"])
            .current_dir(folder)
            .env("CARGO_TARGET_DIR", "target")
            .stdout(Stdio::null())
            .status()
            .map_err(|error| say(&format!("cargo does not run ({error})")))?;
        if status.success() { Ok(start.elapsed().as_secs_f64()) } else { Err(say(&"cargo failed")) }
    };
    let whole = cargo(&["build"])?;
    cargo(&["clean", "-p", "bluedither"])?;
    let again = cargo(&["build"])?;
    std::fs::remove_dir_all(folder).map_err(|error| say(&error))?;
    Ok([whole, again])
}
