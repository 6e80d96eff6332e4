//! Seed permutation between frames (Heitz and Belcour 2019): blue-noise error at any number of dimensions and samples.
//!
//! Every pixel keeps a seed of its own, from which it draws all its numbers. After each frame the seeds change places:
//! ```text
//! sort:     in every block, the seed of the k-th darkest estimate goes to the pixel of k-th smallest rank in a mask
//! retarget: pairs of neighbours swap seeds, so that what was sorted for this frame's place of the mask fits the next's
//! ```
//! A seed that was dark here will be dark a few pixels away, so the next frame's errors follow the mask. On a smooth
//! wall (`tests/api/seeds.rs`) six frames leave .43 of white's filtered error with blocks of 4 pixels a side, and .53
//! without the second step; with 8 a side it is .39 and .36, since sorting alone moves seeds as far: there it helps
//! after wider filters only, .40 for .43 at 2.1 pixels. Both steps only permute: each seed is used once a frame, as it
//! was before, so estimates stay unbiased over random first seeds. (`cargo test --all-features --test api seeds:: --
//! --nocapture` prints the figures.)
//!
//! For paths of many bounces, where samplers have nothing to offer over several pixels. It needs frames that resemble
//! each other: after a cut it starts anew, and where the picture is rough, or moves by more than what is alike in it,
//! the error stays white; two pixels a frame take nothing in a smooth room. Best at one sample a pixel: of 16, less is
//! left to sort (.7 of white's filtered error instead of .55, in a small picture). The blocks begin elsewhere in every
//! frame.
//!
//! ```
//! use bluedither::{White, frames::seeds};
//!
//! let (width, height) = (100, 60);
//! let mut seeds: Vec<u32> = (0..width * height).collect();
//! for frame in 0..3 {
//!     // White is a function of its seed alone when the pixel is always the same.
//!     let trace = |&seed: &u32| White::new(seed).pixel(0, 0, 0).draw::<1>(0, 0)[0];
//!     let luminances: Vec<f32> = seeds.iter().map(trace).collect();
//!     seeds::permute::<8>(&mut seeds, &luminances, width, frame);
//! }
//! ```
//!
//! In place, without allocation, for pictures of any size: 64 seeds at a time are on the stack. Rows may be given in
//! parts, to [`sort`] and [`retarget`] themselves; of `retarget`, up to six rows at a cut then differ from what the
//! whole would give. Every frame costs a pass of sorting and three of swaps: `cargo run --release -p report -- frames`
//! prints nanoseconds a pixel.

use crate::tables::{SEED_PERMUTATION, THRESHOLD_64};

/// Which rows of a picture a slice holds: it may be a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rows {
    /// Pixels in a row. A row that the slice does not hold to its end is left as it is.
    pub width: u32,
    /// Number of the first row.
    pub first: u32,
}

/// Moves seeds from the places that they had in `frame` to those of the next one: [`sort`], then [`retarget`], of a
/// whole picture of `width` pixels a row.
///
/// SIDE is 2, 4 or 8. With 8, less error is left after a narrow filter by [`sort`] alone, and after a wide one by both.
///
/// `estimates` are what each pixel found in `frame`, as one number: its luminance, of one sample or of many. Infinite
/// and undefined ones are sorted as any other; pixels without one, past the slice's end, count as brightest.
#[inline]
pub fn permute<const SIDE: usize>(seeds: &mut [u32], estimates: &[f32], width: u32, frame: u32) {
    let rows = Rows { width, first: 0 };
    sort::<SIDE>(seeds, estimates, rows, frame);
    retarget(seeds, rows, frame);
}

