//! What samplers cost in a shader, as the compiler of a GPU tells without one: by `tests/gpu`, which has the heavy
//! dependencies.

use crate::progress::Progress;
use crate::table::Table;
use std::path::Path;
use std::process::Command;

/// The table, or why there is none, in a line.
pub fn table() -> Result<Table, String> {
    let say = |what: &dyn core::fmt::Display| format!("Costs of shaders are not told: {what}.");
    let progress = Progress::new("shaders", 1);
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let output = Command::new(program)
        .args(["run", "--quiet", "-p", "gpu", "--bin", "cost"])
        .current_dir(root)
        .output()
        .map_err(|error| say(&format!("cargo does not run ({error})")))?;
    if !output.status.success() {
        let lines = String::from_utf8_lossy(&output.stderr);
        return Err(say(&lines.lines().last().unwrap_or("it fails")));
    }
    progress.add(1);
    let text = String::from_utf8_lossy(&output.stdout);
    let cells = |line: &str| line.split('|').map(|cell| cell.trim().replace('`', "")).collect::<Vec<_>>();
    let mut lines = text.lines().filter_map(|line| Some(cells(line.strip_prefix('|')?.strip_suffix('|')?)));
    let head = lines.next().ok_or_else(|| say(&"it prints no table"))?;
    Ok(Table {
        id: "shader-cost".into(),
        title: "Cost in a shader".into(),
        about: format!(
            "On {}: a compute shader in which every pixel draws so many numbers of a domain and stores them. Seed, \
             domain and index are the same for all pixels. Inverse throughput: cycles of the busiest unit, without \
             waiting for memory. These repeat exactly, and need no GPU.",
            text.lines().next().unwrap_or_default()
        ),
        head,
        rows: lines.skip(1).collect(),
    })
}
