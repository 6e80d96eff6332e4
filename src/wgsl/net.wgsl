// The joint net: columns of one digital net for the whole picture. As `bluedither::net`; its constants come column by
// column, four words each, from a function that you write, or take with `shader::NET`:
//     fn bd_net_load(i: u32) -> vec4<u32>
// Nine orders of 26 columns: for 1, 2, 4, ..., 64 and 256 samples and for any number, each for the 16 bits of a
// sample's number, the 4 of the place inside a block and the 6 of the place on the curve. Then 15 columns for frames.

// In columns: an order, and where its parts begin; where those of frames begin, and how many there are.
const BD_NET_ORDER = 26u;
const BD_NET_INSIDE = 16u;
const BD_NET_PLACE = 20u;
const BD_NET_FRAMES = 234u;
const BD_NET_FRAME_BITS = 15u;

// The sum modulo 2 of two sets of digits.
fn bd_net_add(a: vec4<u32>, b: vec4<u32>) -> vec4<u32> {
    return a ^ b;
}

// The column i where bit k of `bits` is set, and else none: without a branch, since pixels differ.
fn bd_net_term(i: u32, bits: u32, k: u32) -> vec4<u32> {
    return bd_net_load(i) & vec4<u32>(bitcast<u32>(extractBits(bitcast<i32>(bits), k, 1u)));
}

// `sum` and two columns from i on, for bits k and k+1.
fn bd_net_add_two(sum: vec4<u32>, i: u32, bits: u32, k: u32) -> vec4<u32> {
    return sum ^ bd_net_term(i, bits, k) ^ bd_net_term(i + 1u, bits, k + 1u);
}

// `sum` and four columns from i on, for bits k to k+3.
fn bd_net_add_four(sum: vec4<u32>, i: u32, bits: u32, k: u32) -> vec4<u32> {
    return bd_net_add_two(bd_net_add_two(sum, i, bits, k), i + 2u, bits, k + 2u);
}

// `sum` and the columns from i on of all bits that are set in `bits`: for bits that all pixels have in common.
fn bd_net_add_columns(sum: vec4<u32>, i: u32, bits: u32) -> vec4<u32> {
    var all = sum;
    for (var rest = bits; rest != 0u; rest &= rest - 1u) {
        all ^= bd_net_load(i + countTrailingZeros(rest));
    }
    return all;
}
