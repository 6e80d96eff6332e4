// Cranley-Patterson offsets: one point set for the image, moved in every pixel by that pixel's mask value. As
// `bluedither::shift`. All numbers are 0.32 fixed point.

// Global offset: every component moves by the mask value, modulo 1.
fn bd_shift_global1(point: u32, offset: u32) -> u32 {
    return point + offset;
}

fn bd_shift_global2(point: vec2<u32>, offset: vec2<u32>) -> vec2<u32> {
    return point + offset;
}

fn bd_shift_global3(point: vec3<u32>, offset: vec3<u32>) -> vec3<u32> {
    return point + offset;
}

fn bd_shift_global4(point: vec4<u32>, offset: vec4<u32>) -> vec4<u32> {
    return point + offset;
}

// Stratified offset: wraps inside the cell only.
fn bd_shift_stratified_1d(cell: u32, count: u32, local: u32, offset: u32) -> u32 {
    return bd_strata_place_1d(cell, count, local + offset);
}

fn bd_shift_stratified_2d(cell: u32, count: u32, local: vec2<u32>, offset: vec2<u32>) -> vec2<u32> {
    return bd_strata_place_2d(cell, count, local + offset);
}
