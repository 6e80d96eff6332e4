// Alpha, blended before dithering: red, green, blue and alpha in this order, 8 bits each in a u32. As
// `bluedither::dither::alpha`.

// A pixel of 8 bits a channel with alpha over a background, 16 bits a channel, rounded to the nearest.
fn bd_alpha_over(pixel: vec4<u32>, background: vec3<u32>) -> vec3<u32> {
    let sum = pixel.rgb * pixel.a + background * (255u - pixel.a);
    return sum + (2u * sum + vec3<u32>(127u)) / vec3<u32>(255u);
}
