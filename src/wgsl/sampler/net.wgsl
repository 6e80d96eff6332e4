// The recommended sampler: the joint net. As `bluedither::Sampler`.

struct bd_Sampler {
    seed: u32,
    // Where the order begins among the constants.
    order: u32,
    // Bits of a sample's number below those of the frame; 16 if the number of samples is not known.
    bits: u32,
}

// Progressive: the sequence goes on for as long as it is asked.
fn bd_sampler_new(seed: u32) -> bd_Sampler {
    return bd_Sampler(seed, 8u * BD_NET_ORDER, 16u);
}

// `spp` samples per pixel: powers of two up to 64, and 256; other numbers are drawn as by bd_sampler_new.
fn bd_sampler_with_spp(seed: u32, spp: u32) -> bd_Sampler {
    let count = max(spp, 1u);
    if count > 256u || count == 128u || (count & (count - 1u)) != 0u {
        return bd_sampler_new(seed);
    }
    let bits = countTrailingZeros(count);
    return bd_Sampler(seed, min(bits, 7u) * BD_NET_ORDER, bits);
}

struct bd_SamplerPixel {
    order: u32,
    bits: u32,
    // Of all frames of one sequence.
    seed: vec2<u32>,
    place: vec2<u32>,
    frame: u32,
}

// The samples of one pixel in one frame.
fn bd_sampler_pixel(seeded: bd_Sampler, x: u32, y: u32, frame: u32) -> bd_SamplerPixel {
    let own = select(16u - seeded.bits, BD_NET_FRAME_BITS, seeded.bits == 16u);
    let seed = bd_hash_mix_64(vec2<u32>(frame >> own, seeded.seed));
    return bd_SamplerPixel(seeded.order, seeded.bits, seed, vec2<u32>(x, y), frame & ((1u << own) - 1u));
}

// An order of numbers of 16 bits: bits are added to lower ones at random.
fn bd_sampler_ordered(number: u32, hash: u32) -> u32 {
    var n = number ^ ((number >> 1u) & hash);
    n ^= (n >> 2u) & (hash >> 16u);
    let other = hash * 0x85ebca77u;
    if number > 15u {
        n ^= (n >> 4u) & (other >> 16u);
        n ^= (n >> 8u) & (other >> 8u);
    }
    let third = hash * 0xc2b2ae3du;
    n ^= (n >> 1u) & (third >> 16u);
    if number > 3u {
        n ^= (n >> 2u) & (third >> 12u);
        n ^= (n >> 4u) & (third >> 8u);
    }
    return n;
}

// Sample `index` for purpose `domain`: eight numbers, 0.32 fixed point.
fn bd_sampler_numbers(pixel: bd_SamplerPixel, domain: u32, index: u32) -> array<u32, 8> {
    let odd = vec4<u32>(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du, 0x27d4eb2fu);
    let key = bd_hash_mix_64(pixel.seed ^ bd_wide_mul(vec2<u32>(domain, 0u), vec2<u32>(0x7f4a7c15u, 0x9e3779b9u)));
    // Every domain lies elsewhere on the plane, on a curve of its own.
    let at = pixel.place + vec2<u32>(key.y, (key.y << 16u) | (key.y >> 16u));
    let curve = bd_hash_laine_karras_4(reverseBits(bd_zorder_morton_16(at.x >> 2u, at.y >> 2u)), key.x);
    // Eight variants of a block of 4x4 pixels.
    let variant = (curve * odd.x) >> 29u;
    var inside = select(at, at.yx, (variant & 4u) == 4u) & vec2<u32>(3u);
    inside.x ^= (variant >> 1u) & (inside.y >> 1u);
    inside.y ^= variant & (inside.x >> 1u);
    // The digital shift of 32x32 pixels.
    let shift = bd_hash_mix(((curve << 6u) >> 6u) ^ key.x);
    let own = bd_hash_mix(at.x ^ ((at.y << 16u) | (at.y >> 16u)) ^ key.y);
    var rest = (vec4<u32>(shift) * odd) ^ (vec4<u32>(key.y) * odd.wzyx);
    var digits = bd_net_add_two(rest, pixel.order + BD_NET_INSIDE, inside.x, 0u);
    digits = bd_net_add_two(digits, pixel.order + BD_NET_INSIDE + 2u, inside.y, 0u);
    let place = reverseBits(curve);
    digits = bd_net_add_four(digits, pixel.order + BD_NET_PLACE, place, 0u);
    digits = bd_net_add_two(digits, pixel.order + BD_NET_PLACE + 4u, place, 4u);
    // How many bits there are is the same for all pixels, and so is every branch.
    let known = pixel.bits < 16u;
    let mask = (1u << pixel.bits) - 1u;
    let low = index & mask;
    let ranks = select(0u, mask, known);
    // An order of frames that 32x32 pixels have in common. Their columns stand behind those of the samples, or apart.
    let frames = pixel.frame ^ ((index >> pixel.bits) & (0xffffu >> pixel.bits));
    var above = 0u;
    if frames != 0u {
        let n = bd_sampler_ordered(frames, shift);
        let columns = select(BD_NET_FRAMES, pixel.order + pixel.bits, known);
        for (var bit = 0u; (frames >> bit) != 0u; bit++) {
            digits ^= bd_net_term(columns + bit, n, bit);
        }
        above = select(0u, n << pixel.bits, known);
    }
    // The pixel's order of samples, which changes from frame to frame.
    let most = low | ranks;
    if most != 0u {
        let n = (bd_sampler_ordered(low | above, own) & mask) ^ ((own >> 8u) & ranks);
        digits = bd_net_add_four(digits, pixel.order, n, 0u);
        if most > 15u {
            digits = bd_net_add_four(digits, pixel.order + 4u, n, 4u);
            for (var bit = 8u; (most >> bit) != 0u; bit++) {
                digits ^= bd_net_term(pixel.order + bit, n, bit);
            }
        }
    }
    // After 2^16 samples another sequence begins.
    if index > 0xffffu {
        let next = bd_hash_mix_64(key ^ vec2<u32>(0u, index >> 16u));
        let anew = (vec4<u32>(next.y) * odd) ^ vec4<u32>(next.x);
        digits ^= anew;
        rest ^= anew;
    }
    let upper = (digits & vec4<u32>(0xffff0000u)) | (rest.yxwz & vec4<u32>(0xffffu));
    let lower = (digits << vec4<u32>(16u)) | (rest.yxwz >> vec4<u32>(16u));
    return array<u32, 8>(upper.x, lower.x, upper.y, lower.y, upper.z, lower.z, upper.w, lower.w);
}
