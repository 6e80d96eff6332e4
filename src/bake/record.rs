//! `tables/digests.txt`: what every input and every baked table must come to.

use std::path::Path;

use super::digest::digest;

/// Lines of group, name and digest; the group is `input` or a level of effort.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Digests {
    /// In the order of the file.
    pub lines: Vec<(String, String, u64)>,
}

/// What stands above the digests.
const HEAD: &str = "\
# Digests (FNV-1a, 64 bits) of the inputs beside this file and of every table, by level of effort.
# After a recipe was changed on purpose, record them anew and note the change of values in CHANGELOG.md:
#     cargo test --release --no-default-features --test bake -- --ignored write_tables
";

impl Digests {
    /// Reads and checks the file. The error is one line with cause and cure.
    pub fn read(tables: &Path) -> Result<Self, String> {
        let text = read_text(tables, "digests")?;
        let mut digests = Self::default();
        let mut seal = None;
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words[..] {
                ["seal", word] => seal = u64::from_str_radix(word, 16).ok(),
                [group, name, word] => match u64::from_str_radix(word, 16) {
                    Ok(value) => digests.lines.push((group.into(), name.into(), value)),
                    Err(_) => return Err(Self::damaged()),
                },
                _ => return Err(Self::damaged()),
            }
        }
        if seal == Some(digests.seal()) { Ok(digests) } else { Err(Self::damaged()) }
    }

    /// The recorded digest, if there is one.
    pub fn get(&self, group: &str, name: &str) -> Option<u64> {
        let line = self.lines.iter().find(|line| line.0 == group && line.1 == name);
        line.map(|line| line.2)
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let lines: String =
            self.lines.iter().map(|(group, name, value)| format!("{group} {name} {value:016x}\n")).collect();
        format!("{HEAD}{lines}seal {:016x}\n", self.seal())
    }

    /// Digest of the digests: a line lost or altered is noticed.
    fn seal(&self) -> u64 {
        let numbers = self.lines.iter().flat_map(|(group, name, value)| {
            let text = group.bytes().chain([b' ']).chain(name.bytes()).map(i64::from);
            text.chain([value.cast_signed()])
        });
        digest(numbers)
    }

    fn damaged() -> String {
        "tables/digests.txt is damaged: restore it from the package, or record it anew (cargo test --release \
         --no-default-features --test bake -- --ignored write_tables)"
            .into()
    }
}

/// The text of `tables/NAME.txt`.
pub fn read_text(tables: &Path, name: &str) -> Result<String, String> {
    std::fs::read_to_string(tables.join(format!("{name}.txt")))
        .map_err(|error| format!("tables/{name}.txt cannot be read ({error}): restore it from the package"))
}
