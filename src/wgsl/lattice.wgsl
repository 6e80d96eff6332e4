// Rank-1 lattices and R-sequences: one multiplication a dimension. As `bluedither::lattice`, where generating
// vectors are listed.

// Coordinate floor(2^32 * frac(i * z / count)) of point `index` of a lattice of `count` points; 0 counts as 1.
fn bd_lattice_fixed(index: u32, z: u32, count: u32) -> u32 {
    let divisor = max(count, 1u);
    let product = bd_wide_product(index, z);
    let remainder = bd_wide_divide(vec2<u32>(product.x, product.y % divisor), divisor).y;
    return bd_wide_divide(vec2<u32>(0u, remainder), divisor).x;
}

// Coordinate frac(phi(i) * z) of point `index` of an extensible lattice, z odd.
fn bd_lattice_extensible(index: u32, z: u32) -> u32 {
    return reverseBits(index) * z;
}

// Point `index` of the R-sequence (M. Roberts 2018) in 1 to 4 dimensions, 0.32 fixed point.
fn bd_lattice_r1(index: u32) -> u32 {
    return index * 0x9e3779b9u + 0x80000000u;
}

fn bd_lattice_r2(index: u32) -> vec2<u32> {
    return index * vec2<u32>(0xc13fa9a9u, 0x91e10da5u) + vec2<u32>(0x80000000u);
}

fn bd_lattice_r3(index: u32) -> vec3<u32> {
    return index * vec3<u32>(0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u) + vec3<u32>(0x80000000u);
}

fn bd_lattice_r4(index: u32) -> vec4<u32> {
    return index * vec4<u32>(0xdb4f0b91u, 0xbbe05633u, 0xa0f2ec75u, 0x89e18285u) + vec4<u32>(0x80000000u);
}

// One component of the same, `axis` modulo the dimensions, with 64 bits of index and value.
fn bd_lattice_r1_64(index: vec2<u32>, axis: u32) -> vec2<u32> {
    return bd_lattice_from_half(index, vec2<u32>(0x7f4a7c15u, 0x9e3779b9u));
}

fn bd_lattice_r2_64(index: vec2<u32>, axis: u32) -> vec2<u32> {
    let low = vec2<u32>(0x02a6328fu, 0xc79e7b1du);
    let high = vec2<u32>(0xc13fa9a9u, 0x91e10da5u);
    return bd_lattice_from_half(index, vec2<u32>(low[axis % 2u], high[axis % 2u]));
}

fn bd_lattice_r3_64(index: vec2<u32>, axis: u32) -> vec2<u32> {
    let low = vec3<u32>(0xd192ed03u, 0xfb8fac03u, 0x2f3d8dd7u);
    let high = vec3<u32>(0xd1b54a32u, 0xabc98388u, 0x8cb92ba7u);
    return bd_lattice_from_half(index, vec2<u32>(low[axis % 3u], high[axis % 3u]));
}

fn bd_lattice_r4_64(index: vec2<u32>, axis: u32) -> vec2<u32> {
    let low = vec4<u32>(0x75ae2165u, 0x03a4615fu, 0xa1fe1575u, 0x7d9ed689u);
    let high = vec4<u32>(0xdb4f0b91u, 0xbbe05633u, 0xa0f2ec75u, 0x89e18285u);
    return bd_lattice_from_half(index, vec2<u32>(low[axis % 4u], high[axis % 4u]));
}

// One half, and `index` increments.
fn bd_lattice_from_half(index: vec2<u32>, increment: vec2<u32>) -> vec2<u32> {
    return bd_wide_mul(index, increment) + vec2<u32>(0u, 0x80000000u);
}
