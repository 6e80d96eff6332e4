// Scrambling keys of a tile, as `bluedither::Keys`. Its size and its digits come from what you write, or take with
// `shader::KEYS_TILE`:
//     const BD_KEYS_LOG2 = 6u; // of 64x64 pixels
//     fn bd_keys_load(x: u32, y: u32) -> u32 // the first number's 16 digits in the upper half

// The keys of a pixel, 0.32 fixed point; the lower 16 digits are 0.
fn bd_keys_key(x: u32, y: u32) -> vec2<u32> {
    let inside = (1u << BD_KEYS_LOG2) - 1u;
    let digits = bd_keys_load(x & inside, y & inside);
    return vec2<u32>(digits & 0xffff0000u, digits << 16u);
}
