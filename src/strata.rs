//! Strata: the unit interval or square cut into `count` cells of equal size, for any `count`.
//!
//! In 1D, cell c is [c/count, (c+1)/count). In 2D the square has round(√count) rows; row r holds cells
//! ⌊r·count/rows⌋ up to ⌊(r+1)·count/rows⌋ and its height is its share of the cells, so every cell has area
//! 1/count exactly, and a square count gives the regular grid. All values are 0.32 fixed point, rounded down; a
//! `count` of 0 counts as 1 and a cell is taken modulo `count`.

/// The point at `inside` ∈ [0, 1) of cell `cell`: ⌊(cell + inside)·2³²/count⌋, exactly. A shift for powers of two, else
/// a 64-bit division.
#[inline]
#[must_use]
pub const fn place_1d(cell: u32, count: u32, inside: u32) -> u32 {
    let count = at_least_one(count);
    let value = (wrap(cell, count) as u64) << 32 | inside as u64;
    low_word(if count.is_power_of_two() { value >> count.trailing_zeros() } else { value / count as u64 })
}

/// The point at `inside` ∈ [0, 1)² of cell `cell`. An integer root and five 64-bit divisions.
#[inline]
#[must_use]
pub const fn place_2d(cell: u32, count: u32, inside: [u32; 2]) -> [u32; 2] {
    let count = at_least_one(count);
    let cell = wrap(cell, count) as u64;
    let count = count as u64;
    let rows = rows(count);
    // The last row r whose first cell ⌊r·count/rows⌋ is at most `cell`.
    let row = ((cell + 1) * rows - 1) / count;
    let first = row * count / rows;
    let cells = not_zero((row + 1) * count / rows - first);
    let x = ((cell - first) << 32 | inside[0] as u64) / cells;
    let y = ((first << 32) + cells * inside[1] as u64) / count;
    [low_word(x), low_word(y)]
}

/// Regular points: the corner of every cell, i/count.
#[inline]
#[must_use]
pub const fn regular_1d(index: u32, count: u32) -> u32 {
    place_1d(index, count, 0)
}

/// Regular points: the corner of every cell of the square.
#[inline]
#[must_use]
pub const fn regular_2d(index: u32, count: u32) -> [u32; 2] {
    place_2d(index, count, [0; 2])
}

/// Stratified (jittered) points: a random one in every cell.
#[inline]
#[must_use]
pub const fn jittered_1d(index: u32, count: u32, seed: u32) -> u32 {
    place_1d(index, count, crate::hash::combine(seed, index))
}

/// Stratified (jittered) points: a random one in every cell of the square.
#[inline]
#[must_use]
pub const fn jittered_2d(index: u32, count: u32, seed: u32) -> [u32; 2] {
    let x = crate::hash::combine(seed, index);
    place_2d(index, count, [x, crate::hash::mix(x)])
}

/// A random order of the cells: a bijection of 0..count for every seed; `index` is taken modulo `count`.
///
/// For count = 2ᵐ a shuffled, Owen-scrambled van der Corput sequence, so every run of 2ᵏ indices from a multiple of
/// 2ᵏ on spreads over all 2ᵏ parts. For other counts numbers that fall outside are mapped again until they fall inside
/// (cycle walking; less than two rounds in the mean), and a random shift modulo `count` makes up for it that such a
/// walk prefers some cells: over seeds every index meets every cell equally often.
#[inline]
#[must_use]
pub const fn permute(index: u32, count: u32, seed: u32) -> u32 {
    let count = at_least_one(count);
    let bits = u32::BITS - (count - 1).leading_zeros();
    if bits == 0 {
        return 0;
    }
    let seed = crate::hash::mix(seed);
    let mut cell = wrap(index, count);
    loop {
        // Without the shuffle the first digit of the cell would be the last of the index for every seed: two domains
        // of one pixel would see two of their four joint quadrants only.
        let order = crate::hash::shuffle(cell, seed);
        cell = crate::hash::laine_karras(order, seed).reverse_bits() >> (32 - bits);
        if cell < count {
            break;
        }
    }
    if count.is_power_of_two() {
        return cell;
    }
    turn(cell, count, crate::hash::mix(seed))
}

/// The cell that lies `by` ∈ [0, 1) of all cells further on, modulo `count`.
#[inline]
#[must_use]
pub const fn turn(cell: u32, count: u32, by: u32) -> u32 {
    let count = at_least_one(count);
    let sum = wrap(cell, count) as u64 + ((by as u64 * count as u64) >> 32);
    let count = count as u64;
    low_word(if sum < count { sum } else { sum - count })
}

/// √count rounded to the nearest: r(r+1) is the last count that rounds down to r.
const fn rows(count: u64) -> u64 {
    let root = count.isqrt();
    let rows = if count - root * root > root { root + 1 } else { root };
    not_zero(rows)
}

/// Says to the compiler what holds anyway, so that it drops the check before a division.
const fn not_zero(divisor: u64) -> u64 {
    if divisor == 0 { 1 } else { divisor }
}

/// The remainder, without a division where there is nothing to divide.
const fn wrap(cell: u32, count: u32) -> u32 {
    if cell < count { cell } else { cell % count }
}

const fn at_least_one(count: u32) -> u32 {
    if count == 0 { 1 } else { count }
}

#[expect(clippy::cast_possible_truncation, reason = "callers divide a number below count·2³² by count, or less")]
const fn low_word(value: u64) -> u32 {
    value as u32
}
