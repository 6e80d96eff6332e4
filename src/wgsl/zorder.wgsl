// Pixels along a Z curve, the sequence that they share, and where on it a pixel begins. As `bluedither::zorder`.

// The Z curve: bit k of x is bit 2k of the code, bit k of y bit 2k+1.
fn bd_zorder_morton(x: u32, y: u32) -> vec2<u32> {
    return vec2<u32>(bd_zorder_morton_16(x, y), bd_zorder_morton_16(x >> 16u, y >> 16u));
}

// The lower half of the code, from the lower 16 bits of both.
fn bd_zorder_morton_16(x: u32, y: u32) -> u32 {
    var n = vec2<u32>(x, y) & vec2<u32>(0xffffu);
    n = (n | (n << vec2<u32>(8u))) & vec2<u32>(0x00ff00ffu);
    n = (n | (n << vec2<u32>(4u))) & vec2<u32>(0x0f0f0f0fu);
    n = (n | (n << vec2<u32>(2u))) & vec2<u32>(0x33333333u);
    n = (n | (n << vec2<u32>(1u))) & vec2<u32>(0x55555555u);
    return n.x | (n.y << 1u);
}

// Where place `place_rev`, bit-reversed, of a Z curve begins: its sample i is bd_zorder_point of
// that XOR i.
fn bd_zorder_first_index(place_rev: u32) -> u32 {
    var n = place_rev;
    var b = n & 0xccccccccu;
    n ^= (b >> 1u) ^ (b >> 2u);
    b = n & 0xf0f0f0f0u;
    n ^= (b >> 2u) ^ (b >> 4u);
    b = n & 0xff00ff00u;
    n ^= (b >> 4u) ^ (b >> 8u);
    b = n & 0xffff0000u;
    return n ^ (b >> 8u) ^ (b >> 16u);
}

// Point `index` of the sequence that pixels share, 0.32 fixed point: a linear one.
fn bd_zorder_point(index: u32) -> vec2<u32> {
    let x = reverseBits(index);
    var y = x;
    y ^= (y << 1u) & 0xaaaaaaaau;
    y ^= (y << 2u) & 0xccccccccu;
    y ^= (y << 4u) & 0xf0f0f0f0u;
    y ^= (y << 8u) & 0xff00ff00u;
    y ^= y << 16u;
    var n = vec2<u32>(x, y);
    n ^= (n >> vec2<u32>(1u)) & vec2<u32>(0x53be4322u, 0x298af328u);
    n ^= (n >> vec2<u32>(2u)) & vec2<u32>(0x2ff4b33au, 0x17efc464u);
    n ^= (n >> vec2<u32>(4u)) & vec2<u32>(0x03ffe2f7u, 0x099fe007u);
    return n ^ ((n >> vec2<u32>(8u)) & vec2<u32>(0x00a5ffecu, 0x00edffd3u));
}
