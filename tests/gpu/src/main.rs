//! Runs every function of the shaders a million times on a Vulkan device, and compares it with Rust bit for bit.
//!
//! ```text
//! cargo test -p gpu                   # all
//! cargo test -p gpu -- sampler        # those whose expression contains a word
//! cargo run -p gpu -- --out DIR       # writes shaders that call every function, in every language
//! ```

mod arguments;
mod bind;
mod case;
mod cases;
mod device;
mod pass;
#[path = "../../../examples/export/translate.rs"]
mod translate;
mod write;

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => check(""),
        ["--out", directory] => write::write(Path::new(directory)),
        [word] if !word.starts_with('-') => check(word),
        _ => Err("the arguments are a word, or --out and a folder, or none".to_string()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

fn check(word: &str) -> Result<(), String> {
    let uncalled = uncalled();
    if !uncalled.is_empty() {
        return Err(format!("cases::all() calls no {}", uncalled.join(", ")));
    }
    let device = device::Device::new()?;
    let cases: Vec<_> = cases::all().into_iter().filter(|case| case.expression.contains(word)).collect();
    let pass = "bd_seeds_sort, bd_seeds_retarget".contains(word);
    if cases.is_empty() && !pass {
        return Err(format!("no function is named like '{word}'"));
    }
    let passes = pass.then(|| pass::check(&device));
    let differ: Vec<String> =
        cases.iter().map(|case| case.check(&device)).chain(passes).filter_map(Result::err).collect();
    for line in &differ {
        println!("{line}");
    }
    if !differ.is_empty() {
        return Err(format!("{} functions differ, as above", differ.len()));
    }
    println!("{} functions, {} calls each: the same bits on {}", cases.len(), arguments::CALLS, device.name);
    Ok(())
}

/// Functions of the shaders that neither a case nor another function calls.
fn uncalled() -> Vec<String> {
    let texts: String = bluedither::shader::ALL.texts().collect();
    let cases = cases::all();
    let callers: String = cases.iter().map(|case| case.expression).chain([texts.as_str()]).collect();
    let names = texts.lines().filter_map(|line| line.strip_prefix("fn ")?.split_once('('));
    let names =
        names.map(|(name, _)| format!("{name}(")).filter(|name| !pass::ENTRIES.contains(&&name[..name.len() - 1]));
    names.filter(|name| callers.matches(name.as_str()).count() < 2).collect()
}
