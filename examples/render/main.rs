//! Renders a small scene with every sampler and shows where their errors lie.
//!
//! ```text
//! cargo run --release --example render
//! ```
//!
//! The comparison is that of Georgiev, "Blue-noise pixel error dithering": the same samples in every pixel, white
//! noise, published masks of low, all and high frequencies with global and stratified offsets, and the library's
//! default. It prints a table and writes contact sheets, single pictures, signed errors and spectra.
//!
//! To copy: the pixel loop in `samplers.rs`, the use of its numbers in `scene.rs`.
#![allow(missing_docs, unreachable_pub, reason = "a program: its parts are read where they stand")]
#![allow(clippy::std_instead_of_core, clippy::cast_possible_truncation, reason = "for desktops, on small numbers")]

#[allow(unused_imports, reason = "the mounted module takes from the crate root what it needs")]
use bluedither::{hash, sobol, torus};
use clap::Parser;
use reference::Reference;
use scene::Scene;
use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

mod arguments;
mod candidates;
#[path = "../../src/bake/energy/mod.rs"]
#[allow(dead_code, reason = "not this program's: tests use the rest")]
mod energy;
mod film;
#[cfg(feature = "seed-permutation")]
mod frames;
mod masks;
mod measure;
#[cfg(feature = "seed-permutation")]
mod paths;
mod progress;
mod reference;
mod results;
mod samplers;
mod scene;
mod shapes;
mod sheet;
#[cfg(all(feature = "seed-permutation", feature = "threshold-over-time-64"))]
mod ways;

fn main() -> ExitCode {
    let arguments = arguments::Arguments::parse();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Masks, reference, then every sampler at every sample count; what is found is printed and saved as it comes.
fn run(arguments: &arguments::Arguments) -> Result<(), Box<dyn Error>> {
    let (size, dimensions, names) = (arguments.size, arguments.dimensions(), arguments.samplers());
    let folders = results::Folders::create(&arguments.out)?;
    #[cfg(feature = "seed-permutation")]
    if let Some(count) = arguments.frames {
        return frames::animate(count, arguments);
    }
    let scene = Scene::new(size[0], size[1]);

    let masks = masks::Masks::anneal(&arguments.spectra(), arguments.swaps, arguments.seed);
    for masks::Pair { spectrum, energies, .. } in &masks.0 {
        println!("{spectrum:?} masks, energy per pixel: 1D {:.4}, 2D {:.4}", energies[0], energies[1]);
    }
    let reference = Reference::render(&scene, size, dimensions, arguments.reference, arguments.seed);
    let Reference { spp, error, filtered, .. } = &reference;
    println!("reference: {spp} spp, standard error {error:.5}, filtered {:.5} and {:.5}", filtered[0], filtered[1]);

    println!("{}", results::HEADING);
    let mut rows = Vec::new();
    for spp in arguments.spp() {
        let job = samplers::Job { scene: &scene, masks: &masks, dimensions, size, spp, arguments };
        let mut row = Vec::new();
        for name in &names {
            let start = Instant::now();
            let image = samplers::render(name, &job);
            row.push(results::Found::measure(name, image, start.elapsed(), &reference.image));
        }
        let row = results::Row::new(spp, row);
        println!("{row}");
        rows.push(row);
    }
    results::save(&rows, &reference, &folders)?;
    println!("written to {}", arguments.out.display());
    Ok(())
}
