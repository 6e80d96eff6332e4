//! The predicted error of an integrand of several numbers after a filter: a sum over the characters that the samples of
//! a pixel leave over, of the power they have times what the filter leaves of their functions of the place.
//!
//! Own pairs count by integrands of two numbers and of five, pairs across, triples and fours by integrands of several.

use crate::map::{Map, NUMBERS};
use crate::power::{COUNTS, DIGITS, Family};

/// What is trained for.
#[derive(Debug)]
pub struct Training {
    /// Half-planes, smooth functions; each of a pair.
    pub pair: [Family; 2],
    /// Half-spaces in three and five numbers, smooth functions of five.
    pub several: [Family; 3],
}

/// W after a Gaussian of 1 pixel that counts as 1, at 1, 2, 4, …, 256 samples, and the weight: half-planes and smooth
/// functions of an own pair, half-planes of a pair across, half-spaces in three and five numbers, smooth ones in five,
/// light where one number picks a half and a pair a point of it.
const GOALS: [([f64; COUNTS], f64); 7] = [
    ([0.60, 0.66, 0.70, 0.71, 0.71, 0.72, 0.70, 0.70, 0.70], 1.2),
    ([0.42, 0.42, 0.42, 0.42, 0.36, 0.32, 0.24, 0.24, 0.24], 1.1),
    ([0.72, 0.73, 0.73, 0.68, 0.58, 0.50, 0.44, 0.40, 0.38], 0.8),
    ([0.70, 0.74, 0.76, 0.73, 0.68, 0.62, 0.58, 0.55, 0.52], 0.4),
    ([0.70, 0.77, 0.79, 0.78, 0.75, 0.69, 0.65, 0.62, 0.60], 1.3),
    ([0.62, 0.58, 0.56, 0.48, 0.40, 0.32, 0.22, 0.18, 0.15], 1.0),
    ([0.68, 0.66, 0.62, 0.55, 0.48, 0.42, 0.36, 0.34, 0.32], 1.2),
];

/// Power of the characters that matter at 2^m samples.
#[derive(Debug)]
pub struct Model<'a> {
    m: usize,
    /// Digits that are looked at in pairs, triples and fours: of few samples the first ones.
    digits: [usize; 3],
    mains: Vec<f32>,
    own: Vec<f32>,
    across: Vec<f32>,
    triples: Vec<f32>,
    /// Of a number and an own pair, in this order.
    picked: Vec<f32>,
    fours: Vec<f32>,
    costs: &'a [f32],
}

const PAIR: usize = DIGITS[1];
const TRIPLE: usize = DIGITS[2];
const FOUR: usize = DIGITS[3];

fn add(to: &mut [f32], from: &[f32], factor: f64) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to += factor as f32 * from);
}

impl<'a> Model<'a> {
    /// With characters of four numbers or without, which take most of the time.
    pub fn new(training: &Training, m: usize, fours: bool, costs: &'a [f32]) -> Self {
        let mut model = Self {
            m,
            digits: [
                [6, 6, 7, 7, 8, 9, 9, 10, 10][m],
                [4, 4, 4, 5, 5, 5, 6, 6, 6][m],
                if fours && m >= 3 { FOUR } else { 0 },
            ],
            mains: vec![0.0; 1 << DIGITS[0]],
            own: vec![0.0; 1 << (2 * PAIR)],
            across: vec![0.0; 1 << (2 * PAIR)],
            triples: vec![0.0; 1 << (3 * TRIPLE)],
            picked: Vec::new(),
            fours: vec![0.0; 1 << (4 * FOUR)],
            costs,
        };
        let weight =
            |goal: usize, family: &Family| GOALS[goal].1 / (GOALS[goal].0[m] * GOALS[goal].0[m] * family.white[m]);
        let [half_planes, smooth] = &training.pair;
        // In the mean over the four own pairs, over the 24 pairs across, over all sets of numbers.
        for (goal, family) in [(0, half_planes), (1, smooth)] {
            add(&mut model.mains, &family.power[0], weight(goal, family) / 4.0);
            add(&mut model.own, &family.power[1], weight(goal, family) / 4.0);
        }
        add(&mut model.mains, &half_planes.power[0], weight(2, half_planes) / 4.0);
        add(&mut model.across, &half_planes.power[1], weight(2, half_planes) / 24.0);
        for (goal, family) in (3..).zip(&training.several) {
            let (n, weight) = (family.dimensions as f64, weight(goal, family));
            add(&mut model.mains, &family.power[0], weight * n / 8.0);
            add(&mut model.own, &family.power[1], weight * n * (n - 1.0) / 56.0);
            add(&mut model.across, &family.power[1], weight * n * (n - 1.0) / 56.0);
            add(&mut model.triples, &family.power[2], weight * n * (n - 1.0) * (n - 2.0) / 336.0);
            add(&mut model.fours, &family.power[3], weight * n * (n - 1.0) * (n - 2.0) * (n - 3.0) / 1680.0);
        }
        model.add_light(half_planes, weight(6, &training.several[0]) / 24.0);
        model
    }

