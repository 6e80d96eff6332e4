//! Writes the library's tables and functions for other engines, languages and tools.
//!
//! ```text
//! cargo run -p export -- --out DIR
//! ```
//!
//! Masks as raw bytes, PNG of 8 and 16 bits and DDS; shaders in WGSL, HLSL, GLSL, MSL and SPIR-V; a C99 header; a web
//! page that runs the WGSL; a manifest with digests. More tables by features: `--features keys-64`, or `--features
//! all`.

mod arguments;
#[cfg(all(test, feature = "all"))]
mod browser;
mod c;
#[cfg(all(test, feature = "all"))]
mod c_checks;
#[path = "../../../src/bake/digest.rs"]
#[allow(dead_code, reason = "the bake uses the rest")]
mod digest;
mod folder;
mod page;
#[cfg(all(test, feature = "all"))]
mod page_checks;
mod shaders;
#[allow(dead_code, reason = "which kinds of tables there are depends on features")]
mod tables;
#[cfg(all(test, feature = "all"))]
mod texture_checks;
mod textures;
#[path = "../translate.rs"]
#[allow(dead_code, reason = "the checks of shaders use the rest")]
mod translate;

use arguments::{Arguments, Language};
use clap::Parser;
use folder::Folder;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

/// Textures, then languages, then the manifest of both.
fn run(arguments: &Arguments) -> Result<(), String> {
    let tables = tables::named(&arguments.mask)?;
    let mut folder = Folder::create(&arguments.out)?;
    if arguments.textures() {
        for table in &tables {
            textures::write(table, &mut folder)?;
        }
    }
    let languages = arguments.languages();
    for &language in &languages {
        match language {
            Language::C => folder.write("bluedither.h", "C99 header", c::header(&tables).as_bytes())?,
            Language::Web => page::write(&mut folder)?,
            Language::Wgsl => shaders::write_wgsl(&mut folder)?,
            Language::Hlsl => shaders::write(translate::Language::Hlsl, "HLSL, shader model 5.1", &mut folder)?,
            Language::Glsl => {
                shaders::write(translate::Language::Glsl, "GLSL 450", &mut folder)?;
                shaders::write(translate::Language::GlslEs, "GLSL ES 310", &mut folder)?;
            }
            Language::Msl => shaders::write(translate::Language::Msl, "Metal 2.0", &mut folder)?,
            Language::Spirv => shaders::write(translate::Language::Spirv, "SPIR-V 1.3, entry point fill", &mut folder)?,
        }
    }
    if languages.iter().any(|language| !matches!(language, Language::C | Language::Web)) {
        shaders::write_tables(&mut folder)?;
    }
    if tables.iter().any(|table| table.kind == tables::Kind::Directions) {
        let text = include_bytes!("../../../tables/joe_kuo.LICENSE.txt");
        folder.write("joe_kuo.LICENSE.txt", "licence of the direction numbers", text)?;
    }
    // What the shaders' bindings hold is said with its files.
    let written = arguments.textures() || languages.contains(&Language::C);
    folder.close(if written { &tables } else { &[] })
}
