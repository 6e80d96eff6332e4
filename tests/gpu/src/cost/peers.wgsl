// What samplers are compared with, in their call shape.

// Jarzynski and Olano 2020, "Hash Functions for GPU Rendering": white noise, four numbers a hash.
fn pcg4d(key: vec4<u32>) -> vec4<u32> {
    var v = key * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> vec4<u32>(16u);
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

fn pcg4d_pixel(seed: u32, x: u32, y: u32, frame: u32) -> vec3<u32> {
    return vec3<u32>(x, y, seed + frame);
}

fn pcg4d_draw2(pixel: vec3<u32>, domain: u32, index: u32) -> vec2<f32> {
    return pcg4d_draw4(pixel, domain, index).xy;
}

fn pcg4d_draw4(pixel: vec3<u32>, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(pcg4d(vec4<u32>(pixel, (index << 8u) | domain)));
}

fn pcg4d_draw8(pixel: vec3<u32>, domain: u32, index: u32) -> array<f32, 8> {
    return eight(pcg4d_draw4(pixel, 2u * domain, index), pcg4d_draw4(pixel, 2u * domain + 1u, index));
}

fn eight(a: vec4<f32>, b: vec4<f32>) -> array<f32, 8> {
    return array<f32, 8>(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
}

// Heitz et al. 2019, "A Low-Discrepancy Sampler that Distributes Monte Carlo Errors as a Blue Noise in Screen Space":
// three look-ups a number; a word a value as published, 1.25 MiB.
@group(0) @binding(16) var<storage, read> heitz_sobol: array<u32>;
@group(0) @binding(17) var<storage, read> heitz_scrambling: array<u32>;
@group(0) @binding(18) var<storage, read> heitz_ranking: array<u32>;

fn heitz_pixel(seed: u32, x: u32, y: u32, frame: u32) -> u32 {
    return ((x & 127u) << 3u) | ((y & 127u) << 10u);
}

// Number `k` of the domain's eight.
fn heitz_value(pixel: u32, domain: u32, index: u32, k: u32) -> u32 {
    let ranked = (index & 255u) ^ heitz_ranking[pixel | k];
    let value = heitz_sobol[(((domain & 31u) << 3u) | (ranked << 8u)) | k] ^ heitz_scrambling[pixel | k];
    return (value << 24u) | 0x800000u;
}

fn heitz_draw2(pixel: u32, domain: u32, index: u32) -> vec2<f32> {
    return heitz_values(pixel, domain, index, 0u).xy;
}

fn heitz_draw4(pixel: u32, domain: u32, index: u32) -> vec4<f32> {
    return heitz_values(pixel, domain, index, 0u);
}

fn heitz_draw8(pixel: u32, domain: u32, index: u32) -> array<f32, 8> {
    return eight(heitz_values(pixel, domain, index, 0u), heitz_values(pixel, domain, index, 4u));
}

// Four from number `first` on.
fn heitz_values(pixel: u32, domain: u32, index: u32, first: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(vec4<u32>(
        heitz_value(pixel, domain, index, first),
        heitz_value(pixel, domain, index, first + 1u),
        heitz_value(pixel, domain, index, first + 2u),
        heitz_value(pixel, domain, index, first + 3u),
    ));
}

// Burley 2020, "Practical Hash-based Owen Scrambling": Sobol points in four dimensions, shuffled and scrambled under a
// seed. The first two dimensions by bit operations.
fn owen_sobol(index: u32, seed: u32) -> vec4<u32> {
    let shuffled = owen(index, seed);
    var last = vec2<u32>(0u);
    for (var bit = 0u; bit < 32u; bit++) {
        last ^= SOBOL_3_4[bit] & vec2<u32>(0u - ((shuffled >> bit) & 1u));
    }
    return vec4<u32>(
        reverseBits(owen_rev(shuffled, owen_combine(seed, 0u))),
        reverseBits(owen_rev(bd_sobol_dimension_1_rev(shuffled), owen_combine(seed, 1u))),
        owen(last.x, owen_combine(seed, 2u)),
        owen(last.y, owen_combine(seed, 3u)),
    );
}

fn owen(value: u32, seed: u32) -> u32 {
    return reverseBits(owen_rev(reverseBits(value), seed));
}

fn owen_rev(value_rev: u32, seed: u32) -> u32 {
    var n = value_rev + seed;
    n ^= n * 0x6c50b47cu;
    n ^= n * 0xb82f1e52u;
    n ^= n * 0xc7afe638u;
    return n ^ (n * 0x8d22f6e6u);
}

fn owen_combine(seed: u32, value: u32) -> u32 {
    return seed ^ (value + (seed << 6u) + (seed >> 2u));
}

// Direction numbers of the third and the fourth dimension.
const SOBOL_3_4 = array<vec2<u32>, 32>(
    vec2<u32>(0x80000000u, 0x80000000u), vec2<u32>(0xc0000000u, 0xc0000000u),
    vec2<u32>(0x60000000u, 0x20000000u), vec2<u32>(0x90000000u, 0x50000000u),
    vec2<u32>(0xe8000000u, 0xf8000000u), vec2<u32>(0x5c000000u, 0x74000000u),
    vec2<u32>(0x8e000000u, 0xa2000000u), vec2<u32>(0xc5000000u, 0x93000000u),
    vec2<u32>(0x68800000u, 0xd8800000u), vec2<u32>(0x9cc00000u, 0x25400000u),
    vec2<u32>(0xee600000u, 0x59e00000u), vec2<u32>(0x55900000u, 0xe6d00000u),
    vec2<u32>(0x80680000u, 0x78080000u), vec2<u32>(0xc09c0000u, 0xb40c0000u),
    vec2<u32>(0x60ee0000u, 0x82020000u), vec2<u32>(0x90550000u, 0xc3050000u),
    vec2<u32>(0xe8808000u, 0x208f8000u), vec2<u32>(0x5cc0c000u, 0x51474000u),
    vec2<u32>(0x8e606000u, 0xfbea2000u), vec2<u32>(0xc5909000u, 0x75d93000u),
    vec2<u32>(0x6868e800u, 0xa0858800u), vec2<u32>(0x9c9c5c00u, 0x914e5400u),
    vec2<u32>(0xeeee8e00u, 0xdbe79e00u), vec2<u32>(0x5555c500u, 0x25db6d00u),
    vec2<u32>(0x8000e880u, 0x58800080u), vec2<u32>(0xc0005cc0u, 0xe54000c0u),
    vec2<u32>(0x60008e60u, 0x79e00020u), vec2<u32>(0x9000c590u, 0xb6d00050u),
    vec2<u32>(0xe8006868u, 0x800800f8u), vec2<u32>(0x5c009c9cu, 0xc00c0074u),
    vec2<u32>(0x8e00eeeeu, 0x200200a2u), vec2<u32>(0xc5005555u, 0x50050093u),
);

fn owen_sobol_pixel(seed: u32, x: u32, y: u32, frame: u32) -> u32 {
    return bd_hash_mix(x + bd_hash_mix(y + bd_hash_mix(seed + frame)));
}

fn owen_sobol_draw2(pixel: u32, domain: u32, index: u32) -> vec2<f32> {
    return owen_sobol_draw4(pixel, domain, index).xy;
}

fn owen_sobol_draw4(pixel: u32, domain: u32, index: u32) -> vec4<f32> {
    return bd_unit_to_f32s4(owen_sobol(index, bd_hash_mix(pixel + domain)));
}

// Two sets of four: the second has an order of its own.
fn owen_sobol_draw8(pixel: u32, domain: u32, index: u32) -> array<f32, 8> {
    return eight(owen_sobol_draw4(pixel, 2u * domain, index), owen_sobol_draw4(pixel, 2u * domain + 1u, index));
}

// Four thresholds of `bluedither::Dither`.
fn dither_pixel(seed: u32, x: u32, y: u32, frame: u32) -> vec3<u32> {
    return vec3<u32>(x, y, frame);
}

fn dither_draw4(pixel: vec3<u32>, domain: u32, index: u32) -> vec4<f32> {
    let dither = bd_dither_frame(bd_dither_blue(), pixel.z);
    var drawn: vec4<f32>;
    for (var channel = 0u; channel < 4u; channel++) {
        drawn[channel] = bd_unit_to_f32(bd_dither_threshold_fx(dither, pixel.x, pixel.y, channel));
    }
    return drawn;
}
