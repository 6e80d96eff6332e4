//! What a shader costs, of its WGSL.

use std::fmt::{Display, Formatter, Result as Formatted};

use ash::vk;
use naga::{AddressSpace, ImageClass, Module, TypeInner};

use crate::radv::{Binding, Radv};
use crate::translate::{Language, parse, translate};

/// What the driver says of an entry point.
#[derive(Debug, PartialEq, Eq)]
pub struct Cost {
    /// In the order of the names below.
    figures: [u64; NAMES.len()],
}

const NAMES: [&str; 5] = ["Instructions", "Inverse Throughput", "VGPRs", "Latency", "Code size"];

impl Cost {
    pub const HEAD: &str =
        " instructions | inverse throughput | VGPRs | latency | bytes of code |\n|---|---:|---:|---:|---:|---:|---:|";
}

impl Display for Cost {
    fn fmt(&self, f: &mut Formatter<'_>) -> Formatted {
        self.figures.iter().try_for_each(|figure| write!(f, " {figure} |"))
    }
}

/// Every compute entry point's name and cost, in the order of the text.
pub fn costs(radv: &Radv, wgsl: &str) -> Result<Vec<(String, Cost)>, String> {
    let (module, _) = parse(wgsl)?;
    let bytes = translate(wgsl, Language::Spirv, "")?;
    let spirv: Vec<u32> =
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    let bindings = bindings(&module);
    let cost = |name: &str| {
        let told = radv.compile(&spirv, name, &bindings)?;
        let figure = |name: &str| told.iter().find(|(told, _)| told == name).map_or(0, |&(_, figure)| figure);
        Ok((name.to_string(), Cost { figures: NAMES.map(figure) }))
    };
    module.entry_points.iter().map(|point| cost(&point.name)).collect()
}

fn bindings(module: &Module) -> Vec<Binding> {
    let bound = module.global_variables.iter().filter_map(|(_, variable)| Some((variable.binding?, variable)));
    bound
        .map(|(place, variable)| {
            let kind = match (variable.space, &module.types[variable.ty].inner) {
                (AddressSpace::Uniform, _) => vk::DescriptorType::UNIFORM_BUFFER,
                (AddressSpace::Storage { .. }, _) => vk::DescriptorType::STORAGE_BUFFER,
                (_, TypeInner::Sampler { .. }) => vk::DescriptorType::SAMPLER,
                (_, TypeInner::Image { class: ImageClass::Storage { .. }, .. }) => vk::DescriptorType::STORAGE_IMAGE,
                _ => vk::DescriptorType::SAMPLED_IMAGE,
            };
            (place.group, place.binding, kind)
        })
        .collect()
}
