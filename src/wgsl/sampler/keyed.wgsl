// Heitz and others 2019: one sequence for the image, scrambled by keys of every pixel. As `bluedither::Keyed`, with
// the tile that is bound.

struct bd_Keyed {
    seed: u32,
}

// Samples per pixel unknown: the sequence goes on for as long as it is asked.
fn bd_keyed_new(seed: u32) -> bd_Keyed {
    return bd_Keyed(seed);
}

// The same; `spp` makes no difference.
fn bd_keyed_with_spp(seed: u32, spp: u32) -> bd_Keyed {
    return bd_Keyed(seed);
}

struct bd_KeyedPixel {
    seed: u32,
    place: vec2<u32>,
    frame: u32,
}

// The samples of one pixel in one frame.
fn bd_keyed_pixel(seeded: bd_Keyed, x: u32, y: u32, frame: u32) -> bd_KeyedPixel {
    return bd_KeyedPixel(seeded.seed, vec2<u32>(x, y), frame);
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_keyed_pair(pixel: bd_KeyedPixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    let place = pixel.place + bd_torus_offset(pixel.seed, domain, pad, pixel.frame, BD_KEYS_LOG2);
    let seed = bd_hash_combine(bd_domain_seed(pixel.seed, domain, pad), pixel.frame);
    let key = bd_keys_key(place.x, place.y);
    // The pixel's own order; the lower digits are as random.
    let product = ((key.x | (key.y >> 16u)) ^ seed) * 0x9e3779b1u;
    let order = product ^ (product >> 15u);
    let index_rev = bd_hash_shuffle_rev(reverseBits(index), order);
    var point = bd_sequence_first_rev(index_rev);
    // The same for all pixels, whose orders take as many samples first.
    if index > 255u {
        point ^= bd_sequence_later_rev(index_rev);
    }
    return point.yx ^ key ^ vec2<u32>(order >> 16u, order & 0xffffu);
}

// A single dimension: the first of a pair.
fn bd_keyed_single(pixel: bd_KeyedPixel, domain: u32, pad: u32, index: u32) -> u32 {
    return bd_keyed_pair(pixel, domain, pad, index).x;
}
