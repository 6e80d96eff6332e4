//! What is searched for: a row for each digit of each number, by which it is a parity of bits of the sample's number,
//! of the place inside a block and of the block's place.

use bluedither::net::{DIGITS, Digits, Order};

use crate::random::Random;

pub const NUMBERS: usize = 8;
pub const ROWS: usize = DIGITS as usize;

/// One row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// Bits of the sample's number.
    pub samples: u16,
    /// Bits of the place inside a block, then of the block's on the curve: a Walsh function.
    pub place: u16,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Map(pub [[Row; ROWS]; NUMBERS]);

impl Map {
    /// Sobol's first two matrices for every pair, scrambled at random; places at random.
    pub fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let row = |number: usize, digit: usize, place: usize| {
            // The unit matrix; Pascal's triangle modulo 2, odd where the digit is a subset of the bit (Lucas).
            let samples = if number % 2 == 0 {
                1 << digit
            } else {
                (0..ROWS).filter(|bit| bit & digit == digit).fold(0, |row, bit| row | 1 << bit)
            };
            Row { samples, place: place as u16 }
        };
        let mut map =
            Self(core::array::from_fn(|number| core::array::from_fn(|digit| row(number, digit, random.below(1024)))));
        for pair in 0..NUMBERS / 2 {
            for _ in 0..200 {
                map.add_row(2 * pair + random.below(2), ROWS, &mut random);
            }
            for _ in 0..if pair == 0 { 0 } else { 150 } {
                map.add_column(pair, ROWS, &mut random);
            }
        }
        map
    }

    /// Adds a row to a later one, of the first `rows`: every net stays one.
    pub fn add_row(&mut self, number: usize, rows: usize, random: &mut Random) {
        let to = 1 + random.below(rows - 1);
        let from = random.below(to);
        self.0[number][to].samples ^= self.0[number][from].samples;
    }

    /// Adds a column to a later one, of the first `columns`, in both numbers of a pair: every run of 2^m samples stays
    /// the same set of this pair.
    pub fn add_column(&mut self, pair: usize, columns: usize, random: &mut Random) {
        let to = 1 + random.below(columns - 1);
        let from = random.below(to);
        for number in [2 * pair, 2 * pair + 1] {
            for row in &mut self.0[number] {
                row.samples ^= (row.samples >> from & 1) << to;
            }
        }
    }

    /// The columns: the transpose.
    pub fn order(&self) -> Order {
        let column = |bit: &dyn Fn(Row) -> u16| -> Digits {
            core::array::from_fn(|pair| {
                (0..ROWS).fold(0, |word, digit| {
                    let of = |number: usize| u32::from(bit(self.0[number][digit]) & 1);
                    word | of(2 * pair) << (31 - digit) | of(2 * pair + 1) << (15 - digit)
                })
            })
        };
        Order {
            samples: core::array::from_fn(|k| column(&|row| row.samples >> k)),
            inside: core::array::from_fn(|k| column(&|row| row.place >> k)),
            place: core::array::from_fn(|k| column(&|row| row.place >> (4 + k))),
        }
    }
}
