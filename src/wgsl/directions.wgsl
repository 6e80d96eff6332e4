// Higher dimensions of the Sobol sequence, as `bluedither::sobol::Directions`. Their number and their direction numbers
// come from what you write, or take with `shader::DIRECTION_NUMBERS`:
//     const BD_DIRECTIONS_COUNT = 16u; // dimensions
//     fn bd_directions_load(dimension: u32, bit: u32) -> u32

// Point `index` of dimension `dimension` modulo the number of them: 0.32 fixed point.
fn bd_directions_dimension(index: u32, dimension: u32) -> u32 {
    let row = dimension % BD_DIRECTIONS_COUNT;
    var sum = 0u;
    for (var rest = index; rest != 0u; rest &= rest - 1u) {
        sum ^= bd_directions_load(row, countTrailingZeros(rest));
    }
    return sum;
}

// The same, Owen-scrambled; dimensions beyond the table are padded.
fn bd_directions_owen(index: u32, dimension: u32, seed: u32) -> u32 {
    let round = dimension / BD_DIRECTIONS_COUNT;
    var order = index;
    if round != 0u {
        order = bd_hash_shuffle(index, bd_hash_combine(seed, round));
    }
    let scramble = bd_hash_combine(seed, bd_hash_mix(dimension));
    return bd_hash_owen(bd_directions_dimension(order, dimension), scramble);
}
