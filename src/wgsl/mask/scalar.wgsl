// A mask of one number a pixel, as `bluedither::ScalarMask`. Its size and its ranks come from what you write, or take
// with `shader::SCALAR_MASK`:
//     const BD_SCALAR_LOG2 = 6u; // of 64x64 pixels
//     fn bd_scalar_load(x: u32, y: u32) -> u32 // of x and y inside the mask

// The rank at a pixel; an i32 coordinate is passed as u32(..).
fn bd_scalar_rank(x: u32, y: u32) -> u32 {
    let inside = (1u << BD_SCALAR_LOG2) - 1u;
    return bd_scalar_load(x & inside, y & inside);
}

// The value at a pixel in 0.32 fixed point.
fn bd_scalar_value_fx(x: u32, y: u32) -> u32 {
    return bd_mask_value_fx(bd_scalar_rank(x, y), BD_SCALAR_LOG2);
}

// The value at a pixel, in (0, 1).
fn bd_scalar_value(x: u32, y: u32) -> f32 {
    return bd_unit_to_f32(bd_scalar_value_fx(x, y));
}
