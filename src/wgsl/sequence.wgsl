// The (0, 2)-sequence of `bluedither::Keyed`. As `bluedither::sequence`; its constants come word by word from a
// function that you write, or take with `shader::SEQUENCE`:
//     fn bd_sequence_load(i: u32) -> u32
// Two words (low, high) a number: the sums for two nibbles of an index, and 24 columns.

const BD_SEQUENCE_NIBBLES = 0u;
const BD_SEQUENCE_COLUMNS = 64u;

fn bd_sequence_long(i: u32) -> vec2<u32> {
    return vec2<u32>(bd_sequence_load(i), bd_sequence_load(i + 1u));
}

// Point of a bit-reversed index, both numbers in one word, the first in the upper half.
fn bd_sequence_packed_rev(index_rev: u32) -> vec2<u32> {
    return bd_sequence_first_rev(index_rev) ^ bd_sequence_later_rev(index_rev);
}

// What the lower eight bits of an index add to it.
fn bd_sequence_first_rev(index_rev: u32) -> vec2<u32> {
    let sum = bd_sequence_long(BD_SEQUENCE_NIBBLES + 2u * (index_rev >> 28u));
    return sum ^ bd_sequence_long(BD_SEQUENCE_NIBBLES + 32u + 2u * ((index_rev >> 24u) & 15u));
}

// And the other bits.
fn bd_sequence_later_rev(index_rev: u32) -> vec2<u32> {
    var sum = vec2<u32>();
    for (var rest = index_rev & 0xffffffu; rest != 0u; rest &= rest - 1u) {
        sum ^= bd_sequence_long(BD_SEQUENCE_COLUMNS + 2u * (23u - countTrailingZeros(rest)));
    }
    return sum;
}

// The same of an index that is not reversed.
fn bd_sequence_packed(index: u32) -> vec2<u32> {
    return bd_sequence_packed_rev(reverseBits(index));
}