/// Sorts the seeds of every block of SIDE×SIDE pixels, 2, 4 or 8 a side, by estimate, into the order of the mask.
///
/// 8 leaves the least error; 4 keeps seeds closer together, for pictures with detail.
///
/// Blocks at the ends of rows and of the slice are smaller. Parts of a picture give what the whole would if each begins
/// where [`begins_block`] says so.
pub fn sort<const SIDE: usize>(seeds: &mut [u32], estimates: &[f32], rows: Rows, frame: u32) {
    const { assert!(SIDE == 2 || SIDE == 4 || SIDE == 8, "blocks are 2, 4 or 8 pixels a side") };
    let (width, height) = extent(seeds.len(), rows);
    let [origin_x, origin_y] = origin::<SIDE>(frame);
    let mut top = 0;
    while top < height {
        let bottom =
            height.min(top + SIDE - (top.wrapping_add(rows.first as usize).wrapping_add(origin_y) & (SIDE - 1)));
        let mut left = 0;
        while left < width {
            let right = width.min(left + SIDE - (left.wrapping_add(origin_x) & (SIDE - 1)));
            sort_block::<SIDE>(seeds, estimates, rows, frame, [left, right], [top, bottom]);
            left = right;
        }
        top = bottom;
    }
}

/// Whether blocks of SIDE×SIDE pixels begin at that row in that frame.
#[inline]
#[must_use]
pub const fn begins_block<const SIDE: usize>(row: u32, frame: u32) -> bool {
    (row as usize).wrapping_add(origin::<SIDE>(frame)[1]) & (SIDE - 1) == 0
}

/// Swaps seeds between neighbours, at most 6 pixels along x or y in all, so that what stood in the order of `frame`
/// stands nearly in that of the next one.
///
/// The pairs are disjoint, so this is a bijection whatever part of the picture the slice holds: pairs that reach beyond
/// it stay.
#[expect(clippy::cast_possible_truncation, reason = "the mask repeats")]
pub fn retarget(seeds: &mut [u32], rows: Rows, frame: u32) {
    let (width, height) = extent(seeds.len(), rows);
    let [dx, dy] = SEED_PERMUTATION.place(frame);
    let mut round = 0;
    while round < SEED_PERMUTATION.rounds {
        let mut p = 0;
        let mut y = 0;
        while y < height {
            let mut x = 0;
            while x < width {
                let (tile_x, tile_y) = (dx.wrapping_add(x as u32), dy.wrapping_add(rows.first).wrapping_add(y as u32));
                if let Some((right, down)) = SEED_PERMUTATION.partner(round, tile_x, tile_y) {
                    let partner_x = x.wrapping_add_signed(right);
                    if partner_x < width && y + down < height {
                        swap(seeds, p, (y + down) * width + partner_x);
                    }
                }
                x += 1;
                p += 1;
            }
            y += 1;
        }
        round += 1;
    }
}

/// Rows that a slice of seeds holds: pixels in each, and their number.
fn extent(seeds: usize, rows: Rows) -> (usize, usize) {
    let width = rows.width as usize;
    (width, seeds.checked_div(width).unwrap_or(0))
}

/// How far blocks begin before the corner. Half a block from frame to frame: what had an edge between it then, is in
/// one block now.
const fn origin<const SIDE: usize>(frame: u32) -> [usize; 2] {
    let half = SIDE / 2;
    match frame & 3 {
        0 => [0, 0],
        1 => [half, half],
        2 => [0, half],
        _ => [half, 0],
    }
}

#[expect(clippy::cast_possible_truncation, reason = "the mask repeats")]
fn sort_block<const SIDE: usize>(
    seeds: &mut [u32],
    estimates: &[f32],
    rows: Rows,
    frame: u32,
    [left, right]: [usize; 2],
    [top, bottom]: [usize; 2],
) {
    let [dx, dy] = SEED_PERMUTATION.place(frame);
    // What is not filled comes last in either order.
    let (mut held, mut found, mut wanted) = ([[0; SIDE]; SIDE], [[i32::MAX; SIDE]; SIDE], [[i32::MAX; SIDE]; SIDE]);
    let all = held.as_flattened_mut().iter_mut().zip(found.as_flattened_mut()).zip(wanted.as_flattened_mut());
    for (((held, found), wanted), (x, y)) in all.zip(pixels([left, right], [top, bottom])) {
        let pixel = y * rows.width as usize + x;
        *held = seeds.get(pixel).copied().unwrap_or(0);
        *found = estimates.get(pixel).map_or(i32::MAX, |&estimate| ordered(estimate));
        let (x, y) = (dx.wrapping_add(x as u32), dy.wrapping_add(rows.first).wrapping_add(y as u32));
        *wanted = THRESHOLD_64.rank(x, y).into();
    }
    let mut sorted = [[0; SIDE]; SIDE];
    for (&seed, place) in held.as_flattened().iter().zip(places(&found).as_flattened()) {
        if let Some(seat) = sorted.as_flattened_mut().get_mut(place.cast_unsigned() as usize) {
            *seat = seed;
        }
    }
    for (place, (x, y)) in places(&wanted).as_flattened().iter().zip(pixels([left, right], [top, bottom])) {
        let seed = sorted.as_flattened().get(place.cast_unsigned() as usize);
        if let (Some(to), Some(&seed)) = (seeds.get_mut(y * rows.width as usize + x), seed) {
            *to = seed;
        }
    }
}

