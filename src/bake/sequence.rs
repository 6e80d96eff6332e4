//! The constants of the sequence of keys, frozen in `tables/sequence.txt`: read here.

use std::path::Path;

use super::digest::digest;
use super::record::read_text;

/// What the file holds: digits of both numbers for every bit of an index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns(pub [[u32; 2]; 32]);

const NAME: &str = "sequence";

/// What stands above the words.
const HEAD: &str = "\
# The (0,2)-sequence of Keyed (src/sequence.rs): two words of 32 bits in hexadecimal for every bit of a sample's number, the
# digits that it flips in the first and in the second number. The seal is the FNV-1a digest of all words.
# Sobol's with scrambled digits (Matousek 1998), chosen by simulated annealing for little power in the dual nets of all
# prefixes, over half-planes and smooth integrands. Frozen: the search found it together with an order of pixels that is no
# more, and cannot be run for it alone. It is in the git history, src/bake/columns until the commit that began this file.
";

impl Columns {
    /// Reads and checks the file. The error is one line with cause and cure.
    pub fn read(tables: &Path) -> Result<Self, String> {
        let text = read_text(tables, NAME)?;
        Self::parse(&text).ok_or_else(|| format!("tables/{NAME}.txt is damaged: restore it from the package"))
    }

    /// The file's contents, if nothing is amiss.
    pub fn parse(text: &str) -> Option<Self> {
        let (mut columns, mut seal) = (Vec::new(), None);
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            if let Some(word) = line.strip_prefix("seal ") {
                seal = u64::from_str_radix(word, 16).ok();
                continue;
            }
            let words: Result<Vec<u32>, _> =
                line.split_whitespace().map(|word| u32::from_str_radix(word, 16)).collect();
            columns.push(<[u32; 2]>::try_from(words.ok()?).ok()?);
        }
        let columns = Self(columns.try_into().ok()?);
        (seal == Some(columns.seal())).then_some(columns)
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let lines: String = self.0.iter().map(|[first, second]| format!("{first:08x} {second:08x}\n")).collect();
        format!("{HEAD}{lines}seal {:016x}\n", self.seal())
    }

    /// Digest of all words.
    pub fn seal(&self) -> u64 {
        digest(self.0.as_flattened().iter().map(|&word| i64::from(word)))
    }

    /// The `static` that the library includes.
    pub fn embed(&self) -> String {
        format!(
            "/// The sequence of [`Keyed`](crate::Keyed).\n\
             pub static SEQUENCE: crate::sequence::Sequence = crate::sequence::Sequence::new(&{:?});\n",
            self.0
        )
    }
}
