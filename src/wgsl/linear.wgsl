// The linear pixel order: one digital net for the whole picture. As `bluedither::linear`; its constants come word by
// word from a function that you write, or take with `shader::LINEAR_ORDER`:
//     fn bd_linear_order_load(i: u32) -> u32
// Ten orders of eight sets of ten columns: for 1, 2, 4, ..., 256 samples and for any number. Then the sequence, two
// words (low, high) a number: the sums for two nibbles of an index, and 24 columns.

const BD_LINEAR_SET = 10u;
const BD_LINEAR_ORDER = 80u;
const BD_LINEAR_NIBBLES = 800u;
const BD_LINEAR_COLUMNS = 864u;

fn bd_linear_long(i: u32) -> vec2<u32> {
    return vec2<u32>(bd_linear_order_load(i), bd_linear_order_load(i + 1u));
}

// Point of a bit-reversed index, both numbers in one word, the first in the upper half.
fn bd_linear_packed_rev(index_rev: u32) -> vec2<u32> {
    return bd_linear_first_rev(index_rev) ^ bd_linear_later_rev(index_rev);
}

// What the lower eight bits of an index add to it.
fn bd_linear_first_rev(index_rev: u32) -> vec2<u32> {
    let sum = bd_linear_long(BD_LINEAR_NIBBLES + 2u * (index_rev >> 28u));
    return sum ^ bd_linear_long(BD_LINEAR_NIBBLES + 32u + 2u * ((index_rev >> 24u) & 15u));
}

// And the other bits.
fn bd_linear_later_rev(index_rev: u32) -> vec2<u32> {
    var sum = vec2<u32>();
    for (var rest = index_rev & 0xffffffu; rest != 0u; rest &= rest - 1u) {
        sum ^= bd_linear_long(BD_LINEAR_COLUMNS + 2u * (23u - countTrailingZeros(rest)));
    }
    return sum;
}

// The same of an index that is not reversed.
fn bd_linear_packed(index: u32) -> vec2<u32> {
    return bd_linear_packed_rev(reverseBits(index));
}

// The digits that a pixel at (x, y) in its block of 32x32 adds to all its points, by the set of columns that begins at
// word `columns`: the upper 16 of the first number in the upper half, of the second in the lower half.
fn bd_linear_digits(columns: u32, x: u32, y: u32) -> u32 {
    var sum = 0u;
    for (var bit = 0u; bit < 5u; bit++) {
        sum ^= bd_linear_order_load(columns + 2u * bit) & (0u - ((x >> bit) & 1u));
        sum ^= bd_linear_order_load(columns + 2u * bit + 1u) & (0u - ((y >> bit) & 1u));
    }
    return sum;
}
