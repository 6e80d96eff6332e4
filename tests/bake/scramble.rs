//! The scramble of the sequence that `ZOrder` deals out: which digits take one from digits above, found again.

use bluedither::{sobol, zorder};

use crate::columns::anneal::Random;
use crate::columns::net::{Candidates, ROWS, Rows};
use crate::columns::power::{DIGITS, Power};

const LAGS: [u32; 4] = [1, 2, 4, 8];

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

/// What a pixel, a square of 2×2 and one of 4×4 leave over, at up to 256 samples: half-planes first, and of smooth
/// integrands no more than Owen-scrambled points do.
fn near(candidates: &[Candidates], scramble: &Scramble) -> f64 {
    let of = |(m, k): (usize, usize)| {
        let [half_planes, smooth] = candidates[(m + 2 * k).min(8)].left_over(&rows(scramble, m, k));
        [1.0, 0.8, 0.5][k] * (4.0 * libm::log(half_planes) + libm::log(smooth.max(0.3)))
    };
    (0..9).flat_map(|m| (0..3).map(move |k| (m, k))).map(of).sum()
}

/// What a pixel leaves over at 2⁹ to 2¹³ samples, by the power of smooth integrands in general: 4^−Σj for the digits j of a
/// character (Goda, Ohori, Suzuki and Yoshiki 2016), whose sum over the dual net is a mean over the points; and up to
/// 2²⁰ by that of linear ones.
fn far(scramble: &Scramble) -> f64 {
    let mut sums = [0.0; 14];
    let weights: Vec<f64> = (1..=26).map(|digit| libm::pow(0.25, f64::from(digit))).collect();
    for index in 0..1u32 << 13 {
        let factor = |number: u32| {
            let signed = weights.iter().zip(0..).map(|(w, digit)| if number << digit >> 31 == 1 { -w } else { *w });
            signed.fold(1.0, |product, w| product * (1.0 + w))
        };
        let product: f64 = point(scramble, index).into_iter().map(factor).product();
        let first = (u32::BITS - index.leading_zeros()) as usize;
        sums[first..].iter_mut().for_each(|sum| *sum += product - 1.0);
    }
    let smooth: f64 = (9..14).map(|m| libm::log((sums[m] / f64::from(1 << m)).max(1e-15))).sum();
    let linear = |m: u32| {
        let all = (0..m).map(|bit| point(scramble, 1 << bit)).fold([0; 2], |all, p| [all[0] | p[0], all[1] | p[1]]);
        let constant = all.iter().map(|digits| digits.leading_ones()).map(|j| libm::pow(0.25, f64::from(j)));
        libm::log(constant.sum::<f64>())
    };
    smooth + (14..21).map(linear).sum::<f64>()
}

#[test]
#[ignore = "searches for a minute"]
fn frozen_scramble_is_what_the_search_finds() {
    use rayon::prelude::*;
    let candidates = Candidates::all(&Power::of_training());
    let found: Vec<(f64, Scramble)> = (0..4).into_par_iter().map(|seed| find(&candidates, seed)).collect();
    let (_, best) = found.into_iter().reduce(|a, b| if b.0 < a.0 { b } else { a }).expect("there is one");
    for bit in 0..32 {
        assert_eq!(zorder::point(1 << bit), point(&best, 1 << bit), "the search finds {best:#018x?}");
    }
}

/// From masks at random: the first digits for few samples, then the others for many.
fn find(candidates: &[Candidates], seed: u64) -> (f64, Scramble) {
    let mut random = Random::new(seed);
    // A digit that is there, in both numbers.
    let both = |digits: u32| u64::from(digits) << 32 | u64::from(digits);
    let start = LAGS.map(|lag| (0..64).fold(0, |word, _| word << 1 | random.below(2) as u64) & both(!0 >> lag));
    let (cost, first) = anneal(start, [0, DIGITS], 3000, &mut random, |scramble| near(candidates, scramble));
    (cost, anneal(first, [DIGITS, 26], 800, &mut random, far).1)
}

/// Simulated annealing of the masks' bits for a range of digits.
fn anneal(
    mut scramble: Scramble,
    [from, to]: [usize; 2],
    steps: usize,
    random: &mut Random,
    cost: impl Fn(&Scramble) -> f64,
) -> (f64, Scramble) {
    let mut current = cost(&scramble);
    let mut best = (current, scramble);
    for step in 0..steps {
        let before = scramble;
        for _ in 0..1 + random.below(2) {
            let k = random.below(LAGS.len());
            let from = from.max(LAGS[k] as usize);
            let digit = from + random.below(to - from);
            scramble[k] ^= 1 << (63 - digit - 32 * random.below(2));
        }
        let new = cost(&scramble);
        let left = 1.0 - step as f64 / steps as f64;
        if new - current < -0.6 * left * left * libm::log(random.uniform().max(1e-12)) {
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
