//! WGSL in other languages, by naga. Functions keep their names.

use naga::Module;
use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::BoundsCheckPolicies;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

/// A shader that naga has read and found valid.
#[derive(Debug)]
pub struct Shader {
    module: Module,
    info: ModuleInfo,
}

impl Shader {
    /// The error shows the place in the text.
    pub fn read(wgsl: &str) -> Result<Self, String> {
        let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let info = validator.validate(&module).map_err(|error| error.emit_to_string(wgsl))?;
        Ok(Self { module, info })
    }

    /// GLSL of a version: `Desktop(450)`, or for ES `new_gles(310)`. Buffers of each kind are numbered from 0 on, since
    /// some drivers have four.
    pub fn glsl(&self, version: glsl::Version, entry: &str) -> Result<String, String> {
        let stage = self.module.entry_points.iter().find(|found| found.name == entry).map(|found| found.stage);
        let stage = stage.ok_or_else(|| format!("there is no entry point {entry}"))?;
        let mut next = [0u8; 3];
        let mut number = |space: naga::AddressSpace| {
            let kind = match space {
                naga::AddressSpace::Uniform => 0,
                naga::AddressSpace::Storage { .. } => 1,
                _ => 2,
            };
            next[kind] += 1;
            next[kind] - 1
        };
        let options = glsl::Options {
            version,
            writer_flags: glsl::WriterFlags::empty(),
            binding_map: self.bound().map(|(_, place, space)| (place, number(space))).collect(),
            zero_initialize_workgroup_memory: false,
        };
        let pipeline = glsl::PipelineOptions { shader_stage: stage, entry_point: entry.into(), multiview: None };
        let (mut text, policies) = (String::new(), BoundsCheckPolicies::default());
        glsl::Writer::new(&mut text, &self.module, &self.info, &options, &pipeline, policies)
            .and_then(|mut writer| writer.write())
            .map_err(|error| format!("no GLSL: {error}"))?;
        for (name, place, _) in self.bound() {
            let stage = if stage == naga::ShaderStage::Compute { "cs" } else { "fs" };
            text = text.replace(&format!("_group_{}_binding_{}_{stage}", place.group, place.binding), name);
        }
        Ok(self.named(text))
    }

    /// HLSL of shader model 5.1: bindings are registers of the same number, groups are spaces.
    pub fn hlsl(&self) -> Result<String, String> {
        let options = hlsl::Options { restrict_indexing: false, force_loop_bounding: false, ..Default::default() };
        let pipeline = hlsl::PipelineOptions::default();
        let mut text = String::new();
        let written = hlsl::Writer::new(&mut text, &options, &pipeline).write(&self.module, &self.info, None);
        written.map_err(|error| format!("no HLSL: {error}"))?;
        Ok(self.named(text))
    }

    /// Metal 2.0: bindings are arguments of the entry points, of the same numbers; buffer 30 holds the sizes of the others
    /// that have none of their own, in bytes, 32 bits each, in their order.
    pub fn msl(&self) -> Result<String, String> {
        let slots = |entry: &naga::EntryPoint| {
            let resources = self.bound().map(|(_, place, space)| {
                let slot = u8::try_from(place.binding).unwrap_or(u8::MAX);
                let texture = (space == naga::AddressSpace::Handle).then_some(slot);
                let buffer = texture.is_none().then_some(slot);
                let store = naga::StorageAccess::STORE;
                let mutable = matches!(space, naga::AddressSpace::Storage { access } if access.contains(store));
                (place, msl::BindTarget { buffer, texture, mutable, ..Default::default() })
            });
            let resources = resources.collect();
            (entry.name.clone(), msl::EntryPointResources { resources, sizes_buffer: Some(30), ..Default::default() })
        };
        let options = msl::Options {
            lang_version: (2, 0),
            per_entry_point_map: self.module.entry_points.iter().map(slots).collect(),
            fake_missing_bindings: false,
            force_loop_bounding: false,
            ..Default::default()
        };
        let written = msl::write_string(&self.module, &self.info, &options, &msl::PipelineOptions::default());
        let (text, _) = written.map_err(|error| format!("no MSL: {error}"))?;
        Ok(self.named(text))
    }

    /// SPIR-V 1.1, little-endian, for Vulkan 1.1 and later.
    pub fn spirv(&self) -> Result<Vec<u8>, String> {
        let options = spv::Options { lang_version: (1, 1), force_loop_bounding: false, ..Default::default() };
        let words = spv::write_vec(&self.module, &self.info, &options, None);
        let words = words.map_err(|error| format!("no SPIR-V: {error}"))?;
        Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
    }

    /// What is bound: its name, place and kind.
    fn bound(&self) -> impl Iterator<Item = (&str, naga::ResourceBinding, naga::AddressSpace)> {
        let variables = self.module.global_variables.iter();
        variables.filter_map(|(_, each)| Some((each.name.as_deref()?, each.binding?, each.space)))
    }

    /// naga appends an underscore to names that end in a digit, and then they are not those of the documentation.
    fn named(&self, mut text: String) -> String {
        let functions = self.module.functions.iter().filter_map(|(_, function)| function.name.as_deref());
        for name in functions.filter(|name| name.ends_with(|last: char| last.is_ascii_digit())) {
            text = text.replace(&format!("{name}_("), &format!("{name}("));
        }
        text
    }
}
