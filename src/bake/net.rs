//! The constants of the joint net, frozen in `tables/net.txt`: read here.

use core::fmt::Write as _;
use std::path::Path;

use super::digest::digest;
use super::record::read_text;
use crate::net::{Digits, FRAMES, ORDERS, Order};

/// What the file holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Net {
    /// Known numbers of samples 1, 2, 4, …, 64, 256, then any number.
    pub orders: [Order; ORDERS],
    /// Frames where the number is not known.
    pub frames: [Digits; FRAMES],
}

const NAME: &str = "net";
/// Lines of an order: samples, inside, place.
const LINES: usize = size_of::<Order>() / size_of::<Digits>();

/// What stands above the words.
const HEAD: &str = "\
# The joint net (src/net.rs), found by tests/search: a line a column, 16 digits of eight numbers, two numbers a word in
# hexadecimal. For 1, 2, 4, 8, 16, 32, 64, 256 samples and for any number: columns of 16 bits of a sample's number, of
# bits 0 and 1 of x and of y, and of 6 bits of the place on the curve. Then columns of 15 bits of a frame. The seal is
# the FNV-1a digest of all words. Find them anew, and note the change of values in CHANGELOG.md:
#     cargo run --release -p search
";

impl Net {
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
            columns.push(Digits::try_from(words.ok()?).ok()?);
        }
        let (orders, frames) = columns.split_at_checked(ORDERS * LINES)?;
        let orders: Option<Vec<Order>> = orders.chunks(LINES).map(order).collect();
        let net = Self { orders: orders?.try_into().ok()?, frames: frames.try_into().ok()? };
        (seal == Some(net.seal())).then_some(net)
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        let mut text = HEAD.to_string();
        for column in self.columns() {
            let words: Vec<String> = column.iter().map(|word| format!("{word:08x}")).collect();
            text += &(words.join(" ") + "\n");
        }
        text + &format!("seal {:016x}\n", self.seal())
    }

    /// Digest of all words.
    pub fn seal(&self) -> u64 {
        digest(self.columns().flatten().map(i64::from))
    }

    fn columns(&self) -> impl Iterator<Item = Digits> + '_ {
        let of = |order: &Order| [&order.samples[..], &order.inside, &order.place].concat();
        self.orders.iter().flat_map(of).chain(self.frames)
    }

    /// The `static` that the library includes.
    pub fn embed(&self) -> String {
        let mut text = String::from(
            "/// The constants of the joint net, for every number of samples.\n\
             pub static NET: crate::net::Tables = {\nuse crate::net::{Order, Tables};\n",
        );
        let (progressive, known) = self.orders.split_last().expect("there are orders");
        let frames = self.frames;
        let wrote =
            writeln!(text, "Tables {{ known: {known:?}, progressive: {progressive:?}, frames: {frames:?} }} }};");
        wrote.expect("a String grows");
        text
    }
}

fn order(lines: &[Digits]) -> Option<Order> {
    let (samples, rest) = lines.split_first_chunk()?;
    let (inside, place) = rest.split_first_chunk()?;
    Some(Order { samples: *samples, inside: *inside, place: place.try_into().ok()? })
}
