// The fully correlated control: the same samples in every pixel. As `bluedither::Constant`.

struct bd_Constant {
    points: bd_White,
}

// Progressive: the sequence goes on for as long as it is asked.
fn bd_constant_new(seed: u32) -> bd_Constant {
    return bd_Constant(bd_white_new(seed));
}

// The same; `spp` makes no difference.
fn bd_constant_with_spp(seed: u32, spp: u32) -> bd_Constant {
    return bd_constant_new(seed);
}

// The samples of every pixel in one frame: `x` and `y` make no difference.
fn bd_constant_pixel(seeded: bd_Constant, x: u32, y: u32, frame: u32) -> bd_WhitePixel {
    return bd_white_pixel(seeded.points, 0u, 0u, frame);
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_constant_pair(pixel: bd_WhitePixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    return bd_white_pair(pixel, domain, pad, index);
}

// Sample `index` for purpose `domain`: 1 to 4 numbers, 0.32 fixed point or floats in [0, 1).
fn bd_constant_draw1_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> u32 {
    return bd_constant_pair(pixel, domain, 0u, index).x;
}

fn bd_constant_draw2_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec2<u32> {
    return bd_constant_pair(pixel, domain, 0u, index);
}

fn bd_constant_draw3_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec3<u32> {
    return vec3<u32>(bd_constant_pair(pixel, domain, 0u, index), bd_constant_pair(pixel, domain, 1u, index).x);
}

fn bd_constant_draw4_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec4<u32> {
    return vec4<u32>(bd_constant_pair(pixel, domain, 0u, index), bd_constant_pair(pixel, domain, 1u, index));
}

fn bd_constant_draw1(pixel: bd_WhitePixel, domain: u32, index: u32) -> f32 {
    return bd_unit_to_f32(bd_constant_draw1_fx(pixel, domain, index));
}

fn bd_constant_draw2(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_constant_draw2_fx(pixel, domain, index));
}

fn bd_constant_draw3(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec3<f32> {
    return bd_unit_to_f32s3(bd_constant_draw3_fx(pixel, domain, index));
}

fn bd_constant_draw4(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(bd_constant_draw4_fx(pixel, domain, index));
}
