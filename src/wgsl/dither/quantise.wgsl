// One value, one threshold: a level. Values and levels are of 16 bits; of larger ones the result is not defined. As
// `bluedither::dither::quantise`.

// The level of `value` of 0..=max: the upper of two neighbours where its way between them exceeds the threshold.
fn bd_quantise_level(value: u32, max_: u32, levels: u32, threshold_fx: u32) -> u32 {
    let way = bd_quantise_way(value, max_, levels);
    return way.x + select(0u, 1u, way.y > bd_quantise_scaled(threshold_fx, max_));
}

// The same with triangularly distributed noise of +-1 level.
fn bd_quantise_level_triangular(value: u32, max_: u32, levels: u32, threshold_fx: u32) -> u32 {
    let way = bd_quantise_way(value, max_, levels);
    let steps = bd_quantise_steps(levels);
    let near_black = way.x == 0u && 2u * way.y < max_;
    let near_white = way.x >= steps || (way.x + 1u == steps && 2u * way.y > max_);
    if near_black || near_white {
        return way.x + select(0u, 1u, way.y > bd_quantise_scaled(threshold_fx, max_));
    }
    if max_ == 0u {
        return 0u;
    }
    // Half a level, the noise and one level more, which keeps the sum above zero; in units of 2^-31.
    let noise = bitcast<u32>(bd_quantise_triangular(~threshold_fx)) + 0x80000000u;
    var sum = bd_wide_product(noise, max_);
    sum = bd_wide_add(sum, bd_wide_product(way.y, 0x80000000u));
    sum = bd_wide_add(sum, bd_wide_product(max_, 0x40000000u));
    return way.x + ((sum.y << 1u) | (sum.x >> 31u)) / max_ - 1u;
}

// From uniform to triangular: 0.32 in, -1..1 as a multiple of 2^-31 out.
fn bd_quantise_triangular(value_fx: u32) -> i32 {
    let upper = value_fx >= 0x80000000u;
    let side = select(value_fx, ~value_fx, upper);
    let root = bd_wide_isqrt(vec2<u32>(side << 31u, side >> 1u)) - 0x80000000u;
    return bitcast<i32>(select(root, ~root, upper));
}

// The value of 0..=max that a level stands for.
fn bd_quantise_value(level: u32, max_: u32, levels: u32) -> u32 {
    let steps = bd_quantise_steps(levels);
    if steps == 0u {
        return 0u;
    }
    return (min(level, steps) * max_ + steps / 2u) / steps;
}

// floor(threshold * max).
fn bd_quantise_scaled(threshold_fx: u32, max_: u32) -> u32 {
    return bd_wide_product(threshold_fx, max_).y;
}

fn bd_quantise_steps(levels: u32) -> u32 {
    return max(levels, 1u) - 1u;
}

// A value among levels: the level at or below it, and `max` times the way from there to the next.
fn bd_quantise_way(value: u32, max_: u32, levels: u32) -> vec2<u32> {
    if max_ == 0u {
        return vec2<u32>(0u);
    }
    let scaled = min(value, max_) * bd_quantise_steps(levels);
    return vec2<u32>(scaled / max_, scaled % max_);
}