    /// Half-planes in either half, unrelated: half of their power goes with the first digit of the number that picks.
    fn add_light(&mut self, half_planes: &Family, weight: f64) {
        let [mains, pairs, ..] = &half_planes.power;
        add(&mut self.mains, mains, 6.0 * weight);
        add(&mut self.own, pairs, 3.0 * weight);
        self.mains[1] += 0.08 * weight as f32;
        self.picked = self.triples.clone();
        for c in 1..1 << PAIR {
            // Their mains have more digits than pairs.
            let half = 0.5 * weight as f32 * mains[c];
            self.across[1 | c << PAIR] += half;
            self.across[c | 1 << PAIR] += half;
        }
        for c in 1..1 << TRIPLE {
            for e in 1..1 << TRIPLE {
                self.picked[1 | c << TRIPLE | e << (2 * TRIPLE)] += 0.5 * weight as f32 * pairs[c | e << PAIR];
            }
        }
    }

    /// Tables of a number: for every set of digits the bits of a sample's number (lower half) and the function of the
    /// place (upper half) that they sum up to; and the sets of pairs' digits by the former.
    pub fn sums(&self, map: &Map, number: usize) -> Sums {
        let mask = (1u32 << self.m) - 1;
        let mut of = vec![0u32; 1 << DIGITS[0]];
        for c in 1..of.len() {
            let row = map.0[number][c.trailing_zeros() as usize];
            of[c] = of[c & (c - 1)] ^ (u32::from(row.samples) & mask | u32::from(row.place) << 16);
        }
        let mut by_samples = vec![Vec::new(); 1 << self.m];
        (1..1usize << self.digits[0]).for_each(|c| by_samples[(of[c] & mask) as usize].push(c as u32));
        Sums { of, by_samples }
    }

    /// The part of a set of one to four numbers.
    pub fn part(&self, sums: &[Sums], set: &[usize]) -> f64 {
        let first = |factor: f64, rest: f64| if set.iter().all(|&number| number < 5) { factor } else { rest };
        match *set {
            [a] => self.main(&sums[a]),
            [a, b] => first(1.3, 0.8) * self.pair(&sums[a], &sums[b], a / 2 == b / 2),
            [a, b, c] if a / 2 == b / 2 => first(1.8, 0.8) * self.triple([&sums[c], &sums[a], &sums[b]], &self.picked),
            [a, b, c] => {
                let power = if b / 2 == c / 2 { &self.picked } else { &self.triples };
                first(1.8, 0.8) * self.triple([&sums[a], &sums[b], &sums[c]], power)
            }
            [a, b, c, d] => first(2.0, 0.8) * self.four([&sums[a], &sums[b], &sums[c], &sums[d]]),
            _ => 0.0,
        }
    }

    fn main(&self, sums: &Sums) -> f64 {
        let mask = (1u32 << self.m) - 1;
        let left = sums.of.iter().zip(&self.mains).filter(|(sum, _)| **sum & mask == 0);
        left.map(|(sum, power)| f64::from(power * self.costs[(sum >> 16) as usize])).sum()
    }

    fn pair(&self, a: &Sums, b: &Sums, own: bool) -> f64 {
        let power = if own { &self.own } else { &self.across };
        (1..1 << self.digits[0]).map(|c| self.rest(a.of[c], b, c, PAIR, power)).sum()
    }

    fn triple(&self, [a, b, c]: [&Sums; 3], power: &[f32]) -> f64 {
        let side = 1 << self.digits[1];
        let mut sum = 0.0;
        for i in 1..side {
            for j in 1..side {
                sum += self.rest(
                    a.of[i] ^ b.of[j],
                    c,
                    i | j << TRIPLE,
                    2 * TRIPLE,
                    &power[..1 << (2 * TRIPLE + self.digits[1])],
                );
            }
        }
        sum
    }

    fn four(&self, [a, b, c, d]: [&Sums; 4]) -> f64 {
        let side = 1 << self.digits[2];
        let mut sum = 0.0;
        for i in 1..side {
            for j in 1..side {
                for k in 1..side {
                    let place = i | j << FOUR | k << (2 * FOUR);
                    sum += self.rest(a.of[i] ^ b.of[j] ^ c.of[k], d, place, 3 * FOUR, &self.fours);
                }
            }
        }
        sum
    }

    /// The characters of a last number that leave nothing of a sample's number together with `before`.
    #[inline]
    fn rest(&self, before: u32, last: &Sums, place: usize, shift: usize, power: &[f32]) -> f64 {
        let mut sum = 0f32;
        for &c in &last.by_samples[(before & ((1 << self.m) - 1)) as usize] {
            // In ascending order: what is behind has more digits than the power tells.
            let Some(power) = power.get(place | (c as usize) << shift) else { break };
            sum += power * self.costs[((before ^ last.of[c as usize]) >> 16) as usize];
        }
        f64::from(sum)
    }
}

/// See [`Model::sums`].
#[derive(Clone, Debug)]
pub struct Sums {
    of: Vec<u32>,
    by_samples: Vec<Vec<u32>>,
}

/// All sets of one to four numbers.
pub fn sets() -> Vec<Vec<usize>> {
    let members = |bits: usize| (0..NUMBERS).filter(|number| bits >> number & 1 == 1).collect::<Vec<_>>();
    (1..1 << NUMBERS).map(members).filter(|set| set.len() <= 4).collect()
}
