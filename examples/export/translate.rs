//! WGSL into the languages of other engines, by naga.

use naga::back::{glsl, hlsl, msl, spv};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

/// What WGSL is translated into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// For Direct3D: shader model 5.1.
    Hlsl,
    /// For Vulkan and desktop GL: version 450.
    Glsl,
    /// For mobile GL: ES 310.
    GlslEs,
    /// For Metal: version 2.0.
    Msl,
    /// For Vulkan: version 1.1.
    Spirv,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Hlsl, Self::Glsl, Self::GlslEs, Self::Msl, Self::Spirv];

    /// How a file's name ends.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Hlsl => "hlsl",
            Self::Glsl => "glsl",
            Self::GlslEs => "es.glsl",
            Self::Msl => "metal",
            Self::Spirv => "spv",
        }
    }
}

/// The text, or SPIR-V's bytes, of a shader, or of functions without an entry point, which is to be included in
/// another. Functions keep their names. A binding of group 0 keeps its number: in HLSL as register, in GLSL as
/// binding. The error is naga's, on the text.
///
/// GLSL has one entry point, `entry`; the other languages have them all.
pub fn translate(wgsl: &str, language: Language, entry: &str) -> Result<Vec<u8>, String> {
    let (module, info) = parse(wgsl)?;
    let library = module.entry_points.is_empty();
    let written = match language {
        Language::Hlsl => to_hlsl(&module, &info),
        Language::Msl => to_msl(&module, &info),
        Language::Spirv => return to_spirv(&module, &info),
        // It has no text without an entry point.
        Language::Glsl | Language::GlslEs if library => {
            let (module, info) = parse(&format!("{wgsl}{ENTRY}"))?;
            to_glsl(&module, &info, language, "main").map(|text| without_entry(&text))
        }
        Language::Glsl | Language::GlslEs => to_glsl(&module, &info, language, entry),
    }?;
    Ok(own_names(&written).into_bytes())
}

const ENTRY: &str = "@compute @workgroup_size(1) fn main() {}\n";

/// Reads and validates. The error shows the place.
pub fn parse(wgsl: &str) -> Result<(naga::Module, ModuleInfo), String> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::default());
    let info = validator.validate(&module).map_err(|error| error.emit_to_string(wgsl))?;
    Ok((module, info))
}

fn to_hlsl(module: &naga::Module, info: &ModuleInfo) -> Result<String, String> {
    // Nothing here reads workgroup memory before it writes it.
    let options = hlsl::Options { zero_initialize_workgroup_memory: false, ..Default::default() };
    let pipeline = hlsl::PipelineOptions::default();
    let mut text = String::new();
    let mut writer = hlsl::Writer::new(&mut text, &options, &pipeline);
    writer.write(module, info, None).map_err(|error| error.to_string())?;
    Ok(text)
}

fn to_msl(module: &naga::Module, info: &ModuleInfo) -> Result<String, String> {
    let options = msl::Options { lang_version: (2, 0), fake_missing_bindings: true, ..Default::default() };
    let written = msl::write_string(module, info, &options, &msl::PipelineOptions::default());
    written.map(|(text, _)| text).map_err(|error| error.to_string())
}

fn to_spirv(module: &naga::Module, info: &ModuleInfo) -> Result<Vec<u8>, String> {
    let options = spv::Options { lang_version: (1, 3), ..Default::default() };
    let words = spv::write_vec(module, info, &options, None).map_err(|error| error.to_string())?;
    Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
}

fn to_glsl(module: &naga::Module, info: &ModuleInfo, language: Language, entry: &str) -> Result<String, String> {
    let version = if language == Language::GlslEs { glsl::Version::new_gles(310) } else { glsl::Version::Desktop(450) };
    let bound = module.global_variables.iter().filter_map(|(_, variable)| variable.binding);
    let number = |binding: naga::ResourceBinding| (binding.group * 16 + binding.binding) as u8;
    let options = glsl::Options {
        version,
        writer_flags: glsl::WriterFlags::INCLUDE_UNUSED_ITEMS,
        binding_map: bound.map(|binding| (binding, number(binding))).collect(),
        zero_initialize_workgroup_memory: true,
    };
    let entry =
        module.entry_points.iter().find(|point| point.name == entry).ok_or(format!("no entry point {entry}"))?;
    let pipeline =
        glsl::PipelineOptions { shader_stage: entry.stage, entry_point: entry.name.clone(), multiview: None };
    let mut text = String::new();
    let policies = naga::proc::BoundsCheckPolicies::default();
    glsl::Writer::new(&mut text, module, info, &options, &pipeline, policies)
        .and_then(|mut writer| writer.write())
        .map_err(|error| error.to_string())?;
    // Bindings have names of numbers; their own are those of the documentation.
    for (_, variable) in module.global_variables.iter() {
        if let (Some(name), Some(binding)) = (&variable.name, variable.binding) {
            text = text.replace(&format!("_group_{}_binding_{}_cs", binding.group, binding.binding), name);
        }
    }
    Ok(text)
}

/// Without the empty entry point that was added.
fn without_entry(glsl: &str) -> String {
    let end = glsl.rfind("void main()").unwrap_or(glsl.len());
    let lines = glsl[..end].lines().filter(|line| !line.starts_with("layout(local_size_x"));
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// naga appends an underscore to names that end in a digit.
fn own_names(text: &str) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut out = String::with_capacity(text.len());
    for piece in text.split_inclusive(|c| !is_part(c)) {
        let name = piece.trim_end_matches(|c| !is_part(c));
        let changed = name
            .strip_suffix('_')
            .filter(|name| name.starts_with("bd_") && name.ends_with(|c: char| c.is_ascii_digit()));
        out.push_str(changed.unwrap_or(name));
        out.push_str(&piece[name.len()..]);
    }
    out
}
