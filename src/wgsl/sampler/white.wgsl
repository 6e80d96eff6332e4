// The uncorrelated control: Owen-scrambled Sobol points under a seed of every pixel's own. As `bluedither::White`.

struct bd_White {
    seed: u32,
}

// Progressive: the sequence goes on for as long as it is asked.
fn bd_white_new(seed: u32) -> bd_White {
    return bd_White(seed);
}

// The same; `spp` makes no difference.
fn bd_white_with_spp(seed: u32, spp: u32) -> bd_White {
    return bd_White(seed);
}

struct bd_WhitePixel {
    seed: u32,
}

// The samples of one pixel in one frame.
fn bd_white_pixel(seeded: bd_White, x: u32, y: u32, frame: u32) -> bd_WhitePixel {
    let row = bd_hash_combine(bd_hash_combine(seeded.seed, frame), y);
    return bd_WhitePixel(bd_hash_combine(row, bd_hash_mix(x)));
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_white_pair(pixel: bd_WhitePixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    let seed = bd_domain_seed(pixel.seed, domain, pad);
    return bd_sobol_owen_point(bd_hash_shuffle(index, seed), seed);
}

// Sample `index` for purpose `domain`: 1 to 4 numbers, 0.32 fixed point or floats in [0, 1).
fn bd_white_draw1_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> u32 {
    return bd_white_pair(pixel, domain, 0u, index).x;
}

fn bd_white_draw2_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec2<u32> {
    return bd_white_pair(pixel, domain, 0u, index);
}

fn bd_white_draw3_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec3<u32> {
    return vec3<u32>(bd_white_pair(pixel, domain, 0u, index), bd_white_pair(pixel, domain, 1u, index).x);
}

fn bd_white_draw4_fx(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec4<u32> {
    return vec4<u32>(bd_white_pair(pixel, domain, 0u, index), bd_white_pair(pixel, domain, 1u, index));
}

fn bd_white_draw1(pixel: bd_WhitePixel, domain: u32, index: u32) -> f32 {
    return bd_unit_to_f32(bd_white_draw1_fx(pixel, domain, index));
}

fn bd_white_draw2(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_white_draw2_fx(pixel, domain, index));
}

fn bd_white_draw3(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec3<f32> {
    return bd_unit_to_f32s3(bd_white_draw3_fx(pixel, domain, index));
}

fn bd_white_draw4(pixel: bd_WhitePixel, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(bd_white_draw4_fx(pixel, domain, index));
}
