//! Shaders: a file for each use, with all that it needs.
//!
//! In WGSL the functions of the library and the bindings of their tables, to paste above a shader of one's own. In other
//! languages the same as a whole compute shader, which fills a buffer with a sample of every pixel: to run as it is, or
//! to take the functions from. Tables lie beside them as bytes for the bindings.

use crate::arguments::Language;
use crate::folder::Folder;
use crate::translate::Shader;
use bluedither::shader::{self, Parts, Table};
use naga::back::glsl::Version;

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

/// Writes every use in a language.
pub fn write(language: Language, folder: &mut Folder) -> Result<(), String> {
    for each in USES {
        let text = each.text();
        let shader = Shader::read(&(text.clone() + &each.pass()))?;
        let mut save = |extension: &str, format: &str, bytes: &[u8]| {
            folder.write(&format!("shaders/{}.{extension}", each.name), format, bytes)
        };
        match language {
            Language::Wgsl => save("wgsl", "WGSL, functions and bindings", text.as_bytes())?,
            Language::Hlsl => save("hlsl", "HLSL, shader model 5.1", shader.hlsl()?.as_bytes())?,
            Language::Glsl => {
                let desktop = shader.glsl(Version::Desktop(450), "fill")?;
                let embedded = shader.glsl(Version::new_gles(310), "fill")?;
                save("glsl", "GLSL 450", desktop.as_bytes())?;
                save("es.glsl", "GLSL ES 310", embedded.as_bytes())?;
            }
            Language::Msl => save("metal", "Metal 2.0", shader.msl()?.as_bytes())?,
            Language::Spirv => save("spv", "SPIR-V 1.1", &shader.spirv()?)?,
            Language::C => {}
        }
    }
    Ok(())
}

/// Writes what the shaders' bindings hold and no mask does.
pub fn write_constants(folder: &mut Folder) -> Result<(), String> {
    let words: Vec<u8> = shader::linear_order_words().flat_map(u32::to_le_bytes).collect();
    folder.write("shaders/linear-order.bin", "912 words of 32 bits for bd_linear_order, raw", &words)
}

impl Use {
    fn text(&self) -> String {
        let bindings = self.tables.iter().map(|table| table.storage);
        self.parts.texts().chain(bindings).collect()
    }

    /// The compute shader: a sample of every pixel, four numbers each.
    fn pass(&self) -> String {
        include_str!("../fill.wgsl").replace("    /* draw */", &format!("    {}", self.draw))
    }
}
