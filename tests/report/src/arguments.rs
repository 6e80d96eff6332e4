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
    #[arg(long, alias = "only", value_delimiter = ',', value_parser = PossibleValuesParser::new(samplers::NAMES))]
    samplers: Vec<String>,

    /// Fewer seeds and sample counts: at most a minute
    #[arg(long)]
    pub quick: bool,

    /// Samples per pixel of the parts "several" and "tracer", a list [default: powers of two, of four, up to 64]
    #[arg(long, value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=4096))]
    spp: Vec<u32>,

    /// Seeds of every error figure [default: 16, of the parts "several" and "tracer" 8]
    #[arg(long, value_parser = clap::value_parser!(u32).range(2..=1024))]
    seeds: Option<u32>,

    /// A standard error beside every figure of the parts "several" and "tracer"
    #[arg(long)]
    pub errors: bool,

    /// A file whose blocks between markers are filled anew; needs the parts "error" and "speed" of all samplers
    #[arg(long, conflicts_with_all = ["quick", "samplers"])]
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
  cargo run --release -p report -- --samplers dithered error
Eight dimensions at once, at every number of samples that is asked about
  cargo run --release -p report -- several --samplers sampler,sobol-z --spp 1,2,3,4,5,6,7,8,9,12,16,20,32,64,100,256";

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
    /// Several dimensions at once: families of integrands, local spikes, every cell that is worse than white noise
    Several,
    /// A path tracer: direct light, two and five vertices; also through a reconstruction filter
    Tracer,
    /// Edges that move over the screen
    Edges,
    /// The render example's scene, by what is sampled, and after a denoiser
    Scene,
}

impl Arguments {
    /// The chosen samplers in the order of the tables.
    pub fn samplers(&self) -> Vec<&'static str> {
        let chosen =
            |name: &str| self.samplers.is_empty() || name == samplers::WHITE || self.samplers.iter().any(|s| s == name);
        samplers::NAMES.iter().copied().filter(|name| chosen(name)).collect()
    }

    /// The same, and of each sampler its progressive form.
    pub fn samplers_and_twins(&self) -> Vec<&'static str> {
        let names = self.samplers();
        let is_twin = |name: &str| name.strip_suffix("-progressive").is_some_and(|known| names.contains(&known));
        samplers::NAMES.iter().copied().filter(|name| names.contains(name) || is_twin(name)).collect()
    }

    /// Samples per pixel that are asked for, each once, the least first.
    pub fn spp(&self) -> Option<Vec<u32>> {
        let mut spp = self.spp.clone();
        spp.sort_unstable();
        spp.dedup();
        (!spp.is_empty()).then_some(spp)
    }

    pub fn chosen_seeds(&self) -> Option<u32> {
        self.seeds
    }

    pub fn has(&self, part: Part) -> bool {
        let filled = self.readme.is_some() && [Part::Error, Part::Speed].contains(&part);
        filled || self.parts.is_empty() || self.parts.contains(&part)
    }

    /// Seeds of every error figure.
    pub fn seeds(&self) -> u32 {
        self.seeds.unwrap_or(if self.quick { 2 } else { 16 })
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
