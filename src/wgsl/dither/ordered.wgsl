// Ordered dither: Bayer's recursive matrix without a table. As `bluedither::dither::ordered`.

// The threshold at a pixel of a matrix of 2^size_log2 squared, at most 2^15, in 0.32 fixed point.
fn bd_ordered_value_fx(x: u32, y: u32, size_log2: u32) -> u32 {
    let half = 0x80000000u >> (2u * min(size_log2, 15u));
    return (reverseBits(bd_zorder_morton_16(x ^ y, y)) & (0u - (half << 1u))) | half;
}
