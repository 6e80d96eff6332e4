// Masks: square tiles of ranks, looked up toroidally. As `bluedither::mask`.

// The 0.32 value of a rank in a mask of 2^size_log2 squared pixels: the centre of its cell.
fn bd_mask_value_fx(rank: u32, size_log2: u32) -> u32 {
    return (2u * rank + 1u) << (31u - 2u * size_log2);
}

fn bd_mask_values_fx(ranks: vec2<u32>, size_log2: u32) -> vec2<u32> {
    return (2u * ranks + vec2<u32>(1u)) << vec2<u32>(31u - 2u * size_log2);
}
