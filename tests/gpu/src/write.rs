//! Shaders on disk, for the compilers of others.

use std::path::Path;

use bluedither::shader;

use crate::case::{self, Case};
use crate::cases;
use crate::device::Way;
use crate::pass;
use crate::translate::{Language, translate};

/// Writes, for every set of parts that cases use, a shader that calls all of them, and the bare functions, in every
/// language. All of it has passed naga then.
pub fn write(directory: &Path) -> Result<(), String> {
    std::fs::create_dir_all(directory).map_err(|error| format!("{} cannot be made ({error})", directory.display()))?;
    let mut count = 0;
    for (name, text) in shaders() {
        put(directory, &name, "wgsl", text.as_bytes())?;
        for language in Language::ALL {
            let one_entry = matches!(language, Language::Glsl | Language::GlslEs);
            for (entry, file) in entries(&name, one_entry) {
                let translated = translate(&text, language, entry).map_err(|error| format!("{name}: {error}"))?;
                put(directory, &file, language.extension(), &translated)?;
            }
        }
        count += 1;
    }
    println!("{count} shaders in {} languages in {}", Language::ALL.len() + 1, directory.display());
    Ok(())
}

/// Names and texts, each by storage buffers and by textures.
fn shaders() -> Vec<(String, String)> {
    let cases = cases::all();
    let mut sets: Vec<shader::Parts> = Vec::new();
    for case in &cases {
        if !sets.contains(&case.parts) {
            sets.push(case.parts);
        }
    }
    let mut shaders = Vec::new();
    for way in [Way::Storage, Way::Texture] {
        for &parts in &sets {
            let of_set: Vec<&Case> = cases.iter().filter(|case| case.parts == parts).collect();
            if way == Way::Texture && of_set.iter().all(|case| case.tables.is_empty()) {
                continue; // the same as by storage
            }
            // The last of its parts is what the others are there for.
            let name = parts.names().last().unwrap_or_default().replace('/', "_");
            shaders.push((format!("{name}_{way:?}").to_lowercase(), case::all_in_one(parts, &of_set, way)));
        }
        shaders.push((format!("frames_seeds_pass_{way:?}").to_lowercase(), pass::shader(way).1));
        let all: Vec<&Case> = cases.iter().collect();
        shaders.push((format!("all_{way:?}").to_lowercase(), case::all_in_one(shader::ALL, &all, way)));
    }
    shaders
}

/// Entry points that a language takes at once, the first standing for all, and names of files.
fn entries(name: &str, one_entry: bool) -> Vec<(&'static str, String)> {
    match (name.contains("_pass_"), one_entry) {
        (true, true) => pass::ENTRIES.map(|entry| (entry, format!("{name}.{entry}"))).into(),
        (true, false) => vec![(pass::ENTRIES[0], name.to_string())],
        _ => vec![("main", name.to_string())],
    }
}

fn put(directory: &Path, name: &str, extension: &str, bytes: &[u8]) -> Result<(), String> {
    let path = directory.join(format!("{name}.{extension}"));
    std::fs::write(&path, bytes).map_err(|error| format!("{} cannot be written ({error})", path.display()))
}
