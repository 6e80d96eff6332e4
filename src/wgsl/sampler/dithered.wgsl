// Georgiev and Fajardo 2016: one pattern for the image, one offset a pixel from a blue-noise mask. As
// `bluedither::Dithered`, with the scalar and the vector mask that are bound, which have one size.

struct bd_Dithered {
    seed: u32,
    // Strata of single dimensions and of pairs; 0 moves the Sobol pattern as a whole.
    strata_1d: u32,
    strata_2d: u32,
}

// Samples per pixel unknown: the sequence goes on for as long as it is asked, offset globally.
fn bd_dithered_new(seed: u32) -> bd_Dithered {
    return bd_Dithered(seed, 0u, 0u);
}

// `spp` samples per pixel: single dimensions stratified, pairs offset globally.
fn bd_dithered_with_spp(seed: u32, spp: u32) -> bd_Dithered {
    return bd_dithered_stratified_1d(bd_dithered_new(seed), spp);
}

// Offsets the Sobol pattern as a whole, in every dimension.
fn bd_dithered_global(seeded: bd_Dithered) -> bd_Dithered {
    return bd_Dithered(seeded.seed, 0u, 0u);
}

// Offsets single dimensions inside the cells of `spp` strata, and pairs globally.
fn bd_dithered_stratified_1d(seeded: bd_Dithered, spp: u32) -> bd_Dithered {
    return bd_Dithered(seeded.seed, max(spp, 1u), 0u);
}

// Offsets single dimensions and pairs inside the cells of `spp` strata.
fn bd_dithered_stratified(seeded: bd_Dithered, spp: u32) -> bd_Dithered {
    return bd_Dithered(seeded.seed, max(spp, 1u), max(spp, 1u));
}

struct bd_DitheredPixel {
    seeded: bd_Dithered,
    place: vec2<u32>,
    frame: u32,
}

// The samples of one pixel in one frame.
fn bd_dithered_pixel(seeded: bd_Dithered, x: u32, y: u32, frame: u32) -> bd_DitheredPixel {
    return bd_DitheredPixel(seeded, vec2<u32>(x, y), frame);
}

// A single dimension of a domain at an index, 0.32 fixed point.
fn bd_dithered_single(pixel: bd_DitheredPixel, domain: u32, pad: u32, index: u32) -> u32 {
    let place = bd_dithered_place(pixel, domain, pad);
    let offset = bd_scalar_value_fx(place.x, place.y);
    let seed = bd_dithered_order(pixel, domain, pad);
    let strata = pixel.seeded.strata_1d;
    if strata == 0u {
        return bd_hash_shuffle_rev(reverseBits(index), seed) + offset;
    }
    let cell = bd_dithered_cell(pixel, seed, strata, index);
    return bd_shift_stratified_1d(cell.y, strata, bd_sobol_dimension_0(cell.x), offset);
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_dithered_pair(pixel: bd_DitheredPixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    let place = bd_dithered_place(pixel, domain, pad);
    let offset = bd_vector_value_fx(place.x, place.y);
    let seed = bd_dithered_order(pixel, domain, pad);
    let strata = pixel.seeded.strata_2d;
    if strata == 0u {
        return bd_sobol_point(bd_hash_shuffle(index, seed)) + offset;
    }
    let cell = bd_dithered_cell(pixel, seed, strata, index);
    return bd_shift_stratified_2d(cell.y, strata, bd_sobol_point(cell.x), offset);
}

// Where the mask is read.
fn bd_dithered_place(pixel: bd_DitheredPixel, domain: u32, pad: u32) -> vec2<u32> {
    return pixel.place + bd_torus_offset(pixel.seeded.seed, domain, pad, pixel.frame, BD_SCALAR_LOG2);
}

// The order in which all pixels visit the pattern.
fn bd_dithered_order(pixel: bd_DitheredPixel, domain: u32, pad: u32) -> u32 {
    return bd_hash_combine(bd_domain_seed(pixel.seeded.seed, domain, pad), pixel.frame);
}

// After as many samples as strata these are filled again: how often that was, and the cell now.
fn bd_dithered_cell(pixel: bd_DitheredPixel, seed: u32, strata: u32, index: u32) -> vec2<u32> {
    if strata == 1u {
        return vec2<u32>(bd_hash_shuffle(index, seed), 0u);
    }
    // Of 0 it is 0.
    let round = bd_hash_shuffle(index / strata, seed);
    let cell = bd_strata_permute(index % strata, strata, bd_hash_combine(seed, round));
    let turn = bd_hash_combine(seed, (pixel.place.x * 0x9e3779b1u) ^ (pixel.place.y * 0x85ebca77u));
    return vec2<u32>(round, bd_strata_turn(cell, strata, turn));
}

// Sample `index` for purpose `domain`: 1 to 4 numbers, 0.32 fixed point or floats in [0, 1).
fn bd_dithered_draw1_fx(pixel: bd_DitheredPixel, domain: u32, index: u32) -> u32 {
    return bd_dithered_single(pixel, domain, 0u, index);
}

fn bd_dithered_draw2_fx(pixel: bd_DitheredPixel, domain: u32, index: u32) -> vec2<u32> {
    return bd_dithered_pair(pixel, domain, 0u, index);
}

fn bd_dithered_draw3_fx(pixel: bd_DitheredPixel, domain: u32, index: u32) -> vec3<u32> {
    return vec3<u32>(bd_dithered_pair(pixel, domain, 0u, index), bd_dithered_single(pixel, domain, 1u, index));
}

fn bd_dithered_draw4_fx(pixel: bd_DitheredPixel, domain: u32, index: u32) -> vec4<u32> {
    return vec4<u32>(bd_dithered_pair(pixel, domain, 0u, index), bd_dithered_pair(pixel, domain, 1u, index));
}

fn bd_dithered_draw1(pixel: bd_DitheredPixel, domain: u32, index: u32) -> f32 {
    return bd_unit_to_f32(bd_dithered_draw1_fx(pixel, domain, index));
}

fn bd_dithered_draw2(pixel: bd_DitheredPixel, domain: u32, index: u32) -> vec2<f32> {
    return bd_unit_to_f32s2(bd_dithered_draw2_fx(pixel, domain, index));
}

fn bd_dithered_draw3(pixel: bd_DitheredPixel, domain: u32, index: u32) -> vec3<f32> {
    return bd_unit_to_f32s3(bd_dithered_draw3_fx(pixel, domain, index));
}

fn bd_dithered_draw4(pixel: bd_DitheredPixel, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(bd_dithered_draw4_fx(pixel, domain, index));
}
