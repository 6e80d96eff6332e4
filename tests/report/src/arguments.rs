//! The command line.

use crate::error_part::COUNTS;
use crate::samplers;
use clap::builder::PossibleValuesParser;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Measure every sampler and its peers: error, spectra, speed, size. Writes a page, tables and numbers.
#[derive(Debug, Parser)]
#[command(name = "report", after_help = EXAMPLE)]
pub struct Arguments {
    /// What to measure; everything if none is named
    #[arg(value_enum)]
    parts: Vec<Part>,

    /// Samplers, a list; "white" is always measured, since the others are held against it
    #[arg(long, value_delimiter = ',', value_parser = PossibleValuesParser::new(samplers::NAMES))]
    only: Vec<String>,

    /// Fewer seeds and sample counts: at most a minute
    #[arg(long)]
    pub quick: bool,

    /// A file whose blocks between markers are filled anew; needs the parts "error" and "speed" of all samplers
    #[arg(long, conflicts_with_all = ["quick", "only"])]
    pub readme: Option<PathBuf>,

    /// The first of the seeds
    #[arg(long, default_value_t = 1)]
    pub seed: u32,

    /// Does what instructions are counted of, for the program that counts them
    #[arg(long, hide = true)]
    pub count_instructions: bool,

    /// Folder to write to; it is made if need be
    #[arg(long, default_value = "target/report")]
    pub out: PathBuf,
}

const EXAMPLE: &str = "Example: the error table of one sampler, beside white noise
  cargo run --release -p report -- --only dithered error";

/// A part of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Part {
    /// Error at powers of two: W, G, root mean squares, spikes, other filters, spectra
    Error,
    /// Error of the first samples of a larger set
    Prefixes,
    /// Error at sample counts that are no powers of two
    Odd,
    /// The mean over frames
    Frames,
    /// Integrands of the literature, one by one
    Classic,
    /// One number a sample
    Singles,
    /// Nanoseconds a number
    Speed,
    /// Instructions a number, where valgrind is installed
    Instructions,
    /// What a shader costs on a GPU's compiler, where its driver is installed; not with --quick
    Shaders,
    /// Seconds that a build takes, by features; not with --quick
    Builds,
    /// Bytes of tables
    Size,
    /// Spectra of the masks themselves
    Masks,
    /// Nanoseconds a dithered pixel, beside a copy of memory
    Dither,
    /// Integrands of 4 and 8 dimensions, over domains
    Domains,
    /// Edges that move over the screen
    Edges,
    /// The render example's scene, by what is sampled, and after a denoiser
    Scene,
}

impl Arguments {
    /// The chosen samplers in the order of the tables.
    pub fn samplers(&self) -> Vec<&'static str> {
        let chosen =
            |name: &str| self.only.is_empty() || name == samplers::WHITE || self.only.iter().any(|s| s == name);
        samplers::NAMES.iter().copied().filter(|name| chosen(name)).collect()
    }

    pub fn has(&self, part: Part) -> bool {
        let filled = self.readme.is_some() && [Part::Error, Part::Speed].contains(&part);
        filled || self.parts.is_empty() || self.parts.contains(&part)
    }

    /// Seeds of every error figure.
    pub fn seeds(&self) -> u32 {
        if self.quick { 2 } else { 16 }
    }

    /// Samples per pixel of the error figures.
    pub fn counts(&self) -> &'static [u32] {
        if self.quick { &COUNTS[..5] } else { &COUNTS }
    }

    /// Rounds of every timing.
    pub fn rounds(&self) -> usize {
        if self.quick { 9 } else { 31 }
    }
}
