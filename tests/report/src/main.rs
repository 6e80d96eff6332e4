//! Measures every sampler of the crate and its peers on the same integrands, in the same process.
//!
//! ```text
//! cargo run --release -p report
//! ```
//!
//! The definitions are those of `tests/analysis`; samplers are listed in `samplers.rs`, one line each.
#![allow(missing_debug_implementations, reason = "a program: its parts are read where they stand")]

#[path = "../../analysis/mod.rs"]
mod analysis;
mod arguments;
mod bench;
mod builds;
mod chapters;
mod charts;
#[cfg(test)]
mod checks;
mod classic;
mod denoise;
mod dither_part;
mod edges;
mod error_part;
mod family;
mod field;
mod figures;
#[path = "../../../examples/render/film.rs"]
#[allow(dead_code, reason = "the example uses the rest")]
mod film;
mod filter;
mod frozen;
mod images;
mod instructions;
mod masks_part;
#[path = "../../../examples/render/measure.rs"]
#[allow(dead_code, reason = "the example uses the rest")]
mod measure;
mod page;
#[path = "../../../examples/render/paths.rs"]
mod paths;
mod peers;
mod plot;
mod power;
#[path = "../../../examples/render/progress.rs"]
mod progress;
mod readme;
#[path = "../../../examples/render/reference.rs"]
#[allow(dead_code, reason = "the example uses the rest")]
mod reference;
mod samplers;
#[path = "../../../examples/render/scene.rs"]
mod scene;
mod scene_part;
mod set_up;
mod several;
mod shader_cost;
mod shape;
#[path = "../../../examples/render/shapes.rs"]
#[allow(missing_debug_implementations, reason = "a program's")]
mod shapes;
mod singles;
mod speed;
mod table;
mod time_part;
mod tracer;
mod tracer_part;
#[cfg(test)]
mod unbiased;
#[path = "../../../src/bake/void_and_cluster.rs"]
mod void_and_cluster;

use arguments::Arguments;
use clap::Parser;
use page::Chapter;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

/// Measures what was asked for, prints the tables, and writes them as a page, Markdown and CSV.
fn run(arguments: &Arguments) -> Result<(), String> {
    if arguments.count_instructions {
        instructions::work(&arguments.samplers());
        return Ok(());
    }
    let start = Instant::now();
    // Before the minutes of measuring, not after.
    std::fs::create_dir_all(&arguments.out).map_err(|error| cannot_write(&arguments.out, &error))?;
    let chapters::Report { chapters, csv, errors, speeds } = chapters::measure(arguments)?;
    if let (Some(path), Some(errors), Some(speeds)) = (&arguments.readme, &errors, &speeds) {
        readme::update(path, readme::Figures { errors, speeds })?;
    }
    let about = format!(
        "Every sampler on the same integrands in one process. {} seeds from {} on, {:.0} s{}.",
        arguments.seeds(),
        arguments.seed,
        start.elapsed().as_secs_f32(),
        if arguments.quick { ", quick: fewer seeds and sample counts" } else { "" },
    );
    let markdown: String = chapters.iter().map(markdown).collect();
    print!("{markdown}");
    write(&arguments.out, "report.html", &page::page("bluedither: error, speed and size", &about, &chapters))?;
    write(&arguments.out, "report.md", &format!("# bluedither: error, speed and size\n\n{about}\n{markdown}"))?;
    for table in chapters.iter().flat_map(|chapter| &chapter.tables) {
        write(&arguments.out, &format!("{}.csv", table.id), &table.csv())?;
    }
    for (name, text) in csv {
        write(&arguments.out, name, &text)?;
    }
    println!("\nwritten to {}: report.html, report.md and tables as CSV", arguments.out.display());
    Ok(())
}

fn markdown(chapter: &Chapter) -> String {
    let tables: Vec<String> = chapter.tables.iter().map(table::Table::markdown).collect();
    format!("\n## {}\n\n{}", chapter.title, tables.join("\n"))
}

fn write(folder: &Path, name: &str, text: &str) -> Result<(), String> {
    let path = folder.join(name);
    std::fs::write(&path, text).map_err(|error| cannot_write(&path, &error))
}

fn cannot_write(path: &Path, error: &std::io::Error) -> String {
    format!("{} cannot be written ({error}): choose another folder by --out", path.display())
}
