//! What a shader costs, of its WGSL.

use std::fmt::{Display, Formatter, Result as Formatted};

use ash::vk;
use naga::{AddressSpace, ImageClass, Module, TypeInner};

use crate::radv::{Binding, Radv};
use crate::translate::{Language, parse, translate};

/// The driver's names of what is told.
const NAMES: [&str; 5] = ["Instructions", "Inverse Throughput", "VGPRs", "Latency", "Code size"];

/// A table's first two lines in Markdown, with the names of the first columns.
pub fn head(first: &str) -> String {
    let head = format!("| {first} | instructions | inverse throughput | VGPRs | latency | bytes of code |");
    let rule = "|---:".repeat(head.matches(" | ").count());
    format!("{head}\n|---{rule}|")
}

/// What the driver says of an entry point, in the order of [`NAMES`].
#[derive(Debug, PartialEq, Eq)]
pub struct Cost([u64; NAMES.len()]);

impl Cost {
    pub fn instructions(&self) -> u64 {
        self.0[0]
    }

    /// Cycles of the unit that is busiest.
    pub fn inverse_throughput(&self) -> u64 {
        self.0[1]
    }
}

impl Display for Cost {
    fn fmt(&self, f: &mut Formatter<'_>) -> Formatted {
        self.0.iter().try_for_each(|figure| write!(f, " {figure} |"))
    }
}

/// Every compute entry point's name and cost, in the order of the text.
pub fn costs(radv: &Radv, wgsl: &str) -> Result<Vec<(String, Cost)>, String> {
    let (module, _) = parse(wgsl)?;
    let bytes = translate(wgsl, Language::Spirv, "")?;
    let spirv: Vec<u32> =
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    let bindings = bindings(&module);
    let cost = |name: &str| -> Result<(String, Cost), String> {
        let told = radv.compile(&spirv, name, &bindings)?;
        let mut cost = Cost([0; NAMES.len()]);
        for (figure, name) in cost.0.iter_mut().zip(NAMES) {
            let found = told.iter().find(|(told, _)| told == name);
            *figure = found.ok_or_else(|| format!("this version of the driver tells no {name}"))?.1;
        }
        Ok((name.to_string(), cost))
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
