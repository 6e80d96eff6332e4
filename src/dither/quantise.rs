//! One value, one threshold: a level. Integers only, every argument defined.

/// The level, 0..`levels`, of `value` of 0..=`max`: the upper of the two neighbours where the value's way between them
/// exceeds the threshold (0.32 fixed point).
///
/// Levels are evenly spaced from 0 to `max`. Monotone in `value` and in the threshold; a value that *is* a level stays,
/// whatever the threshold; so black stays black and white stays white. Values beyond `max` count as `max`, and fewer
/// than two levels or a `max` of 0 give 0. With the thresholds of an S×S mask the share of upper levels is exact to the
/// nearest 1/S², since they are centres of cells.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "a level is below `levels`")]
pub const fn level(value: u16, max: u16, levels: u16, threshold_fx: u32) -> u16 {
    let way = way(value, max, levels);
    let up = way.rest > scaled(threshold_fx, max as u32);
    (way.lower + up as u32) as u16
}

/// [`level`] with triangularly distributed noise of ±1 level: up to three levels occur, and the variance of the error
/// does not depend on the value. Within half a level of black and of white it is [`level`], which joins without a step:
/// a mean is kept there as well, and black and white stay.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a level is below `levels`")]
pub const fn level_triangular(value: u16, max: u16, levels: u16, threshold_fx: u32) -> u16 {
    let way = way(value, max, levels);
    let (max, steps) = (max as u32, levels.saturating_sub(1) as u32);
    let near_black = way.lower == 0 && 2 * way.rest < max;
    let near_white = way.lower >= steps || way.lower + 1 == steps && 2 * way.rest > max;
    if near_black || near_white {
        return (way.lower + (way.rest > scaled(threshold_fx, max)) as u32) as u16;
    }
    // A low threshold lets a value rise: the noise is that of its complement.
    let noise = triangular(!threshold_fx) as i64;
    let sum = ((way.rest as i64) << 31) + ((max as i64) << 30) + noise * max as i64;
    // Below zero by one level at most, and then the lower level is not black.
    match sum.checked_div_euclid((max as i64) << 31) {
        Some(moved) => (way.lower as i64 + moved) as u16,
        None => 0,
    }
}

/// From uniform to triangular: 0.32 in, −1..1 as a multiple of 2⁻³¹ out. The inverse of the distribution, so it is
/// monotone, and a blue-noise mask stays one.
///
/// √(2u) − 1 below one half, and 1 − √(2(1−u)) above.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "the root is below 2³¹")]
pub const fn triangular(value_fx: u32) -> i32 {
    const ONE: i64 = 1 << 31;
    if value_fx < 1 << 31 {
        (((value_fx as u64) << 31).isqrt() as i64 - ONE) as i32
    } else {
        !((((!value_fx as u64) << 31).isqrt() as i64 - ONE) as i32)
    }
}

/// The value of 0..=`max` that a level stands for, rounded to the nearest; levels beyond the last count as the last.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "at most `max`")]
pub const fn value(level: u16, max: u16, levels: u16) -> u16 {
    let steps = levels.saturating_sub(1) as u32;
    let level = if (level as u32) < steps { level as u32 } else { steps };
    match (level * max as u32 + steps / 2).checked_div(steps) {
        Some(value) => value as u16,
        None => 0,
    }
}

/// ⌊threshold · max⌋: a remainder above it exceeds the threshold, since remainders are whole.
#[inline]
pub(super) const fn scaled(threshold_fx: u32, max: u32) -> u32 {
    ((threshold_fx as u64 * max as u64) >> 32) as u32
}

/// A value among levels: the level at or below it, and `max` times the way from there to the next.
struct Way {
    lower: u32,
    rest: u32,
}

#[inline]
const fn way(value: u16, max: u16, levels: u16) -> Way {
    let value = if value < max { value } else { max };
    let scaled = value as u32 * levels.saturating_sub(1) as u32;
    match (scaled.checked_div(max as u32), scaled.checked_rem(max as u32)) {
        (Some(lower), Some(rest)) => Way { lower, rest },
        _ => Way { lower: 0, rest: 0 },
    }
}
