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

// A single dimension: the first of a pair.
fn bd_white_single(pixel: bd_WhitePixel, domain: u32, pad: u32, index: u32) -> u32 {
    return bd_white_pair(pixel, domain, pad, index).x;
}
