// The first four dimensions of the Sobol sequence, 0.32 fixed point. As `bluedither::sobol`.

// Point `index` of dimension 0, the van der Corput sequence.
fn bd_sobol_dimension_0(index: u32) -> u32 {
    return reverseBits(index);
}

// Point `index` of dimension 1, whose generator is Pascal's triangle modulo 2.
fn bd_sobol_dimension_1(index: u32) -> u32 {
    return reverseBits(bd_sobol_dimension_1_rev(index));
}

// The same, bit-reversed: what bd_hash_laine_karras scrambles.
fn bd_sobol_dimension_1_rev(index: u32) -> u32 {
    var n = index;
    n ^= (n >> 1u) & 0x55555555u;
    n ^= (n >> 2u) & 0x33333333u;
    n ^= (n >> 4u) & 0x0f0f0f0fu;
    n ^= (n >> 8u) & 0x00ff00ffu;
    return n ^ (n >> 16u);
}

// Point `index` of the (0, 2)-sequence of the first two dimensions.
fn bd_sobol_point(index: u32) -> vec2<u32> {
    return vec2<u32>(bd_sobol_dimension_0(index), bd_sobol_dimension_1(index));
}

// Point `index` of dimension `dimension` modulo 4. The direction numbers of the last two are made on the way.
fn bd_sobol_dimension(index: u32, dimension: u32) -> u32 {
    var sum = 0u;
    switch dimension & 3u {
        case 0u: {
            return bd_sobol_dimension_0(index);
        }
        case 1u: {
            return bd_sobol_dimension_1(index);
        }
        case 2u: {
            var next = vec2<u32>(0x80000000u, 0xc0000000u);
            for (var rest = index; rest != 0u; rest >>= 1u) {
                sum ^= next.x & (0u - (rest & 1u));
                next = vec2<u32>(next.y, next.x ^ (next.x >> 2u) ^ next.y);
            }
        }
        default: {
            var next = vec3<u32>(0x80000000u, 0xc0000000u, 0x20000000u);
            for (var rest = index; rest != 0u; rest >>= 1u) {
                sum ^= next.x & (0u - (rest & 1u));
                next = vec3<u32>(next.yz, next.x ^ (next.x >> 3u) ^ next.y);
            }
        }
    }
    return sum;
}

// A pixel's own Owen-scrambled point: bd_sobol_point with one independent scramble a dimension.
fn bd_sobol_owen_point(index: u32, seed: u32) -> vec2<u32> {
    return vec2<u32>(
        reverseBits(bd_hash_laine_karras(index, bd_hash_mix(seed))),
        reverseBits(bd_hash_laine_karras(bd_sobol_dimension_1_rev(index), bd_hash_mix(seed ^ 0x94d049bbu))),
    );
}
