// A mask of two numbers a pixel, as `bluedither::VectorMask`. Its size and its ranks come from what you write, or take
// with `shader::VECTOR_MASK`:
//     const BD_VECTOR_LOG2 = 6u; // of 64x64 pixels
//     fn bd_vector_load(x: u32, y: u32) -> vec2<u32> // of x and y inside the mask

// The ranks at a pixel; an i32 coordinate is passed as u32(..).
fn bd_vector_rank(x: u32, y: u32) -> vec2<u32> {
    let inside = (1u << BD_VECTOR_LOG2) - 1u;
    return bd_vector_load(x & inside, y & inside);
}

// The values at a pixel in 0.32 fixed point.
fn bd_vector_value_fx(x: u32, y: u32) -> vec2<u32> {
    return bd_mask_values_fx(bd_vector_rank(x, y), BD_VECTOR_LOG2);
}

// The values at a pixel, each in (0, 1).
fn bd_vector_value(x: u32, y: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_vector_value_fx(x, y));
}
