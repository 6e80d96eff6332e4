// Belcour and Heitz 2021: one rank-1 lattice for the image, one shift a pixel from a blue-noise mask. As
// `bluedither::Rank1`. The mask's size and its ranks come from what you write, or take with `shader::LATTICE_MASK`:
//     const BD_RANK1_LOG2 = 6u; // of 64x64 pixels
//     fn bd_rank1_load(x: u32, y: u32) -> vec2<u32> // of x and y inside the mask

struct bd_Rank1 {
    seed: u32,
}

// Samples per pixel unknown: the sequence goes on for as long as it is asked.
fn bd_rank1_new(seed: u32) -> bd_Rank1 {
    return bd_Rank1(seed);
}

// The same; `spp` makes no difference.
fn bd_rank1_with_spp(seed: u32, spp: u32) -> bd_Rank1 {
    return bd_Rank1(seed);
}

struct bd_Rank1Pixel {
    seed: u32,
    place: vec2<u32>,
    frame: u32,
}

// The samples of one pixel in one frame.
fn bd_rank1_pixel(seeded: bd_Rank1, x: u32, y: u32, frame: u32) -> bd_Rank1Pixel {
    return bd_Rank1Pixel(seeded.seed, vec2<u32>(x, y), frame);
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_rank1_pair(pixel: bd_Rank1Pixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    let offset = bd_torus_offset(pixel.seed, domain, pad, pixel.frame, BD_RANK1_LOG2);
    let place = (pixel.place + offset) & vec2<u32>((1u << BD_RANK1_LOG2) - 1u);
    let shift = bd_mask_values_fx(bd_rank1_load(place.x, place.y), BD_RANK1_LOG2);
    let order = bd_hash_combine(bd_domain_seed(pixel.seed, domain, pad), pixel.frame);
    let phi = bd_hash_shuffle_rev(reverseBits(index), order);
    return phi * vec2<u32>(1u, 364981u) + shift; // lattice::EXEW
}

// Sample `index` for purpose `domain`: 1 to 4 numbers, 0.32 fixed point or floats in [0, 1).
fn bd_rank1_draw1_fx(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> u32 {
    return bd_rank1_pair(pixel, domain, 0u, index).x;
}

fn bd_rank1_draw2_fx(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> vec2<u32> {
    return bd_rank1_pair(pixel, domain, 0u, index);
}

fn bd_rank1_draw3_fx(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> vec3<u32> {
    return vec3<u32>(bd_rank1_pair(pixel, domain, 0u, index), bd_rank1_pair(pixel, domain, 1u, index).x);
}

fn bd_rank1_draw4_fx(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> vec4<u32> {
    return vec4<u32>(bd_rank1_pair(pixel, domain, 0u, index), bd_rank1_pair(pixel, domain, 1u, index));
}

fn bd_rank1_draw1(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> f32 {
    return bd_unit_to_f32(bd_rank1_draw1_fx(pixel, domain, index));
}

fn bd_rank1_draw2(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_rank1_draw2_fx(pixel, domain, index));
}

fn bd_rank1_draw3(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> vec3<f32> {
    return bd_unit_to_f32s3(bd_rank1_draw3_fx(pixel, domain, index));
}

fn bd_rank1_draw4(pixel: bd_Rank1Pixel, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(bd_rank1_draw4_fx(pixel, domain, index));
}
