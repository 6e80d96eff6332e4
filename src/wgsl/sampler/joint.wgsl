// The draws of a sampler whose domains are one net, by its `bd_NAME_numbers` of a pixel, a domain and an index, which
// gives all eight numbers: what is not asked for is for the compiler to leave out. NAME and TITLE are the sampler's.

// Sample `index` for purpose `domain`: 1 to 8 numbers, 0.32 fixed point.
fn bd_NAME_draw1_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> u32 {
    return bd_NAME_numbers(pixel, domain, index)[0];
}

fn bd_NAME_draw2_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec2<u32> {
    let n = bd_NAME_numbers(pixel, domain, index);
    return vec2<u32>(n[0], n[1]);
}

fn bd_NAME_draw3_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec3<u32> {
    let n = bd_NAME_numbers(pixel, domain, index);
    return vec3<u32>(n[0], n[1], n[2]);
}

fn bd_NAME_draw4_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> vec4<u32> {
    let n = bd_NAME_numbers(pixel, domain, index);
    return vec4<u32>(n[0], n[1], n[2], n[3]);
}

fn bd_NAME_draw5_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 5> {
    let n = bd_NAME_numbers(pixel, domain, index);
    return array<u32, 5>(n[0], n[1], n[2], n[3], n[4]);
}

fn bd_NAME_draw6_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 6> {
    let n = bd_NAME_numbers(pixel, domain, index);
    return array<u32, 6>(n[0], n[1], n[2], n[3], n[4], n[5]);
}

fn bd_NAME_draw7_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 7> {
    let n = bd_NAME_numbers(pixel, domain, index);
    return array<u32, 7>(n[0], n[1], n[2], n[3], n[4], n[5], n[6]);
}

fn bd_NAME_draw8_fx(pixel: bd_TITLEPixel, domain: u32, index: u32) -> array<u32, 8> {
    return bd_NAME_numbers(pixel, domain, index);
}
