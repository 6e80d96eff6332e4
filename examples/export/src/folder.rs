//! The folder that is written, and the manifest of what is in it.

use crate::tables::Table;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

const MANIFEST: &str = "manifest.json";

/// A folder, and what has been written to it.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    files: Vec<File>,
}

#[derive(Debug)]
struct File {
    name: String,
    format: String,
    bytes: usize,
    digest: u64,
}

impl Folder {
    pub fn create(path: &Path) -> Result<Self, String> {
        fs::create_dir_all(path).map_err(|error| refusal(path, &error))?;
        // What an earlier run has left does not speak for this one.
        let manifest = path.join(MANIFEST);
        if manifest.exists() {
            fs::remove_file(&manifest).map_err(|error| refusal(&manifest, &error))?;
        }
        Ok(Self { path: path.to_owned(), files: Vec::new() })
    }

    pub fn write(&mut self, name: &str, format: &str, bytes: &[u8]) -> Result<(), String> {
        let path = self.path.join(name);
        let written = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, bytes));
        written.map_err(|error| refusal(&path, &error))?;
        println!("{:>9} {name}: {format}", bytes.len());
        self.files.push(File { name: name.into(), format: format.into(), bytes: bytes.len(), digest: fnv_1a(bytes) });
        Ok(())
    }

    /// Writes the manifest last, so that its presence says that all is there.
    pub fn close(mut self, tables: &[Table]) -> Result<(), String> {
        let manifest = self.manifest(tables);
        let count = self.files.len();
        self.write(MANIFEST, "what was written, from what, with digests", manifest.as_bytes())?;
        let effort = bluedither::tables::EFFORT.name();
        let of = if tables.is_empty() { String::new() } else { format!(" of {} tables", tables.len()) };
        println!("{count} files{of}, baked at {effort} effort, in {}", self.path.display());
        Ok(())
    }

    /// JSON, a line for each table and each file. Names are our own: nothing needs an escape.
    fn manifest(&self, tables: &[Table]) -> String {
        let table = |table: &Table| {
            let (width, height, frames) = (table.width, table.rows() / table.frames(), table.frames());
            let digest = table.digest().map_or_else(|| "null".into(), |digest| format!("\"{digest:016x}\""));
            let name = table.name;
            format!(
                "{{ \"name\": \"{name}\", \"width\": {width}, \"height\": {height}, \"frames\": {frames}, \
                 \"channels\": {}, \"digest\": {digest} }}",
                table.channels()
            )
        };
        let file = |File { name, format, bytes, digest }: &File| {
            format!(
                "{{ \"file\": \"{name}\", \"format\": \"{format}\", \"bytes\": {bytes}, \"digest\": \"{digest:016x}\" }}"
            )
        };
        let mut text = String::from("{\n");
        let (version, effort, filter) = (version(), bluedither::tables::EFFORT.name(), filter());
        let wrote = write!(
            text,
            "  \"bluedither\": \"{version}\",\n  \"effort\": \"{effort}\",\n{filter}\
             \x20 \"digests\": \"FNV-1a, 64 bits: of files by bytes, of tables as in tables/digests.txt\",\n\
             \x20 \"tables\": {},\n  \"files\": {}\n}}\n",
            list(tables.iter().map(table)),
            list(self.files.iter().map(file)),
        );
        wrote.expect("a String grows");
        text
    }
}

/// A line on the filter that the filtered masks are for, where there are any.
fn filter() -> String {
    #[cfg(any(feature = "threshold-filtered-64", feature = "threshold-filtered-over-time-64"))]
    return format!("  \"filter\": \"{}\",\n", bluedither::tables::FILTER);
    #[cfg(not(any(feature = "threshold-filtered-64", feature = "threshold-filtered-over-time-64")))]
    String::new()
}

/// The library's version.
pub fn version() -> &'static str {
    let manifest = include_str!("../../../Cargo.toml");
    let line = manifest.lines().find_map(|line| line.strip_prefix("version = "));
    line.map_or("", |version| version.trim_matches('"'))
}

fn list(lines: impl Iterator<Item = String>) -> String {
    let lines: Vec<_> = lines.map(|line| format!("\n    {line}")).collect();
    format!("[{}\n  ]", lines.join(","))
}

/// FNV-1a, 64 bits (Fowler, Noll and Vo), of bytes.
fn fnv_1a(bytes: &[u8]) -> u64 {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

fn refusal(path: &Path, error: &std::io::Error) -> String {
    format!("{} cannot be written ({error}): choose another folder by --out", path.display())
}
