// What follows from the draws of a sampler in fixed point. NAME and TITLE are the sampler's.

// Sample `index` for purpose `domain`: 1 to 8 numbers in [0, 1).
fn bd_NAME_draw1(pixel: bd_TITLEPixel, domain: u32, index: u32) -> f32 {
    return bd_unit_to_f32(bd_NAME_draw1_fx(pixel, domain, index));
}

fn bd_NAME_draw2(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_NAME_draw2_fx(pixel, domain, index));
}

fn bd_NAME_draw3(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec3<f32> {
    return bd_unit_to_f32s3(bd_NAME_draw3_fx(pixel, domain, index));
}

fn bd_NAME_draw4(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(bd_NAME_draw4_fx(pixel, domain, index));
}

fn bd_NAME_draw5(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<f32, 5> {
    return bd_unit_to_f32s5(bd_NAME_draw5_fx(pixel, domain, index));
}

fn bd_NAME_draw6(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<f32, 6> {
    return bd_unit_to_f32s6(bd_NAME_draw6_fx(pixel, domain, index));
}

fn bd_NAME_draw7(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<f32, 7> {
    return bd_unit_to_f32s7(bd_NAME_draw7_fx(pixel, domain, index));
}

fn bd_NAME_draw8(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<f32, 8> {
    return bd_unit_to_f32s8(bd_NAME_draw8_fx(pixel, domain, index));
}
