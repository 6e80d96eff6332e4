// The recommended sampler: the linear pixel order. As `bluedither::Sampler`.

struct bd_Sampler {
    seed: u32,
    // Where the order begins among the constants.
    order: u32,
    // Bits of a sample's number that a pixel may flip.
    flips_rev: u32,
}

// Progressive: the sequence goes on for as long as it is asked.
fn bd_sampler_new(seed: u32) -> bd_Sampler {
    return bd_Sampler(seed, 9u * BD_LINEAR_ORDER, 0u);
}

// `spp` samples per pixel: powers of two up to 256; other numbers are drawn as by bd_sampler_new.
fn bd_sampler_with_spp(seed: u32, spp: u32) -> bd_Sampler {
    let count = max(spp, 1u);
    if count > 256u || (count & (count - 1u)) != 0u {
        return bd_sampler_new(seed);
    }
    return bd_Sampler(seed, countTrailingZeros(count) * BD_LINEAR_ORDER, reverseBits(count - 1u));
}

struct bd_SamplerPixel {
    order: u32,
    flips_rev: u32,
    // Of the frame.
    seed: vec2<u32>,
    // A hash of the pixel.
    own: u32,
    place: vec2<u32>,
}

// The samples of one pixel in one frame.
fn bd_sampler_pixel(seeded: bd_Sampler, x: u32, y: u32, frame: u32) -> bd_SamplerPixel {
    let seed = bd_hash_mix_64(vec2<u32>(frame, seeded.seed));
    let own = bd_hash_mix((seed.x + x) ^ ((y << 16u) | (y >> 16u)));
    return bd_SamplerPixel(seeded.order, seeded.flips_rev, seed, own, vec2<u32>(x, y));
}

// The pair of a domain at an index, 0.32 fixed point.
fn bd_sampler_pair(pixel: bd_SamplerPixel, domain: u32, pad: u32, index: u32) -> vec2<u32> {
    // Every domain lies elsewhere on one plane of 2^32 pixels a side.
    let far = bd_domain_word(pixel.seed, domain, pad);
    let there = pixel.place + vec2<u32>(far.y, (far.x << 5u) | (far.x >> 27u));
    // What all pixels of a block have: a set of columns, transposed or not, numbers swapped or not, a digital shift.
    let shift = bd_hash_mix_64(pixel.seed ^ (there >> vec2<u32>(5u)));
    let choice = shift.y;
    let columns = pixel.order + (choice & 7u) * BD_LINEAR_SET;
    let place = select(there, there.yx, ((choice >> 3u) & 1u) == 1u);
    let digits = bd_linear_digits(columns, place.x, place.y);
    let key = shift ^ vec2<u32>(digits << 16u, digits & 0xffff0000u);
    // The order of its samples.
    let random = bd_wide_mul(vec2<u32>(choice ^ pixel.own, 0u), vec2<u32>(0x7f4a7c15u, 0x9e3779b9u));
    let index_rev = bd_hash_shuffle_rev(reverseBits(index), random.y) ^ (random.x & pixel.flips_rev);
    let point = bd_linear_packed_rev(index_rev) ^ key;
    return select(point.yx, point, ((choice >> 4u) & 1u) == 1u);
}

// A single dimension: the first of a pair.
fn bd_sampler_single(pixel: bd_SamplerPixel, domain: u32, pad: u32, index: u32) -> u32 {
    return bd_sampler_pair(pixel, domain, pad, index).x;
}
