//! The C99 header: `bluedither.h` beside this folder, with its places filled.

use crate::folder::version;
use crate::tables::{Kind, Table};
use bluedither::shader;
use bluedither::tables::EFFORT;

const TEMPLATE: &str = include_str!("../bluedither.h");

/// The text of the header with these tables.
pub fn header(tables: &[Table]) -> String {
    let mut licence = String::from("MIT OR Apache-2.0");
    if tables.iter().any(|table| table.kind == Kind::Directions) {
        licence = format!("({licence}) AND BSD-3-Clause");
    }
    let tables: String = tables.iter().map(table).collect();
    TEMPLATE
        .replace("@licence@", &licence)
        .replace("@version@", version())
        .replace("@effort@", EFFORT.name())
        .replace("@sequence@\n", &sequence())
        .replace("@net@\n", &net())
        .replace("@tables@\n", &tables)
}

/// Numbers and, beside them, the small value by which functions take them.
fn table(table: &Table) -> String {
    let (name, width, count) = (table.identifier(), table.width, table.numbers.len());
    let size_log2 = table.size_log2();
    let heading = |what: &str, bytes: usize| format!("/* {}: {what}, {bytes} bytes. */\n", table.name);
    let ranks = |what: &str, kind: &str, rest: &str| {
        heading(&format!("{what}, {width}x{width} pixels"), 2 * count)
            + &array("uint16_t", &format!("bd_{name}_ranks[{count}]"), &table.numbers)
            + &format!("static const {kind} bd_{name} = {{bd_{name}_ranks, {size_log2}{rest}}};\n\n")
    };
    match table.kind {
        Kind::Scalar => ranks("a mask of one channel", "bd_scalar_mask_t", ""),
        Kind::Vector => ranks("a mask of two channels", "bd_vector_mask_t", ""),
        Kind::Frames => {
            let frames = table.frames();
            let rest = format!(", {}", frames.trailing_zeros());
            ranks(&format!("masks for {frames} frames"), "bd_time_mask_t", &rest)
        }
        Kind::Keys => {
            let digits: Vec<u32> = table.numbers.chunks(2).map(|pixel| pixel[0] << 16 | pixel[1]).collect();
            heading(&format!("scrambling keys, {width}x{width} pixels"), 2 * count)
                + &array("uint32_t", &format!("bd_{name}_digits[{}]", digits.len()), &digits)
                + &format!("static const bd_keys_t bd_{name} = {{bd_{name}_digits, {size_log2}}};\n\n")
        }
        Kind::Directions => {
            let dimensions = table.rows();
            heading("direction numbers (Joe and Kuo 2008; BSD-3-Clause, see joe_kuo.LICENSE.txt)", 4 * count)
                + &format!("static const uint32_t bd_{name}_numbers[{dimensions}][32] = {{\n")
                + &rows(&table.numbers, 32)
                + "};\n"
                + &format!("static const bd_directions_t bd_{name} = {{bd_{name}_numbers, {dimensions}}};\n\n")
        }
        // For seeds in buffers of frames, which C has no functions for here.
        Kind::Codes => String::new(),
    }
}

/// Columns of every order, and those of frames.
fn net() -> String {
    let mut text = String::from(
        "/* What the bits add to eight numbers, of the number 2k in the upper half of word k, of 2k+1 in the lower: 16 bits\n \
         * of a sample's number, 4 of the place in a block of 4x4 pixels, 6 of the place on the curve. For each of 1, 2, 4,\n \
         * ..., 64 and 256 samples a pixel, and for any number. */\n\
         static const uint32_t bd_net_orders[9][26][4] = {\n",
    );
    let words: Vec<u32> = shader::net_words().collect();
    let (orders, frames) = words.split_at(9 * 26 * 4);
    for order in orders.chunks(26 * 4) {
        text += &format!("    {{\n{}    }},\n", rows(order, 4));
    }
    text += "};\n/* What the bits of a frame add, for any number of samples. */\n\
             static const uint32_t bd_net_frames[15][4] = {\n";
    text += &rows(frames, 4);
    text + "};\n"
}

/// The points of the sequence.
fn sequence() -> String {
    let words: Vec<u32> = shader::sequence_words().collect();
    // The first number is the upper half of a word of 64 bits, which comes second.
    let points: Vec<u32> = words.as_chunks::<2>().0.iter().flat_map(|&[low, high]| [high, low]).collect();
    let (nibbles, columns) = points.split_at(2 * 16 * 2);
    let mut text = String::from(
        "/* Points of the lower two nibbles of a sample's number, each reversed. */\n\
         static const uint32_t bd_sequence_nibbles[2][16][2] = {\n",
    );
    for nibble in nibbles.chunks(16 * 2) {
        text += &format!("    {{\n{}    }},\n", rows(nibble, 2));
    }
    text += "};\n/* What its other bits add. */\nstatic const uint32_t bd_sequence_columns[24][2] = {\n";
    text += &rows(columns, 2);
    text + "};\n"
}

/// `static const` numbers in one dimension.
fn array(kind: &str, declaration: &str, numbers: &[u32]) -> String {
    let mut text = format!("static const {kind} {declaration} = {{\n");
    for line in numbers.chunks(16) {
        text += &format!("    {},\n", joined(line));
    }
    text + "};\n"
}

/// Numbers in braces, `columns` in a row.
fn rows(numbers: &[u32], columns: usize) -> String {
    numbers.chunks(columns).map(|row| format!("        {{{}}},\n", joined(row))).collect()
}

/// With a suffix where a number is too large for an `int` of 16 bits.
fn joined(numbers: &[u32]) -> String {
    let text = |number: &u32| if *number > 0xffff { format!("0x{number:08x}u") } else { number.to_string() };
    numbers.iter().map(text).collect::<Vec<_>>().join(", ")
}
