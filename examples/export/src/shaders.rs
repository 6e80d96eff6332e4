//! Shaders: for each use a file with the functions and the tables that they read.
//!
//! To paste or to include, without an entry point; but SPIR-V, which has no such thing, is a whole compute shader
//! that fills a buffer with a sample of every pixel. What its bindings hold lies beside it.

use crate::folder::{Folder, version};
use crate::translate::{Language, translate};
use bluedither::shader::{self, Parts, Table};

/// What a shader is exported for.
pub struct Use {
    /// Of the file; of a sampler the word in its functions' names.
    pub name: &'static str,
    /// Of the type in Rust.
    pub title: &'static str,
    parts: Parts,
    pub tables: &'static [Bound],
    /// Four numbers of pixel `id`, by the fields of `bd_fill`; none for samplers, which all have the same.
    draw: Option<&'static str>,
}

/// A table that a shader reads.
pub struct Bound {
    pub table: Table,
    /// Pixels a side, of masks.
    side: usize,
    /// The file that holds its words.
    file: &'static str,
    words: fn() -> Vec<u32>,
}

const NET: Bound = Bound { table: shader::NET, side: 0, file: "net.bin", words: || shader::net_words().collect() };
#[cfg(feature = "keys-64")]
const SEQUENCE: Bound =
    Bound { table: shader::SEQUENCE, side: 0, file: "sequence.bin", words: || shader::sequence_words().collect() };
/// A tile of 64 pixels a side: the feature that bakes it, what reads it, its file and its words.
macro_rules! tile {
    ($name:ident, $feature:literal, $reads:ident, $file:literal, $words:ident($table:ident)) => {
        #[cfg(feature = $feature)]
        const $name: Bound = Bound {
            table: shader::$reads,
            side: 64,
            file: $file,
            words: || shader::$words(&bluedither::tables::$table).collect(),
        };
    };
}
tile!(THRESHOLD, "threshold-64", SCALAR_MASK, "threshold-64.bin", scalar_words(THRESHOLD_64));
tile!(OFFSET, "offset-2d-64", VECTOR_MASK, "offset-2d-64.bin", vector_words(OFFSET_2D_64));
tile!(KEYS, "keys-64", KEYS_TILE, "keys-64-words.bin", keys_words(KEYS_64));

/// All of them.
pub const USES: &[Use] = &[
    Use { name: "sampler", title: "Sampler", parts: shader::SAMPLER, tables: &[NET], draw: None },
    #[cfg(feature = "keys-64")]
    Use { name: "keyed", title: "Keyed", parts: shader::KEYED, tables: &[SEQUENCE, KEYS], draw: None },
    #[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
    Use { name: "dithered", title: "Dithered", parts: shader::DITHERED, tables: &[THRESHOLD, OFFSET], draw: None },
    Use { name: "white", title: "White", parts: shader::WHITE, tables: &[], draw: None },
    #[cfg(feature = "threshold-64")]
    Use {
        name: "dither",
        title: "Dither",
        parts: shader::DITHER,
        tables: &[THRESHOLD],
        draw: Some(
            "let dither = bd_dither_frame(bd_dither_blue(), bd_fill.frame);
    var drawn: vec4<f32>;
    for (var channel = 0u; channel < 4u; channel++) {
        drawn[channel] = bd_unit_to_f32(bd_dither_threshold_fx(dither, id.x, id.y, channel));
    }",
        ),
    },
];

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
        let translated = translate(&text, language, "fill").map_err(|error| format!("{}: {error}", each.name))?;
        let (file, fill) = if spirv { (translated, "-fill") } else { (each.included(translated), "") };
        folder.write(&format!("shaders/{}{fill}.{}", each.name, language.extension()), format, &file)?;
    }
    Ok(())
}

/// Writes what the shaders' bindings hold.
pub fn write_tables(folder: &mut Folder) -> Result<(), String> {
    let mut bounds: Vec<&Bound> = USES.iter().flat_map(|each| each.tables).collect();
    bounds.sort_by_key(|bound| bound.file);
    bounds.dedup_by_key(|bound| bound.file);
    for bound in bounds {
        folder.write(&format!("shaders/{}", bound.file), "what a binding of the shaders holds", &bound.bytes())?;
    }
    Ok(())
}

impl Bound {
    /// What its buffer holds.
    pub fn bytes(&self) -> Vec<u8> {
        (self.words)().into_iter().flat_map(u32::to_le_bytes).collect()
    }
}

impl Use {
    /// Whether it draws samples.
    pub fn is_sampler(&self) -> bool {
        self.draw.is_none()
    }

    /// Functions and bindings, WGSL.
    pub fn text(&self) -> String {
        let bindings = self.tables.iter().flat_map(|bound| [bound.table.size_text(bound.side), bound.table.storage]);
        self.parts.texts().chain(bindings).collect()
    }

    fn head(&self) -> String {
        let mut head = format!(
            "// bluedither {}, `{}`: functions as in the Rust crate, the same bits, and their tables.\n\
             // SPDX-License-Identifier: MIT OR Apache-2.0\n",
            version(),
            self.title
        );
        for bound in self.tables {
            head += &format!("// Binding {}: a storage buffer of {}.\n", bound.table.binding, bound.file);
        }
        head + "// One such file a shader: others have the same functions. For several at once see `shader::Parts` of the crate.\n\n"
    }

    /// Text for others to include: its version is theirs to say.
    fn included(&self, text: Vec<u8>) -> Vec<u8> {
        let text = String::from_utf8_lossy(&text);
        let (first, rest) = text.split_once('\n').unwrap_or(("", &text));
        let text = first.strip_prefix("#version").map_or_else(
            || text.to_string(),
            |version| format!("// To be included in a shader of #version{version} or later.\n{rest}"),
        );
        (self.head() + &text).into_bytes()
    }

    /// The compute shader: a sample of every pixel, four numbers each.
    fn pass(&self) -> String {
        let sampler = || {
            format!(
                "let pixel = bd_{0}_pixel(bd_{0}_with_spp(bd_fill.seed, bd_fill.spp), id.x, id.y, bd_fill.frame);
    let drawn = bd_{0}_draw4(pixel, bd_fill.domain, bd_fill.index);",
                self.name
            )
        };
        let drawn = self.draw.map_or_else(sampler, String::from);
        include_str!("../fill.wgsl").replace("/* draw */", &drawn)
    }
}
