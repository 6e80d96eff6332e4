//! What shaders cost on the compiler of a real GPU, without a GPU: no timing, so the same on every machine.
//!
//! ```text
//! cargo run -p gpu --bin cost                    # every sampler and what it is compared with, as Markdown
//! cargo run -p gpu --bin cost -- FILE.wgsl …     # every compute entry point of files
//! ```
//!
//! A file may call the crate's functions and read its tables without declaring them, and replace any of them.
//! The compiler's estimates weigh conditional code less: compare shaders of one form, as the table's all are.

mod link;
#[expect(unsafe_code, reason = "Vulkan is a C interface")]
mod radv;
mod rows;
mod shader;
#[path = "../../../../examples/export/translate.rs"]
#[expect(dead_code, reason = "the checks of shaders use the rest")]
mod translate;

use std::process::ExitCode;

use radv::Radv;

fn main() -> ExitCode {
    let files: Vec<String> = std::env::args().skip(1).collect();
    match run(&files) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

fn run(files: &[String]) -> Result<(), String> {
    let radv = Radv::new()?;
    let library = link::library();
    println!("{}\n", radv.name);
    if files.is_empty() {
        return rows::print(&radv, &library);
    }
    let mut lines = String::new();
    for file in files {
        let text = std::fs::read_to_string(file).map_err(|error| format!("{file} cannot be read ({error})"))?;
        let text = link::linked(&text, &library).map_err(|error| format!("{file}: {error}"))?;
        let found = shader::costs(&radv, &text)?;
        if found.is_empty() {
            return Err(format!("{file} has no entry point: it needs a function with @compute"));
        }
        lines.extend(found.iter().map(|(name, cost)| format!("| {name} |{cost}\n")));
    }
    print!("{}\n{lines}", shader::head("entry point"));
    Ok(())
}
