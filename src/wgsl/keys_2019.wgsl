// The tables of 2019 by the formula that came with them, as `bluedither::keys_2019`. Their bytes come from what you
// write, or take with `shader::SOBOL_2019`, `SCRAMBLING_2019` and `RANKING_2019`:
//     fn bd_sobol_2019_load(i: u32) -> u32, and so on

// The value of a sample, k for (k + 1/2)/256. Coordinates wrap at 128, `index` and `dimension` at 256.
fn bd_keys_2019_value(x: u32, y: u32, index: u32, dimension: u32) -> u32 {
    let tile = (dimension & 7u) | ((x & 127u) << 3u) | ((y & 127u) << 10u);
    let ranked = (index & 255u) ^ bd_ranking_2019_load(tile);
    return bd_sobol_2019_load((dimension & 255u) | (ranked << 8u)) ^ bd_scrambling_2019_load(tile);
}

// The value in 0.32 fixed point.
fn bd_keys_2019_value_fx(x: u32, y: u32, index: u32, dimension: u32) -> u32 {
    return (bd_keys_2019_value(x, y, index, dimension) << 24u) | 0x800000u;
}

// The value in (0, 1).
fn bd_keys_2019_value_f32(x: u32, y: u32, index: u32, dimension: u32) -> f32 {
    return bd_unit_to_f32(bd_keys_2019_value_fx(x, y, index, dimension));
}
