// Masks over time, as `bluedither::frames::masks`. Their size, their number and their ranks, one mask below the other,
// come from what you write, or take with `shader::TIME_MASK`:
//     const BD_OVER_TIME_LOG2 = 5u; // of 32x32 pixels
//     const BD_OVER_TIME_FRAMES = 32u;
//     fn bd_over_time_load(x: u32, y: u32) -> u32 // y = frame * 32 + the row in it

// The rank at a pixel in a frame; after the last frame the first comes again.
fn bd_over_time_rank(frame: u32, x: u32, y: u32) -> u32 {
    let inside = (1u << BD_OVER_TIME_LOG2) - 1u;
    let first = (frame & (BD_OVER_TIME_FRAMES - 1u)) << BD_OVER_TIME_LOG2;
    return bd_over_time_load(x & inside, first | (y & inside));
}

// The value at a pixel in a frame, 0.32 fixed point.
fn bd_over_time_value_fx(frame: u32, x: u32, y: u32) -> u32 {
    return bd_mask_value_fx(bd_over_time_rank(frame, x, y), BD_OVER_TIME_LOG2);
}

// The value at a pixel in a frame, in (0, 1).
fn bd_over_time_value(frame: u32, x: u32, y: u32) -> f32 {
    return bd_unit_to_f32(bd_over_time_value_fx(frame, x, y));
}
