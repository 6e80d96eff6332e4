//! The command line.

use crate::energy::Spectrum;
use crate::samplers;
use crate::scene::Dimensions;
use clap::builder::PossibleValuesParser;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Render a small scene with every sampler; write contact sheets, pictures, errors and spectra; print a table.
#[derive(Parser)]
#[command(name = "render", after_help = EXAMPLE)]
pub struct Arguments {
    /// Size in pixels, "384x256" or "384" (then 3:2); both sides 64 to 2048
    #[arg(long, default_value = "384x256", value_parser = size)]
    pub size: [u32; 2],

    /// Samples per pixel, a list, each 1 to 1024
    #[arg(long, default_value = "1,4,9,16", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..=1024))]
    spp: Vec<u32>,

    /// Samplers, a list; "white" is always among them, since the others are measured against it
    #[arg(long, alias = "sampler", value_delimiter = ',', value_parser = PossibleValuesParser::new(samplers::NAMES))]
    samplers: Vec<String>,

    /// What is sampled, a list; the rest stays at its centre
    #[arg(long, alias = "dimension", default_value = "all", value_delimiter = ',')]
    dimensions: Vec<Dimension>,

    /// Seed of the samplers, the masks and the reference
    #[arg(long, default_value_t = 1)]
    pub seed: u32,

    /// Frame number: other numbers for the same seed
    #[arg(long, default_value_t = 0)]
    pub frame: u32,

    /// Animate a room of paths of ten bounces instead, so many frames, with white noise and with seeds that change
    /// places
    #[cfg(feature = "seed-permutation")]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=256))]
    pub frames: Option<u32>,

    /// Folder to write to; it is made if need be
    #[arg(long, default_value = "renders")]
    pub out: PathBuf,

    /// Swaps per pixel when the published masks are annealed
    #[arg(long, default_value_t = 500, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub swaps: u32,

    /// Samples per pixel of the reference, at least
    #[arg(long, default_value_t = 2048, value_parser = clap::value_parser!(u32).range(2..=1_000_000))]
    pub reference: u32,
}

const EXAMPLE: &str = "Example: the moving sphere alone, two samplers
  cargo run --release --example render -- --dimensions time --samplers high-stratified,sampler --spp 1,4 --out motion";

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Dimension {
    Time,
    Lens,
    Light,
    All,
}

impl Arguments {
    /// The sample counts, each once, the least first.
    pub fn spp(&self) -> Vec<u32> {
        let mut spp = self.spp.clone();
        spp.sort_unstable();
        spp.dedup();
        spp
    }

    /// The chosen samplers in the order of the sheets.
    pub fn samplers(&self) -> Vec<&'static str> {
        let chosen =
            |name: &str| self.samplers.is_empty() || name == "white" || self.samplers.iter().any(|s| s == name);
        samplers::NAMES.iter().copied().filter(|name| chosen(name)).collect()
    }

    /// The masks that the chosen samplers need: their names begin with the spectrum.
    pub fn spectra(&self) -> Vec<Spectrum> {
        let names = self.samplers();
        let all = [("low", Spectrum::Low), ("all", Spectrum::All), ("high", Spectrum::High)];
        let needed = all.into_iter().filter(|(prefix, _)| names.iter().any(|name| name.starts_with(prefix)));
        needed.map(|(_, spectrum)| spectrum).collect()
    }

    pub fn dimensions(&self) -> Dimensions {
        let has = |d| self.dimensions.iter().any(|chosen| *chosen == d || *chosen == Dimension::All);
        Dimensions { time: has(Dimension::Time), lens: has(Dimension::Lens), light: has(Dimension::Light) }
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let number = |part: &str| part.parse::<u32>().map_err(|_| "expected a width, or WIDTHxHEIGHT".to_string());
    let size = match text.split_once('x') {
        Some((width, height)) => [number(width)?, number(height)?],
        None => [number(text)?, number(text)?.saturating_mul(2).div_ceil(3)],
    };
    if size.iter().all(|side| (64..=2048).contains(side)) {
        Ok(size)
    } else {
        Err(format!("{}x{}: both sides must be within 64 and 2048 pixels", size[0], size[1]))
    }
}
