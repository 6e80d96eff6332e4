//! Runs every function of the shaders a million times on a Vulkan device, and compares it with Rust bit for bit.
//!
//! ```text
//! cargo test -p gpu              # all
//! cargo test -p gpu -- sampler   # those whose expression contains a word
//! ```

mod arguments;
mod bind;
mod case;
mod cases;
mod device;

use std::process::ExitCode;

fn main() -> ExitCode {
    let word = std::env::args().nth(1).unwrap_or_default();
    match check(&word) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

fn check(word: &str) -> Result<(), String> {
    let device = device::Device::new()?;
    let cases: Vec<_> = cases::all().into_iter().filter(|case| case.expression.contains(word)).collect();
    if cases.is_empty() {
        return Err(format!("no function is named like '{word}'"));
    }
    let mut differ = 0;
    for case in &cases {
        if let Err(line) = case.check(&device) {
            println!("{line}");
            differ += 1;
        }
    }
    if differ > 0 {
        return Err(format!("{differ} of {} functions differ", cases.len()));
    }
    println!("{} functions, {} calls each: the same bits on {}", cases.len(), arguments::CALLS, device.name);
    Ok(())
}
