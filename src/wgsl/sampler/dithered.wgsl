// Georgiev and Fajardo 2016: one pattern for the image, one offset a pixel from a blue-noise mask. As
// `bluedither::Dithered`, with the scalar and the vector mask that are bound, which have one size: for
// bd_dithered_lattice the vector mask of a lattice.

struct bd_Dithered {
    seed: u32,
    // Strata of single dimensions and of pairs; 0 moves the pattern as a whole.
    strata_1d: u32,
    strata_2d: u32,
    // Whether pairs that have no strata are a lattice, and not Sobol's.
    on_lattice: bool,
}

// Samples per pixel unknown: the sequence goes on for as long as it is asked, offset globally.
fn bd_dithered_new(seed: u32) -> bd_Dithered {
    return bd_Dithered(seed, 0u, 0u, false);
}

// `spp` samples per pixel: single dimensions stratified, pairs offset globally.
fn bd_dithered_with_spp(seed: u32, spp: u32) -> bd_Dithered {
    return bd_dithered_stratified_1d(bd_dithered_new(seed), spp);
}

// Pairs of a rank-1 lattice.
fn bd_dithered_lattice(seed: u32) -> bd_Dithered {
    return bd_dithered_on_lattice(bd_dithered_new(seed));
}

// Takes pairs that have no strata from a rank-1 lattice, in place of the Sobol sequence.
fn bd_dithered_on_lattice(seeded: bd_Dithered) -> bd_Dithered {
    return bd_Dithered(seeded.seed, seeded.strata_1d, seeded.strata_2d, true);
}

// Offsets the pattern as a whole, in every dimension.
fn bd_dithered_global(seeded: bd_Dithered) -> bd_Dithered {
    return bd_Dithered(seeded.seed, 0u, 0u, seeded.on_lattice);
}

// Offsets single dimensions inside the cells of `spp` strata, and pairs globally.
fn bd_dithered_stratified_1d(seeded: bd_Dithered, spp: u32) -> bd_Dithered {
    return bd_Dithered(seeded.seed, max(spp, 1u), 0u, seeded.on_lattice);
}

// Offsets single dimensions and pairs inside the cells of `spp` strata.
fn bd_dithered_stratified(seeded: bd_Dithered, spp: u32) -> bd_Dithered {
    return bd_Dithered(seeded.seed, max(spp, 1u), max(spp, 1u), seeded.on_lattice);
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
    let seed = bd_dithered_order(pixel, domain, pad);
    let offset = bd_scalar_value_fx(place.x, place.y) ^ bd_dithered_flips(bd_dithered_round_seed(pixel, domain, pad));
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
    let seed = bd_dithered_order(pixel, domain, pad);
    let other = bd_dithered_round_seed(pixel, domain, pad);
    // Upper digits of both or of none.
    let flip = bd_dithered_flips(other);
    let flips = vec2<u32>(flip, flip ^ (((other << 16u) | (other >> 16u)) >> 8u));
    let offset = bd_vector_value_fx(place.x, place.y) ^ flips;
    let strata = pixel.seeded.strata_2d;
    if strata == 0u {
        let first = bd_hash_shuffle_rev(reverseBits(index), seed);
        if pixel.seeded.on_lattice {
            return first * vec2<u32>(1u, 364981u) + offset; // lattice::EXEW
        }
        return bd_sobol_point(reverseBits(first)) + offset;
    }
    let cell = bd_dithered_cell(pixel, seed, strata, index);
    return bd_shift_stratified_2d(cell.y, strata, bd_sobol_point(cell.x), offset);
}

// How often there were as many frames as the mask has places.
fn bd_dithered_round(pixel: bd_DitheredPixel) -> u32 {
    return pixel.frame >> (2u * BD_SCALAR_LOG2);
}

// Where the mask is read. In every round places come in another order.
fn bd_dithered_place(pixel: bd_DitheredPixel, domain: u32, pad: u32) -> vec2<u32> {
    let seed = pixel.seeded.seed ^ (bd_dithered_round(pixel) * 0xb5297a4du);
    return pixel.place + bd_torus_offset(seed, domain, pad, pixel.frame, BD_SCALAR_LOG2);
}

// What tells the flips of a round: none in the first.
fn bd_dithered_round_seed(pixel: bd_DitheredPixel, domain: u32, pad: u32) -> u32 {
    let product = bd_dithered_round(pixel) * 0xb5297a4du;
    return bd_domain_seed(pixel.seeded.seed, domain, pad) * (product ^ (product >> 15u));
}

// Digits that a round flips in all values of a mask: all or none of the upper nine, and any below.
fn bd_dithered_flips(seed: u32) -> u32 {
    return bitcast<u32>(bitcast<i32>(seed) >> 8u);
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
