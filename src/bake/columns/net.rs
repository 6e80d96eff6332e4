//! The sequence: rows of Sobol's matrices, scrambled, and the characters that its prefixes leave over.

use super::anneal::{Map, Random, sums};
use super::power::{DIGITS, Power, SIDE};
use super::{COUNTS, FAMILIES};
use crate::hash;

/// Digits that pixels flip, of which the searches change the first [`DIGITS`]; further ones are scrambled at random.
pub const ROWS: usize = 16;
/// For each number and digit, the bits of a sample's number below 256 that flip it.
pub type Rows = [[u16; ROWS]; 2];

/// Power beyond the characters of a list, in parts of the error of Owen-scrambled points.
const CUT: f32 = 0.05;

/// Sobol's first two matrices: the unit matrix and Pascal's triangle.
pub fn sobol(seed: u64) -> Rows {
    let mut random = Random::new(seed);
    let mut rows = [[0; ROWS]; 2];
    let [first, second] = &mut rows;
    for (j, (x, y)) in first.iter_mut().zip(second).enumerate() {
        // Below the digits that are looked at, any sum of rows is as good.
        *x = if j < DIGITS { (1u32 << j & 0xff) as u16 } else { random.below(256) as u16 };
        *y = if j < DIGITS { pascal(j) } else { random.below(256) as u16 };
    }
    rows
}

/// Bit b is C(b, j) modulo 2.
fn pascal(j: usize) -> u16 {
    // Odd where j is a subset of b (Lucas).
    (0..8).filter(|b| b & j == j).fold(0, |row, b| row | 1 << b)
}

/// The rows for the first 2^`m` samples.
pub fn prefix(rows: &Rows, m: usize) -> Rows {
    rows.map(|numbers| numbers.map(|row| row & ((1u32 << m) - 1) as u16))
}

/// What a move does: adds a row to a later one, which keeps every net a net.
pub fn add_a_row(rows: &mut Rows, random: &mut Random) {
    let number = random.below(2);
    let to = 1 + random.below(DIGITS - 1);
    let from = random.below(to);
    rows[number][to] ^= rows[number][from];
}

/// The columns of the whole sequence: the rows as scrambled rows of Sobol's matrices, completed at random.
pub fn sequence(rows: &Rows) -> [[u32; 2]; 32] {
    let base = sobol(0);
    let mut columns = [[0; 2]; 32];
    for number in 0..2 {
        for digit in 0..32 {
            // Bit i: Sobol's digit i is added to this digit.
            let mut scramble = hash::combine(number as u32, digit as u32) & ((1u32 << digit) - 1) & !0xff | 1 << digit;
            if digit < ROWS {
                let mut left = rows[number][digit] ^ if digit < 8 { base[number][digit] } else { 0 };
                for (i, row) in base[number].iter().enumerate().take(8) {
                    if left >> i & 1 == 1 {
                        left ^= row;
                        scramble |= 1 << i;
                    }
                }
                assert!(left == 0 && (digit >= 8 || scramble >> digit == 1), "the scramble is triangular");
            } else {
                scramble |= hash::combine(number as u32 + 2, digit as u32) & 0xff;
            }
            for (bit, column) in columns.iter_mut().enumerate() {
                let point = crate::sobol::point(1 << bit)[number];
                let sum = (0..32).filter(|i| scramble >> i & 1 == 1 && point << i >> 31 == 1).count();
                column[number] |= u32::from(sum % 2 == 1) << (31 - digit);
            }
        }
    }
    columns
}

/// The characters that 2^m samples leave over, with their power.
pub struct Duals {
    /// Sets of digits of both numbers, the strongest first.
    pub characters: Vec<[u16; 2]>,
    /// Power for half-planes and smooth integrands.
    pub power: Vec<[f32; FAMILIES]>,
    /// Power of those left out.
    pub rest: [f64; FAMILIES],
}

impl Duals {
    /// Of one set of rows.
    pub fn new(power: &Power, m: usize, rows: &Rows) -> Self {
        Candidates::new(power, m).duals(rows)
    }

    /// Power of the filtered error: what `response` leaves of each character.
    pub fn filtered(&self, map: &Map, response: &[f32]) -> [f64; FAMILIES] {
        let sums = map.each_ref().map(sums);
        let mut total = self.rest;
        for (c, power) in self.characters.iter().zip(&self.power) {
            let left = response[usize::from(sums[0][usize::from(c[0])] ^ sums[1][usize::from(c[1])])];
            total = [total[0] + f64::from(power[0] * left), total[1] + f64::from(power[1] * left)];
        }
        total
    }
}

/// The characters that matter at 2^m samples, whatever the rows.
pub struct Candidates(Duals);

impl Candidates {
    /// The strongest ones, up to a cut.
    pub fn new(power: &Power, m: usize) -> Self {
        let families = power.at.each_ref().map(|family| &family[m]);
        let total = |c: usize| families[0][c] + families[1][c];
        let mut order: Vec<u32> = (1..(SIDE * SIDE) as u32).collect();
        order.sort_unstable_by(|&a, &b| total(b as usize).total_cmp(&total(a as usize)).then(a.cmp(&b)));
        // One in 2^m is in a dual net.
        let mut left = order.iter().rev().map(|&c| total(c as usize)).sum::<f32>() / (1 << m) as f32;
        let mut keep = 0;
        while keep < order.len() && left > CUT {
            left -= total(order[keep] as usize) / (1 << m) as f32;
            keep += 1;
        }
        let powers = |c: &u32| families.map(|family| family[*c as usize]);
        let rest = order[keep..].iter().map(powers).fold([0.0; FAMILIES], |sum, p| {
            [sum[0] + f64::from(p[0]) / (1 << m) as f64, sum[1] + f64::from(p[1]) / (1 << m) as f64]
        });
        order.truncate(keep);
        let characters = order.iter().map(|&c| [(c as usize % SIDE) as u16, (c as usize / SIDE) as u16]).collect();
        Self(Duals { characters, power: order.iter().map(powers).collect(), rest })
    }

    /// Of all numbers of samples.
    pub fn all(power: &Power) -> Vec<Self> {
        use rayon::prelude::*;
        (0..COUNTS).into_par_iter().map(|m| Self::new(power, m)).collect()
    }

    /// Those that points with these rows leave over.
    pub fn duals(&self, rows: &Rows) -> Duals {
        let sums = rows.each_ref().map(sums);
        let Self(all) = self;
        let mut left = Duals { characters: Vec::new(), power: Vec::new(), rest: all.rest };
        for (c, power) in all.characters.iter().zip(&all.power) {
            if sums[0][usize::from(c[0])] == sums[1][usize::from(c[1])] {
                left.characters.push(*c);
                left.power.push(*power);
            }
        }
        left
    }

    /// Power of what they leave over: the squared error of unfiltered pixels, Owen-scrambled points 1.
    pub fn left_over(&self, rows: &Rows) -> [f64; FAMILIES] {
        let sums = rows.each_ref().map(sums);
        let Self(all) = self;
        let mut total = all.rest;
        for (characters, powers) in all.characters.chunks(256).zip(all.power.chunks(256)) {
            let mut part = [0f32; FAMILIES];
            for (c, power) in characters.iter().zip(powers) {
                let on = f32::from(u8::from(sums[0][usize::from(c[0])] == sums[1][usize::from(c[1])]));
                part = [part[0] + on * power[0], part[1] + on * power[1]];
            }
            total = [total[0] + f64::from(part[0]), total[1] + f64::from(part[1])];
        }
        total
    }
}
