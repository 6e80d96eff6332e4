//! Retargeting of seeds (Heitz and Belcour 2019): swaps that turn a mask into the same mask, moved.
//!
//! ```text
//! now = mask, then = mask moved by STEP
//! three rounds: of all pairs at most 2 pixels apart along x and y, by the gain of a swap,
//!               (now_p − now_q)·(then_q − then_p), the largest first: swap if neither has been
//! ```
//! Each round is a set of disjoint pairs: an involution, in place, on any part of a plane. Rounds of longer reach bring
//! the masks closer (after two of 6 pixels .02 of the range apart instead of .04) and rendered pictures further away: a
//! seed means less where it came from afar.

/// Pixels that the mask moves by in every frame: odd, so that its places repeat after 64 frames only.
pub const STEP: [usize; 2] = [21, 37];
/// Rounds of swaps.
pub const ROUNDS: u32 = 3;
/// Pixels along x or y.
const REACH: usize = 2;

/// Four bits a round for every pixel of a mask of 64² pixels: a code of 5·down + right, in −2..=2, for the upper or
/// left one of a pair; 0 for the other and for those that stay.
pub fn retargeting(mask: &[u16]) -> Vec<u16> {
    let mut now: Vec<i32> = mask.iter().map(|&rank| i32::from(rank)).collect();
    let then: Vec<i32> = (0..4096).map(|p| i32::from(mask[further(p, STEP[0], STEP[1])])).collect();
    let mut codes = vec![0; 4096];
    let mut round = 0;
    while round < ROUNDS {
        // The largest gain first, the first pixel wins ties.
        let mut pairs: Vec<u64> = Vec::with_capacity(4096 * 12);
        let mut p = 0;
        while p < 4096 {
            let mut code = 1;
            while code <= 5 * REACH + REACH {
                let q = partner(p, code);
                let gain = (now[p] - now[q]) * (then[q] - then[p]);
                if gain > 0 {
                    pairs.push(u64::from(!gain.cast_unsigned()) << 16 | (p << 4 | code) as u64);
                }
                code += 1;
            }
            p += 1;
        }
        pairs.sort_unstable();
        let mut swapped = [false; 4096];
        let mut i = 0;
        while i < pairs.len() {
            let (p, code) = (pairs[i] as usize >> 4 & 4095, pairs[i] as usize & 15);
            let q = partner(p, code);
            if !swapped[p] && !swapped[q] {
                (swapped[p], swapped[q]) = (true, true);
                now.swap(p, q);
                codes[p] |= (code as u16) << (4 * round);
            }
            i += 1;
        }
        round += 1;
    }
    codes
}

/// The pixel that a code means.
fn partner(p: usize, code: usize) -> usize {
    let down = (code + REACH) / 5;
    further(p, (code + 64 - 5 * down) & 63, down)
}

/// The pixel so far to the right and down on the torus.
fn further(p: usize, right: usize, down: usize) -> usize {
    let (x, y) = (p % 64 + right, p / 64 + down);
    y % 64 * 64 + x % 64
}
