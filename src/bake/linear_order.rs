//! The constants of the linear pixel order, frozen in `tables/linear_order.txt`: read here, found by `columns`.

use core::fmt::Write as _;
use std::path::Path;

use super::digest::digest;
use super::record::read_text;
use crate::linear::{Columns, ORDERS, Order, SETS};

/// What the file holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinearOrder {
    /// Digits of both numbers for every bit of an index.
    pub sequence: [[u32; 2]; 32],
    /// Known numbers of samples 1, 2, 4, …, 256, then any number.
    pub orders: [Order; ORDERS],
}

const NAME: &str = "linear_order";

/// What stands above the words.
const HEAD: &str = "\
# The linear pixel order (src/linear.rs), found by src/bake/columns: words of 32 bits in hexadecimal.
# First two words for every bit of a sample's number: the digits that it flips in the first and the second number.
# Then, for 1, 2, 4, ..., 256 samples and for any number, sets of columns, a line each: the digits that the bits of x and
# of y flip, in turn, the first number's in the upper half. The seal is the FNV-1a digest of all words.
# After the search was changed on purpose, find them anew and note the change of values in CHANGELOG.md:
#     cargo test --release --test bake -- --ignored write_linear_order
";

impl LinearOrder {
    /// Reads and checks the file. The error is one line with cause and cure.
    pub fn read(tables: &Path) -> Result<Self, String> {
        let text = read_text(tables, NAME)?;
        Self::parse(&text).ok_or_else(|| format!("tables/{NAME}.txt is damaged: restore it from the package"))
    }

    /// The file's contents, if nothing is amiss.
    pub fn parse(text: &str) -> Option<Self> {
        let lines = text.lines().filter(|line| !line.starts_with('#'));
        let (mut words, mut seal) = (Vec::new(), None);
        for line in lines {
            if let Some(word) = line.strip_prefix("seal ") {
                seal = u64::from_str_radix(word, 16).ok();
                continue;
            }
            for word in line.split_whitespace() {
                words.push(u32::from_str_radix(word, 16).ok()?);
            }
        }
        let (sequence, rest) = words.split_at_checked(64)?;
        let mut sets = rest.chunks(size_of::<Columns>() / 4).map(Columns::try_from);
        let mut order = Self { sequence: [[0; 2]; 32], orders: [[[0; _]; SETS]; ORDERS] };
        for (to, from) in order.sequence.iter_mut().zip(sequence.chunks(2)) {
            *to = from.try_into().ok()?;
        }
        for to in order.orders.as_flattened_mut() {
            *to = sets.next()?.ok()?;
        }
        (sets.next().is_none() && seal == Some(order.seal())).then_some(order)
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let mut text = HEAD.to_string();
        let lines =
            self.sequence.iter().map(|pair| &pair[..]).chain(self.orders.as_flattened().iter().map(|set| &set[..]));
        for line in lines {
            let words: Vec<String> = line.iter().map(|word| format!("{word:08x}")).collect();
            text += &(words.join(" ") + "\n");
        }
        text + &format!("seal {:016x}\n", self.seal())
    }

    /// Digest of all words.
    pub fn seal(&self) -> u64 {
        let words = self.sequence.as_flattened().iter().chain(self.orders.as_flattened().as_flattened());
        digest(words.map(|&word| i64::from(word)))
    }

    /// The `static` that the library includes.
    pub fn embed(&self) -> String {
        let mut text = String::from(
            "/// The constants of the linear pixel order, for every number of samples.\n\
             pub static LINEAR_ORDER: crate::linear::Tables = crate::linear::Tables {\n",
        );
        let (progressive, known) = self.orders.split_last().expect("there are orders");
        let wrote = write!(
            text,
            "known: {known:?},\nprogressive: {progressive:?},\nsequence: crate::linear::Sequence::new(&{:?}),\n}};\n",
            self.sequence
        );
        wrote.expect("a String grows");
        text
    }
}
