// The draws of a sampler whose domains are pairs, by its `bd_NAME_pair` and `bd_NAME_single` of a pixel, a domain, the
// number 0 to 3 of the pair and an index. NAME and TITLE are the sampler's.

// Sample `index` for purpose `domain`: 1 to 8 numbers, 0.32 fixed point.
fn bd_NAME_draw1_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> u32 {
    return bd_NAME_single(pixel, domain, 0u, index);
}

fn bd_NAME_draw2_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec2<u32> {
    return bd_NAME_pair(pixel, domain, 0u, index);
}

fn bd_NAME_draw3_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec3<u32> {
    return vec3<u32>(bd_NAME_pair(pixel, domain, 0u, index), bd_NAME_single(pixel, domain, 1u, index));
}

fn bd_NAME_draw4_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec4<u32> {
    return vec4<u32>(bd_NAME_pair(pixel, domain, 0u, index), bd_NAME_pair(pixel, domain, 1u, index));
}

fn bd_NAME_draw5_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 5> {
    let a = bd_NAME_draw4_fx(pixel, domain, index);
    let b = bd_NAME_single(pixel, domain, 2u, index);
    return array<u32, 5>(a.x, a.y, a.z, a.w, b);
}

fn bd_NAME_draw6_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 6> {
    let a = bd_NAME_draw4_fx(pixel, domain, index);
    let b = bd_NAME_pair(pixel, domain, 2u, index);
    return array<u32, 6>(a.x, a.y, a.z, a.w, b.x, b.y);
}

fn bd_NAME_draw7_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 7> {
    let a = bd_NAME_draw4_fx(pixel, domain, index);
    let b = bd_NAME_pair(pixel, domain, 2u, index);
    let c = bd_NAME_single(pixel, domain, 3u, index);
    return array<u32, 7>(a.x, a.y, a.z, a.w, b.x, b.y, c);
}

fn bd_NAME_draw8_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 8> {
    let a = bd_NAME_draw4_fx(pixel, domain, index);
    let b = bd_NAME_pair(pixel, domain, 2u, index);
    let c = bd_NAME_pair(pixel, domain, 3u, index);
    return array<u32, 8>(a.x, a.y, a.z, a.w, b.x, b.y, c.x, c.y);
}
