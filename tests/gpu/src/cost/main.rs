//! What shaders cost on the compiler of a real GPU, without a GPU.
//!
//! ```text
//! cargo run -p gpu --bin cost                    # every sampler and what it is compared with, as Markdown
//! cargo run -p gpu --bin cost -- FILE.wgsl …     # every compute entry point of files
//! ```

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
use shader::Cost;

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
    println!("{}\n\n| | numbers |{}", radv.name, Cost::HEAD);
    if files.is_empty() {
        let mut text = String::new();
        let mut names = Vec::new();
        for (k, row) in rows::ROWS.iter().enumerate() {
            for count in [2, 4] {
                let name = format!("row_{k}_{count}_");
                if library.iter().any(|(n, _)| n == &row.draw(count)) {
                    text += &row.entry(&name, count);
                    names.push((row.title, count));
                }
            }
        }
        let text = link::linked(&text, &library)?;
        for ((title, count), (_, cost)) in names.iter().zip(shader::costs(&radv, &text)?) {
            println!("| {title} | {count} |{cost}");
        }
    }
    for file in files {
        let text = std::fs::read_to_string(file).map_err(|error| format!("{file} cannot be read ({error})"))?;
        let text = link::linked(&text, &library)?;
        for (name, cost) in shader::costs(&radv, &text)? {
            println!("| {name} | |{cost}");
        }
    }
    Ok(())
}
