// Toroidal addressing: a tile repeats without a seam, and is read at a place that depends on seed, domain and frame. As
// `bluedither::torus`.

// A coordinate inside a tile of `size` pixels, a power of two.
fn bd_torus_wrap(coordinate: u32, size: u32) -> u32 {
    return coordinate & (size - 1u);
}

// How far from the pixel itself a tile of 2^size_log2 squared pixels is read: domains by the R2 sequence (M. Roberts
// 2018), the other steps by search.
fn bd_torus_offset(seed: u32, domain: u32, pad: u32, frame: u32, size_log2: u32) -> vec2<u32> {
    let start = bd_hash_mix(seed);
    var place = vec2<u32>(start, bd_hash_mix(start));
    place += domain * vec2<u32>(0xc13fa9a9u, 0x91e10da5u);
    place += frame * vec2<u32>(0x2780e141u, 0xbc218b0du);
    place += pad * vec2<u32>(0x70416dd8u, 0x247e9a23u);
    // The place in the tile is in the upper bits; a tile of one pixel has none.
    let bits = min(size_log2, 32u);
    return select((place >> vec2<u32>((32u - bits) & 31u)), vec2<u32>(0u), bits == 0u);
}
