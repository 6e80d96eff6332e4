// Seeds and scrambles: integer hashes that have no state and use no table. As `bluedither::hash`; u64 is
// vec2<u32>(low, high).

// A bijection in which every input bit flips every output bit with a chance near one half. Constants of hash-prospector
// (C. Wellons).
fn bd_hash_mix(value: u32) -> u32 {
    var h = value ^ 0xe6fe3bebu;
    h ^= h >> 16u;
    h *= 0x21f0aaadu;
    h ^= h >> 15u;
    h *= 0xd35a2d97u;
    return h ^ (h >> 15u);
}

// A seed that depends on all bits of both arguments and on their order.
fn bd_hash_combine(seed: u32, value: u32) -> u32 {
    return bd_hash_mix(bd_hash_mix(seed) + value);
}

// 64 bits of seed from 64. The multiplier of P. Evensen's rrmxmx (2018).
fn bd_hash_mix_64(value: vec2<u32>) -> vec2<u32> {
    let multiplier = vec2<u32>(0x1e98df25u, 0x9fb21c65u);
    var h = value ^ vec2<u32>(0x7f4a7c15u, 0x9e3779b9u);
    h.x ^= h.y;
    h = bd_wide_mul(h, multiplier);
    h ^= vec2<u32>((h.x >> 29u) | (h.y << 3u), h.y >> 29u);
    h = bd_wide_mul(h, multiplier);
    h.x ^= h.y;
    return h;
}

// Laine-Karras permutation: every bit is flipped by a hash of the bits below it. Hash `seed` first.
// Constants of N. Vegdahl (2021).
fn bd_hash_laine_karras(value_rev: u32, seed: u32) -> u32 {
    var n = value_rev;
    n ^= n * 0x3d20adeau;
    n += seed;
    n *= (seed >> 16u) | 1u;
    n ^= n * 0x05526c56u;
    return n ^ (n * 0x53a22864u);
}

// Nested uniform (Owen) scramble of a 0.32 number.
fn bd_hash_owen(value_fx: u32, seed: u32) -> u32 {
    return reverseBits(bd_hash_laine_karras(reverseBits(value_fx), seed));
}

// Another seed from a seed, for a hash that goes on.
fn bd_hash_other(seed: u32) -> u32 {
    return bd_wide_product(seed, 0x7f4a7c15u).y + seed * 0x9e3779b9u;
}

// Base-4 form of the Laine-Karras permutation.
fn bd_hash_laine_karras_4(value_rev: u32, seed: u32) -> u32 {
    let first = 0x55555555u;
    let own = bd_hash_other(seed);
    let hash = bd_hash_laine_karras(value_rev, own);
    let choice = (hash << 2u) | (own >> 30u);
    let third = (hash << 4u) | ((own >> 26u) & 0xfu);
    var n = value_rev;
    n ^= (n & first) << 1u;
    n ^= (n >> 1u) & choice & first;
    n ^= (n & (choice >> 1u) & first) << 1u;
    n ^= (n >> 1u) & third & first;
    return bd_hash_laine_karras(n, seed);
}

// Nested uniform scramble in base 4 of a 0.32 number.
fn bd_hash_owen_4(value_fx: u32, seed: u32) -> u32 {
    return reverseBits(bd_hash_laine_karras_4(reverseBits(value_fx), seed));
}

// Shuffles bit-reversed sample numbers so that every set of the first 2^k stays the same set. Hash `seed` first.
fn bd_hash_shuffle_rev(index_rev: u32, seed: u32) -> u32 {
    var n = index_rev;
    n ^= n * (seed & 0xfffffffeu);
    n *= (seed >> 20u) | 1u;
    return n ^ (n * ((seed >> 10u) & 0xfffffffeu));
}

// The same of an index that is not reversed.
fn bd_hash_shuffle(index: u32, seed: u32) -> u32 {
    return reverseBits(bd_hash_shuffle_rev(reverseBits(index), seed));
}
