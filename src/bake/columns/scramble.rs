//! The search for the scramble of the sequence that `ZOrder` deals out: which digits take one from digits above.

use rayon::prelude::*;

use super::anneal::Random;
use super::cooling::cool;
use super::net::{Candidates, ROWS, Rows};
use super::power::{DIGITS, Power};
use crate::{sobol, zorder};

/// How far above the digits are that others take one from.
const LAGS: [u32; 4] = [1, 2, 4, 8];
/// Digits that are searched for. What lies below is less than 2⁻²⁶.
const JUDGED: usize = 26;
/// Independent searches, the best of which counts.
const ISLANDS: u64 = 4;
/// For the first digits, whose costs take milliseconds, and for the others, which are more and matter less.
const STEPS: [usize; 2] = [3000, 800];
/// The first temperature, in the logarithms that costs are.
const HEAT: f64 = 0.6;
/// What a pixel, a square of 2×2 and one of 4×4 count: a Gaussian of 1 pixel sees the first two best.
const SQUARES: [f64; 3] = [1.0, 0.8, 0.5];
/// What half-planes count beside smooth integrands, which are easy.
const HALF_PLANES: f64 = 4.0;
/// Power of smooth integrands, Owen-scrambled points 1, below which no more is asked of them.
const ENOUGH: f64 = 0.3;

/// For each lag the digits of both numbers, the first in the upper half, that take one from so far above.
pub type Scramble = [u64; LAGS.len()];

/// As `zorder::point`, by any scramble.
pub fn point(scramble: &Scramble, index: u32) -> [u32; 2] {
    let [x, y] = sobol::point(index);
    let word = u64::from(x) << 32 | u64::from(y);
    let word = scramble.iter().zip(LAGS).fold(word, |word, (taken, lag)| word ^ word >> lag & taken);
    [(word >> 32) as u32, word as u32]
}

/// Finds it, with its cost at few samples: half a minute.
pub fn find(power: &Power) -> (f64, Scramble) {
    let candidates = Candidates::all(power);
    let found: Vec<(f64, Scramble)> = (0..ISLANDS).into_par_iter().map(|seed| island(&candidates, seed)).collect();
    found.into_iter().reduce(|a, b| if b.0 < a.0 { b } else { a }).expect("there is an island")
}

/// From words at random: the first digits for few samples, then the others for many.
fn island(candidates: &[Candidates], seed: u64) -> (f64, Scramble) {
    let mut random = Random::new(seed);
    // A digit that is there, in both numbers.
    let both = |digits: u32| u64::from(digits) << 32 | u64::from(digits);
    let start = LAGS.map(|lag| (0..64).fold(0, |word, _| word << 1 | random.below(2) as u64) & both(!0 >> lag));
    let near = |scramble: &Scramble| near(candidates, scramble);
    let (cost, first) = cool(start, STEPS[0], HEAT, &mut random, flip([0, DIGITS]), near);
    (cost, cool(first, STEPS[1], HEAT, &mut random, flip([DIGITS, JUDGED]), far).1)
}

/// Another bit or two, for a range of digits.
fn flip([from, to]: [usize; 2]) -> impl Fn(&mut Scramble, &mut Random) {
    move |scramble, random| {
        for _ in 0..1 + random.below(2) {
            let k = random.below(LAGS.len());
            let from = from.max(LAGS[k] as usize);
            let digit = from + random.below(to - from);
            scramble[k] ^= 1 << (63 - digit - 32 * random.below(2));
        }
    }
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

/// What a pixel and squares of them leave over, at up to 256 samples. More points than that, of squares, are rated by the
/// power of 256.
fn near(candidates: &[Candidates], scramble: &Scramble) -> f64 {
    let of = |(m, k): (usize, usize)| {
        let [half_planes, smooth] = candidates[(m + 2 * k).min(8)].left_over(&rows(scramble, m, k));
        SQUARES[k] * (HALF_PLANES * libm::log(half_planes) + libm::log(smooth.max(ENOUGH)))
    };
    (0..9).flat_map(|m| (0..SQUARES.len()).map(move |k| (m, k))).map(of).sum()
}

/// What a pixel leaves over at 2⁹ to 2¹³ samples, by the power of smooth integrands in general: 4^−Σj for the digits j of a
/// character (Goda, Ohori, Suzuki and Yoshiki 2016), whose sum over the dual net is a mean over the points; and up to
/// 2²⁰ by that of linear ones.
fn far(scramble: &Scramble) -> f64 {
    let mut sums = [0.0; 14];
    let weights: Vec<f64> = (1..=JUDGED).map(|digit| libm::pow(0.25, digit as f64)).collect();
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
