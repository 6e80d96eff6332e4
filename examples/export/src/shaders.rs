//! Shaders: for each use a file with the functions and the tables that they read.
//!
//! To paste or to include, without an entry point; but SPIR-V, which has no such thing, is a whole compute shader
//! that fills a buffer with a sample of every pixel. What its bindings hold lies beside it.

use crate::folder::{Folder, version};
use crate::translate::{Language, translate};
use bluedither::shader::{self, Parts, Table};

/// What a shader is exported for.
struct Use {
    name: &'static str,
    parts: Parts,
    tables: &'static [Table],
    /// Four numbers of pixel `id`, by the fields of `bd_fill`.
    draw: &'static str,
}

const USES: &[Use] = &[Use {
    name: "sampler",
    parts: shader::SAMPLER,
    tables: &[shader::LINEAR_ORDER],
    draw: "let sampler = bd_sampler_with_spp(bd_fill.seed, bd_fill.spp);
    let pixel = bd_sampler_pixel(sampler, id.x, id.y, bd_fill.frame);
    let drawn = bd_sampler_draw4(pixel, bd_fill.domain, bd_fill.index);",
}];

/// Writes every use in WGSL.
pub fn write_wgsl(folder: &mut Folder) -> Result<(), String> {
    for each in USES {
        folder.write(&format!("shaders/{}.wgsl", each.name), "WGSL", (each.head() + &each.text()).as_bytes())?;
    }
    Ok(())
}

/// Writes every use in another language.
pub fn write(language: Language, format: &str, folder: &mut Folder) -> Result<(), String> {
    for each in USES {
        let spirv = language == Language::Spirv;
        let text = each.text() + &if spirv { each.pass() } else { String::new() };
        let translated = translate(&text, language).map_err(|error| format!("{}: {error}", each.name))?;
        let file = if spirv { translated } else { [each.head().as_bytes(), &translated].concat() };
        let fill = if spirv { "-fill" } else { "" };
        folder.write(&format!("shaders/{}{fill}.{}", each.name, language.extension()), format, &file)?;
    }
    Ok(())
}

/// Writes what the shaders' bindings hold and no mask does.
pub fn write_constants(folder: &mut Folder) -> Result<(), String> {
    let words: Vec<u8> = shader::linear_order_words().flat_map(u32::to_le_bytes).collect();
    folder.write("shaders/linear-order.bin", "912 words of 32 bits for bd_linear_order, raw", &words)
}

impl Use {
    fn head(&self) -> String {
        format!(
            "// bluedither {}, `{}`: functions as in the Rust crate, the same bits, and the bindings of their tables.\n\
             // SPDX-License-Identifier: MIT OR Apache-2.0\n\n",
            version(),
            self.name
        )
    }

    fn text(&self) -> String {
        let bindings = self.tables.iter().map(|table| table.storage);
        self.parts.texts().chain(bindings).collect()
    }

    /// The compute shader: a sample of every pixel, four numbers each.
    fn pass(&self) -> String {
        include_str!("../fill.wgsl").replace("    /* draw */", &format!("    {}", self.draw))
    }
}
