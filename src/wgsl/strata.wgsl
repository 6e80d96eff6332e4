// Strata: the unit interval or square cut into `count` cells of equal size, for any `count`; 0 counts as 1, and a cell
// is taken modulo `count`. Values are 0.32 fixed point. As `bluedither::strata`.

// The point at `inside` of cell `cell`.
fn bd_strata_place_1d(cell: u32, count: u32, inside: u32) -> u32 {
    let divisor = max(count, 1u);
    return bd_wide_divide(vec2<u32>(inside, cell % divisor), divisor).x;
}

// The point at `inside` of cell `cell` of the square.
fn bd_strata_place_2d(cell: u32, count: u32, inside: vec2<u32>) -> vec2<u32> {
    let all = max(count, 1u);
    let place = cell % all;
    let rows = bd_strata_rows(all);
    // The last row whose first cell is at most `place`.
    let row = bd_wide_divide(bd_wide_add(bd_wide_product(place, rows), vec2<u32>(rows - 1u, 0u)), all).x;
    let first = bd_wide_divide(bd_wide_product(row, all), rows).x;
    let cells = bd_wide_divide(bd_wide_product(row + 1u, all), rows).x - first;
    let x = bd_wide_divide(vec2<u32>(inside.x, place - first), cells).x;
    let y = bd_wide_divide(bd_wide_product(cells, inside.y) + vec2<u32>(0u, first), all).x;
    return vec2<u32>(x, y);
}

// Regular points: the corner of every cell.
fn bd_strata_regular_1d(index: u32, count: u32) -> u32 {
    return bd_strata_place_1d(index, count, 0u);
}

fn bd_strata_regular_2d(index: u32, count: u32) -> vec2<u32> {
    return bd_strata_place_2d(index, count, vec2<u32>(0u));
}

// Stratified (jittered) points: a random one in every cell.
fn bd_strata_jittered_1d(index: u32, count: u32, seed: u32) -> u32 {
    return bd_strata_place_1d(index, count, bd_hash_combine(seed, index));
}

fn bd_strata_jittered_2d(index: u32, count: u32, seed: u32) -> vec2<u32> {
    let x = bd_hash_combine(seed, index);
    return bd_strata_place_2d(index, count, vec2<u32>(x, bd_hash_mix(x)));
}

// A random order of the cells.
fn bd_strata_permute(index: u32, count: u32, seed: u32) -> u32 {
    let all = max(count, 1u);
    if all == 1u {
        return 0u;
    }
    let unused = countLeadingZeros(all - 1u);
    let own = bd_hash_mix(seed);
    var cell = index % all;
    loop {
        let order = bd_hash_shuffle(cell, own);
        cell = reverseBits(bd_hash_laine_karras(order, own)) >> unused;
        if cell < all {
            break;
        }
    }
    if (all & (all - 1u)) == 0u {
        return cell;
    }
    return bd_strata_turn(cell, all, bd_hash_mix(own));
}

// The cell that lies `by` of all cells further on.
fn bd_strata_turn(cell: u32, count: u32, by: u32) -> u32 {
    let all = max(count, 1u);
    let start = cell % all;
    let steps = bd_wide_product(by, all).y;
    // Without the sum, which may need 33 bits.
    let left = all - start;
    return select(steps - left, start + steps, steps < left);
}

// The root of `count`, rounded to the nearest. The float is off by less than one.
fn bd_strata_rows(count: u32) -> u32 {
    var root = min(u32(sqrt(f32(count))), 65535u);
    if root * root > count {
        root -= 1u;
    }
    if count - root * root > 2u * root {
        root += 1u;
    }
    return select(root, root + 1u, count - root * root > root);
}
