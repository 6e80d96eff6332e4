//! The command line.

use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Write masks as textures, and functions for other languages; all there is if nothing is named.
#[derive(Debug, Parser)]
#[command(name = "export", after_help = EXAMPLE)]
pub struct Arguments {
    /// Folder to write to; it is made if need be
    #[arg(long, default_value = "exports")]
    pub out: PathBuf,

    /// Languages, a list; named alone, no textures are written
    #[arg(long, value_enum, value_delimiter = ',')]
    lang: Vec<Language>,

    /// Tables, a list, by the names of their features; named alone, only their textures are written
    #[arg(long, value_delimiter = ',', num_args = 1..)]
    pub mask: Vec<String>,
}

const EXAMPLE: &str = "Example: a mask that is not built by default, and a C header that holds it
  cargo run -p export --features threshold-128 -- --mask threshold-128 --lang c --out engine";

/// What functions can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Language {
    /// Functions to paste above a shader of your own, and bindings
    Wgsl,
    /// For Direct3D, shader model 5.1
    Hlsl,
    /// For OpenGL, 4.5 and ES 3.1
    Glsl,
    /// For Metal 2.0
    Msl,
    /// For Vulkan, a compute shader
    Spirv,
    /// A C99 header
    C,
    /// A page that runs the WGSL in a browser
    Web,
}

impl Arguments {
    /// Whether textures are asked for.
    pub fn textures(&self) -> bool {
        self.lang.is_empty() || !self.mask.is_empty()
    }

    /// The languages that are asked for, each once.
    pub fn languages(&self) -> Vec<Language> {
        let all = self.lang.is_empty() && self.mask.is_empty();
        let asked = |language: &Language| all || self.lang.contains(language);
        Language::value_variants().iter().copied().filter(asked).collect()
    }
}