/// The pixels of a block, row by row.
fn pixels([left, right]: [usize; 2], [top, bottom]: [usize; 2]) -> impl Iterator<Item = (usize, usize)> {
    (top..bottom).flat_map(move |y| (left..right).map(move |x| (x, y)))
}

/// An integer that is in the order of the floats, those that are undefined at the ends.
const fn ordered(estimate: f32) -> i32 {
    let bits = estimate.to_bits().cast_signed();
    if bits < 0 { bits ^ i32::MAX } else { bits }
}

/// Every key's place in their order; of equal ones the first comes first. By counting, which has no branch.
fn places<const SIDE: usize>(keys: &[[i32; SIDE]; SIDE]) -> [[i32; SIDE]; SIDE] {
    let mut places = [[0; SIDE]; SIDE];
    let keys = keys.as_flattened();
    for (i, (place, &key)) in places.as_flattened_mut().iter_mut().zip(keys).enumerate() {
        let less: i32 = keys.iter().map(|&other| i32::from(other < key)).sum();
        let before = keys.get(..i).unwrap_or_default();
        *place = less + before.iter().map(|&other| i32::from(other == key)).sum::<i32>();
    }
    places
}

fn swap(seeds: &mut [u32], p: usize, q: usize) {
    if let (Some(&first), Some(&second)) = (seeds.get(p), seeds.get(q)) {
        for (pixel, seed) in [(p, second), (q, first)] {
            if let Some(to) = seeds.get_mut(pixel) {
                *to = seed;
            }
        }
    }
}

/// The swaps that turn the order of a mask into that of the same mask at the next frame's place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Retargeting {
    /// Pixels that the mask moves by in every frame.
    step: [u32; 2],
    rounds: u32,
    /// Four bits for each round: how many pixels further the partner is, in rows of five; 0 is none.
    codes: [[u16; 64]; 64],
}

impl Retargeting {
    /// For the table that build.rs writes.
    pub(crate) const fn new(step: [u32; 2], rounds: u32, codes: [[u16; 64]; 64]) -> Self {
        Self { step, rounds, codes }
    }

    /// Rounds of swaps, one after the other.
    #[inline]
    #[must_use]
    pub const fn rounds(&self) -> u32 {
        self.rounds
    }

    /// How far from the pixel itself the mask is read in a frame: pixels in x and y.
    #[inline]
    #[must_use]
    pub const fn place(&self, frame: u32) -> [u32; 2] {
        [frame.wrapping_mul(self.step[0]), frame.wrapping_mul(self.step[1])]
    }

    /// Pixels to the right (−2..=2) and down (0..=2) to the partner of a place in a round, if it has one there; of a
    /// pair, only the upper or left one has. Any coordinates; rounds past the last have no pairs.
    #[inline]
    #[must_use]
    pub const fn partner(&self, round: u32, x: u32, y: u32) -> Option<(isize, usize)> {
        if round >= self.rounds {
            return None;
        }
        let code = (self.codes[y as usize & 63][x as usize & 63] >> (4 * round) & 15) as usize;
        let down = (code + 2) / 5;
        if code == 0 { None } else { Some((code.cast_signed() - 5 * down.cast_signed(), down)) }
    }

    /// The table, row by row.
    #[inline]
    #[must_use]
    pub const fn codes(&self) -> &[[u16; 64]; 64] {
        &self.codes
    }
}
