// Pixels along a Z curve. As `bluedither::zorder`.

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
