// sRGB and linear light, both of 16 bits (larger numbers are not defined). As `bluedither::dither::gamma`; the light of
// the 256 values of 8 bits comes from a function that you write, or take with `shader::LINEAR_LIGHT`:
//     fn bd_gamma_load(i: u32) -> u32

// Linear light of an sRGB value.
fn bd_gamma_to_linear(srgb: u32) -> u32 {
    let lower = bd_gamma_load(srgb / 257u);
    let upper = bd_gamma_load(min(srgb / 257u + 1u, 255u));
    return lower + ((upper - lower) * (srgb % 257u) + 128u) / 257u;
}

// The largest sRGB value whose linear light is not above the given.
fn bd_gamma_from_linear(linear: u32) -> u32 {
    var srgb = 0u;
    for (var bit = 0x8000u; bit > 0u; bit >>= 1u) {
        if bd_gamma_to_linear(srgb | bit) <= linear {
            srgb |= bit;
        }
    }
    return srgb;
}

// As bd_quantise_level, levels and value being sRGB, and the way between levels being measured in linear light.
fn bd_gamma_level(value: u32, max_: u32, levels: u32, threshold_fx: u32) -> u32 {
    if max_ == 0u {
        return 0u;
    }
    let srgb = (min(value, max_) * 65535u + max_ / 2u) / max_;
    let lower = bd_quantise_level(srgb, 65535u, levels, 0xffffffffu);
    let light = bd_gamma_to_linear(srgb);
    let below = bd_gamma_to_linear(bd_quantise_value(lower, 65535u, levels));
    let above = bd_gamma_to_linear(bd_quantise_value(lower + 1u, 65535u, levels));
    let threshold = bd_quantise_scaled(threshold_fx, above - below);
    return lower + select(0u, 1u, above > below && light > below && light - below > threshold);
}
