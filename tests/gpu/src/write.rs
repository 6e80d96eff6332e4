//! Shaders on disk, for the compilers of others. All of it has passed naga then.

use std::path::Path;

use bluedither::shader;

use crate::case::{self, Case};
use crate::cases;
use crate::device::Way;
use crate::pass;
use crate::translate::{Language, parse, translate};

/// A shader: its name, its text, its entry points.
type Shader = (String, String, &'static [&'static str]);

/// Writes, for every set of parts that cases use, a shader that calls all of them in WGSL; and one that calls all
/// functions, as the passes, in every language.
pub fn write(directory: &Path) -> Result<(), String> {
    std::fs::create_dir_all(directory).map_err(|error| format!("{} cannot be made ({error})", directory.display()))?;
    let (mut texts, mut translations) = (0, 0);
    for way in [Way::Storage, Way::Texture] {
        let ending = format!("{way:?}").to_lowercase();
        for (name, text, _) in sets(way) {
            parse(&text).map_err(|error| format!("{name}: {error}"))?;
            put(directory, &format!("{name}_{ending}.wgsl"), text.as_bytes())?;
            texts += 1;
        }
        for (name, text, entries) in wholes(way) {
            put(directory, &format!("{name}_{ending}.wgsl"), text.as_bytes())?;
            texts += 1;
            for language in Language::ALL {
                // All entry points go into one file, but in GLSL.
                let one = matches!(language, Language::Glsl | Language::GlslEs);
                for entry in &entries[..if one { entries.len() } else { 1 }] {
                    let translated = translate(&text, language, entry)
                        .map_err(|error| format!("{name} in {language:?}: {error}"))?;
                    put(directory, &format!("{name}_{ending}.{entry}.{}", language.extension()), &translated)?;
                    translations += 1;
                }
            }
        }
    }
    println!("{texts} shaders, {translations} translations in {}", directory.display());
    Ok(())
}

/// For every set of parts that cases use, named after the one that the others are there for.
fn sets(way: Way) -> Vec<Shader> {
    let cases = cases::all();
    let mut sets: Vec<shader::Parts> = Vec::new();
    for case in &cases {
        // Without a table both ways are the same.
        if !sets.contains(&case.parts) && (way == Way::Storage || !case.tables.is_empty()) {
            sets.push(case.parts);
        }
    }
    let shader = |parts: &shader::Parts| -> Shader {
        let of_set: Vec<&Case> = cases.iter().filter(|case| case.parts == *parts).collect();
        let name = parts.names().last().unwrap_or_default().replace('/', "_");
        (name, case::all_in_one(*parts, &of_set, way), &["main"])
    };
    sets.iter().map(shader).collect()
}

/// Everything, and the passes by themselves.
fn wholes(way: Way) -> [Shader; 2] {
    let cases = cases::all();
    let everything = case::all_in_one(shader::ALL, &cases.iter().collect::<Vec<_>>(), way);
    // Its entry points stand beside the functions.
    let all: Shader = ("all".to_string(), everything, &["main"]);
    [all, ("seeds_pass".to_string(), pass::shader(way).1, &pass::ENTRIES)]
}

fn put(directory: &Path, name: &str, bytes: &[u8]) -> Result<(), String> {
    let path = directory.join(name);
    std::fs::write(&path, bytes).map_err(|error| format!("{} cannot be written ({error})", path.display()))
}
