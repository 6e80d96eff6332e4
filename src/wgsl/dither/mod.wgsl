// Halftoning by comparing every pixel with a threshold. As `bluedither::Dither`, pixel by pixel; `blue` takes the
// scalar mask that is bound. In linear light: bd_gamma_level of the same threshold.

const BD_DITHER_CONSTANT = 0u;
const BD_DITHER_RANDOM = 1u;
const BD_DITHER_ORDERED = 2u;
const BD_DITHER_BLUE = 3u;

struct bd_Dither {
    kind: u32,
    // The threshold, the seed or the size.
    parameter: u32,
    frame: u32,
    triangular: bool,
    origin: vec2<u32>,
}

// The same threshold everywhere, in 0.32 fixed point.
fn bd_dither_constant(threshold_fx: u32) -> bd_Dither {
    return bd_Dither(BD_DITHER_CONSTANT, threshold_fx, 0u, false, vec2<u32>(0u));
}

// An independent random threshold for every pixel.
fn bd_dither_random(seed: u32) -> bd_Dither {
    return bd_Dither(BD_DITHER_RANDOM, seed, 0u, false, vec2<u32>(0u));
}

// A Bayer matrix of 2^size_log2 squared thresholds.
fn bd_dither_ordered(size_log2: u32) -> bd_Dither {
    return bd_Dither(BD_DITHER_ORDERED, min(size_log2, 15u), 0u, false, vec2<u32>(0u));
}

// The thresholds of a mask.
fn bd_dither_blue() -> bd_Dither {
    return bd_Dither(BD_DITHER_BLUE, BD_SCALAR_LOG2, 0u, false, vec2<u32>(0u));
}

// For frame `frame` of an animation.
fn bd_dither_frame(dither: bd_Dither, frame: u32) -> bd_Dither {
    return bd_Dither(dither.kind, dither.parameter, frame, dither.triangular, dither.origin);
}

// Where on the screen the first pixel of row 0 lies.
fn bd_dither_origin(dither: bd_Dither, x: u32, y: u32) -> bd_Dither {
    return bd_Dither(dither.kind, dither.parameter, dither.frame, dither.triangular, vec2<u32>(x, y));
}

// Triangularly distributed noise of +-1 level instead of noise between two levels.
fn bd_dither_triangular(dither: bd_Dither) -> bd_Dither {
    return bd_Dither(dither.kind, dither.parameter, dither.frame, true, dither.origin);
}

// The threshold at a pixel in 0.32 fixed point; channels beyond the fourth repeat.
fn bd_dither_threshold_fx(dither: bd_Dither, x: u32, y: u32, channel: u32) -> u32 {
    let place = vec2<u32>(x, y) + dither.origin;
    let domain = channel & 3u;
    if dither.kind == BD_DITHER_CONSTANT {
        return dither.parameter;
    }
    if dither.kind == BD_DITHER_RANDOM {
        let seed = bd_hash_combine(bd_hash_combine(dither.parameter, dither.frame), domain);
        return bd_hash_combine(bd_hash_combine(seed, place.y), place.x);
    }
    // From the first channel of frame 0 on.
    let first = bd_torus_offset(0u, 0u, 0u, 0u, dither.parameter);
    let shifted = place + bd_torus_offset(0u, domain, 0u, dither.frame, dither.parameter) - first;
    if dither.kind == BD_DITHER_ORDERED {
        return bd_ordered_value_fx(shifted.x, shifted.y, dither.parameter);
    }
    return bd_scalar_value_fx(shifted.x, shifted.y);
}

// The level, 0..levels, of one value of 0..=max at a pixel.
fn bd_dither_level(dither: bd_Dither, x: u32, y: u32, channel: u32, value: u32, max_: u32, levels: u32) -> u32 {
    let threshold = bd_dither_threshold_fx(dither, x, y, channel);
    if dither.triangular {
        return bd_quantise_level_triangular(value, max_, levels, threshold);
    }
    return bd_quantise_level(value, max_, levels, threshold);
}
