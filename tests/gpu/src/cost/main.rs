//! What shaders cost on the compiler of a real GPU, without a GPU.
//!
//! ```text
//! cargo run -p gpu --bin cost                    # every sampler and what it is compared with, as Markdown
//! cargo run -p gpu --bin cost -- FILE.wgsl …     # every compute entry point of files
//! ```

#[expect(unsafe_code, reason = "Vulkan is a C interface")]
mod radv;
#[path = "../../../../examples/export/translate.rs"]
#[expect(dead_code, reason = "the checks of shaders use the rest")]
mod translate;

use std::process::ExitCode;

use ash::vk;
use naga::{AddressSpace, TypeInner};
use radv::{Binding, Radv};
use translate::Language;

fn main() -> ExitCode {
    let files: Vec<String> = std::env::args().skip(1).collect();
    match run(&files) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

fn run(files: &[String]) -> Result<(), String> {
    let radv = Radv::new()?;
    println!("{}\n", radv.name);
    for file in files {
        let text = std::fs::read_to_string(file).map_err(|error| format!("{file} cannot be read ({error})"))?;
        for (name, told) in costs(&radv, &text)? {
            println!("{name} {told:?}");
        }
    }
    Ok(())
}

fn costs(radv: &Radv, wgsl: &str) -> Result<Vec<(String, Vec<(String, u64)>)>, String> {
    let (module, _) = translate::parse(wgsl)?;
    let bytes = translate::translate(wgsl, Language::Spirv, "")?;
    let spirv: Vec<u32> =
        bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect();
    let bindings = bindings(&module);
    let points = module.entry_points.iter();
    points.map(|point| Ok((point.name.clone(), radv.compile(&spirv, &point.name, &bindings)?))).collect()
}

fn bindings(module: &naga::Module) -> Vec<Binding> {
    let bound = module.global_variables.iter().filter_map(|(_, variable)| Some((variable.binding?, variable)));
    bound
        .map(|(place, variable)| {
            let kind = match (variable.space, &module.types[variable.ty].inner) {
                (AddressSpace::Uniform, _) => vk::DescriptorType::UNIFORM_BUFFER,
                (AddressSpace::Storage { .. }, _) => vk::DescriptorType::STORAGE_BUFFER,
                (_, TypeInner::Sampler { .. }) => vk::DescriptorType::SAMPLER,
                (_, TypeInner::Image { class: naga::ImageClass::Storage { .. }, .. }) => {
                    vk::DescriptorType::STORAGE_IMAGE
                }
                _ => vk::DescriptorType::SAMPLED_IMAGE,
            };
            (place.group, place.binding, kind)
        })
        .collect()
}
