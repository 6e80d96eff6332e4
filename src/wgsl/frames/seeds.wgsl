// Seed permutation between frames: what its pass is made of. As `bluedither::frames::seeds`; the swaps come from a
// function that you write, or take with `shader::SEED_SWAPS`:
//     fn bd_seeds_load(x: u32, y: u32) -> u32 // of x and y below 64

// How far from the pixel itself the mask is read in a frame: pixels in x and y.
fn bd_seeds_place(frame: u32) -> vec2<u32> {
    return frame * vec2<u32>(21u, 37u);
}

// Pixels to the right and down to the partner of a place in a round, 0 and 0 if it has none there.
fn bd_seeds_partner(round_: u32, x: u32, y: u32) -> vec2<i32> {
    if round_ >= 3u {
        return vec2<i32>(0);
    }
    let code = i32((bd_seeds_load(x & 63u, y & 63u) >> (4u * round_)) & 15u);
    let down = (code + 2) / 5;
    return vec2<i32>(code - 5 * down, down);
}

// Whether blocks of `side` x `side` pixels begin at that row in that frame.
fn bd_seeds_begins_block(side: u32, row: u32, frame: u32) -> bool {
    return ((row + bd_seeds_origin(side, frame).y) & (side - 1u)) == 0u;
}

// How far blocks begin before the corner.
fn bd_seeds_origin(side: u32, frame: u32) -> vec2<u32> {
    let half = side / 2u;
    switch frame & 3u {
        case 0u: {
            return vec2<u32>(0u);
        }
        case 1u: {
            return vec2<u32>(half);
        }
        case 2u: {
            return vec2<u32>(0u, half);
        }
        default: {
            return vec2<u32>(half, 0u);
        }
    }
}

// An integer that is in the order of the floats whose bits are given.
fn bd_seeds_ordered(estimate: u32) -> i32 {
    return bitcast<i32>(select(estimate, estimate ^ 0x7fffffffu, estimate >= 0x80000000u));
}
