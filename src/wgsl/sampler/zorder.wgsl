// Ahmed and Wonka 2020: one sequence for the image, dealt to the pixels along a shuffled Z curve. As
// `bluedither::ZOrder`.

struct bd_ZOrder {
    seed: u32,
}

// Progressive: the sequence goes on for as long as it is asked.
fn bd_z_order_new(seed: u32) -> bd_ZOrder {
    return bd_ZOrder(seed);
}

// The same; `spp` makes no difference.
fn bd_z_order_with_spp(seed: u32, spp: u32) -> bd_ZOrder {
    return bd_ZOrder(seed);
}

struct bd_ZOrderPixel {
    // Of a square of 65536x65536 pixels.
    seed: vec2<u32>,
    // Place on the curve, bit-reversed.
    place_rev: u32,
}

// The samples of one pixel in one frame.
fn bd_z_order_pixel(seeded: bd_ZOrder, x: u32, y: u32, frame: u32) -> bd_ZOrderPixel {
    let block = (x >> 16u) | (y & 0xffff0000u);
    let own = bd_wide_mul(vec2<u32>(block, 0u), vec2<u32>(0x7f4a7c15u, 0x9e3779b9u));
    let seed = bd_hash_mix_64(vec2<u32>(frame, seeded.seed)) ^ own;
    return bd_ZOrderPixel(seed, bd_hash_laine_karras_4(reverseBits(bd_zorder_morton_16(x, y)), seed.x));
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_z_order_pair(pixel: bd_ZOrderPixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    let shift = bd_domain_word(pixel.seed, domain, pad);
    let place_rev = bd_hash_laine_karras(pixel.place_rev, (shift.x >> 16u) | (shift.y << 16u));
    let place = bd_hash_shuffle(index, bd_hash_other(place_rev)) ^ bd_zorder_first_index(place_rev);
    return bd_zorder_point(place) ^ shift.yx;
}

// Sample `index` for purpose `domain`: 1 to 4 numbers, 0.32 fixed point or floats in [0, 1).
fn bd_z_order_draw1_fx(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> u32 {
    return bd_z_order_pair(pixel, domain, 0u, index).x;
}

fn bd_z_order_draw2_fx(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> vec2<u32> {
    return bd_z_order_pair(pixel, domain, 0u, index);
}

fn bd_z_order_draw3_fx(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> vec3<u32> {
    return vec3<u32>(bd_z_order_pair(pixel, domain, 0u, index), bd_z_order_pair(pixel, domain, 1u, index).x);
}

fn bd_z_order_draw4_fx(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> vec4<u32> {
    return vec4<u32>(bd_z_order_pair(pixel, domain, 0u, index), bd_z_order_pair(pixel, domain, 1u, index));
}

fn bd_z_order_draw1(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> f32 {
    return bd_unit_to_f32(bd_z_order_draw1_fx(pixel, domain, index));
}

fn bd_z_order_draw2(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_z_order_draw2_fx(pixel, domain, index));
}

fn bd_z_order_draw3(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> vec3<f32> {
    return bd_unit_to_f32s3(bd_z_order_draw3_fx(pixel, domain, index));
}

fn bd_z_order_draw4(pixel: bd_ZOrderPixel, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(bd_z_order_draw4_fx(pixel, domain, index));
}
