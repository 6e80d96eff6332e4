//! The scramble of the sequence that `ZOrder` deals out: which digits take one from digits above, found again.

use bluedither::{sobol, zorder};

use crate::columns::anneal::Random;
use crate::columns::net::{Candidates, ROWS, Rows};
use crate::columns::power::{DIGITS, Power};

const LAGS: [u32; 4] = [1, 2, 4, 8];
const STEPS: usize = 3000;

/// For each lag the digits of both numbers, the first in the upper half, that take one from so far above.
type Scramble = [u64; LAGS.len()];

/// As `zorder::point`, by any scramble.
fn point(scramble: &Scramble, index: u32) -> [u32; 2] {
    let [x, y] = sobol::point(index);
    let word = u64::from(x) << 32 | u64::from(y);
    let word = scramble.iter().zip(LAGS).fold(word, |word, (mask, lag)| word ^ word >> lag & mask);
    [(word >> 32) as u32, word as u32]
}

/// The first 2ᵐ samples of a square of 2ᵏ×2ᵏ pixels.
fn rows(scramble: &Scramble, m: usize, k: usize) -> Rows {
    let samples = (0..m).map(|bit| 1 << bit);
    let places = (0..2 * k).map(|bit| zorder::first_index((1u32 << bit).reverse_bits()));
    let mut rows = [[0; ROWS]; 2];
    for (bit, index) in samples.chain(places).enumerate() {
        for (row, number) in rows.iter_mut().zip(point(scramble, index)) {
            row.iter_mut().zip(0..).for_each(|(row, digit)| *row |= ((number << digit >> 31) as u16) << bit);
        }
    }
    rows
}

/// What a pixel, a square of 2×2 and one of 4×4 leave over, over all numbers of samples: half-planes first, and of smooth
/// integrands no more than Owen-scrambled points do.
fn cost(candidates: &[Candidates], scramble: &Scramble) -> f64 {
    let of = |(m, k): (usize, usize)| {
        let [half_planes, smooth] = candidates[(m + 2 * k).min(8)].left_over(&rows(scramble, m, k));
        [1.0, 0.8, 0.5][k] * (4.0 * half_planes.ln() + smooth.max(0.3).ln())
    };
    (0..9).flat_map(|m| (0..3).map(move |k| (m, k))).map(of).sum()
}

#[test]
#[ignore = "searches for a minute"]
fn the_scramble_is_what_the_search_finds() {
    use rayon::prelude::*;
    let candidates = Candidates::all(&Power::of_training());
    let found: Vec<(f64, Scramble)> = (0..4).into_par_iter().map(|seed| find(&candidates, seed)).collect();
    let (_, best) = found.into_iter().reduce(|a, b| if b.0 < a.0 { b } else { a }).expect("there is one");
    for bit in 0..32 {
        assert_eq!(zorder::point(1 << bit), point(&best, 1 << bit), "the search finds {best:#018x?}");
    }
}

/// Simulated annealing of the first digits, from masks at random.
fn find(candidates: &[Candidates], seed: u64) -> (f64, Scramble) {
    let mut random = Random::new(seed);
    // A digit that is there, in both numbers.
    let both = |digits: u32| u64::from(digits) << 32 | u64::from(digits);
    let mut scramble = LAGS.map(|lag| (0..64).fold(0, |word, _| word << 1 | random.below(2) as u64) & both(!0 >> lag));
    let mut current = cost(candidates, &scramble);
    let mut best = (current, scramble);
    for step in 0..STEPS {
        let before = scramble;
        for _ in 0..1 + random.below(2) {
            let k = random.below(LAGS.len());
            let digit = LAGS[k] + random.below(DIGITS - LAGS[k] as usize) as u32;
            scramble[k] ^= 1 << (63 - digit - 32 * random.below(2) as u32);
        }
        let new = cost(candidates, &scramble);
        let left = 1.0 - step as f64 / STEPS as f64;
        if new - current < -0.6 * left * left * random.uniform().max(1e-12).ln() {
            current = new;
            if current < best.0 {
                best = (current, scramble);
            }
        } else {
            scramble = before;
        }
    }
    best
}
