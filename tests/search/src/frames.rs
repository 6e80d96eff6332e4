//! Columns for frames where the number of samples is not known: 2^m samples of 8^k frames are a net together, for all m
//! and k, and one sample of 1, 2 or 4 frames.
//!
//! Read a sample's number as a polynomial over GF(2), bit j for t^j: digits of an own pair are its power series at t =
//! 0 and at t = 1 (Sobol's first two matrices). With p = t³ + t + 1, which has an inverse at both, frames are taken as
//! Σ aₖ/p^(k+1) with numerators below degree 3: together with the samples they span all polynomials below degree m + 3k
//! over p^k. The map's scrambles of digits apply to both.

use bluedither::net::{Digits, FRAMES};

use crate::map::{Map, NUMBERS, ROWS};

/// Rows of bits.
type Matrix = [u16; ROWS];

/// For every bit of a frame.
pub fn columns(map: &Map) -> [Digits; FRAMES] {
    let scrambles = scrambles(map);
    core::array::from_fn(|bit| {
        let series = [series_at_0(bit), series_at_1(bit)];
        let digit = |number: usize, digit: usize| (scrambles[number][digit] & series[number % 2]).count_ones() & 1;
        core::array::from_fn(|pair| {
            (0..ROWS).fold(0, |word, j| word | digit(2 * pair, j) << (31 - j) | digit(2 * pair + 1, j) << (15 - j))
        })
    })
}

/// Of t^a / p^b at t = 0.
fn series_at_0(bit: usize) -> u16 {
    series(1 << (bit % 3), power(0b1011, bit / 3 + 1))
}

/// The same at t = 1, where t is u + 1 and p is u³ + u² + 1.
fn series_at_1(bit: usize) -> u16 {
    series(power(0b11, bit % 3), power(0b1101, bit / 3 + 1))
}

/// The first digits of a quotient, bit j that of t^j; the divisor is odd.
fn series(numerator: u64, divisor: u64) -> u16 {
    let (mut rest, mut quotient) = (numerator, 0);
    for j in 0..ROWS {
        if rest >> j & 1 == 1 {
            quotient |= 1 << j;
            rest ^= divisor << j;
        }
    }
    quotient
}

fn power(polynomial: u64, exponent: usize) -> u64 {
    let times = |product: u64| (0..4).filter(|j| polynomial >> j & 1 == 1).fold(0, |sum, j| sum ^ product << j);
    (0..exponent).fold(1, |product, _| times(product))
}

/// The lower triangular scrambles of a map: its rows are scramble · Sobol's · the columns' changes of the pair.
fn scrambles(map: &Map) -> [Matrix; NUMBERS] {
    let rows = |number: usize| -> Matrix { map.0[number].map(|row| row.samples) };
    let pascal: Matrix = core::array::from_fn(|j| (0..ROWS).filter(|b| b & j == j).fold(0, |row, b| row | 1 << b));
    core::array::from_fn(|number| {
        let (lower, upper) = triangles(rows(number & !1));
        if number % 2 == 0 { lower } else { times(times(rows(number), inverse(upper)), inverse(pascal)) }
    })
}

/// A matrix as the product of a lower and an upper triangular one.
fn triangles(matrix: Matrix) -> (Matrix, Matrix) {
    let (mut lower, mut upper): (Matrix, Matrix) = (unit(), matrix);
    for column in 0..ROWS {
        for row in column + 1..ROWS {
            if upper[row] >> column & 1 == 1 {
                upper[row] ^= upper[column];
                lower[row] |= 1 << column;
            }
        }
    }
    (lower, upper)
}

/// Of an upper triangular matrix.
fn inverse(upper: Matrix) -> Matrix {
    let (mut rest, mut inverse) = (upper, unit());
    for row in (0..ROWS).rev() {
        for column in row + 1..ROWS {
            if rest[row] >> column & 1 == 1 {
                rest[row] ^= rest[column];
                inverse[row] ^= inverse[column];
            }
        }
    }
    inverse
}

fn unit() -> Matrix {
    core::array::from_fn(|j| 1 << j)
}

fn times(a: Matrix, b: Matrix) -> Matrix {
    a.map(|row| (0..ROWS).filter(|j| row >> j & 1 == 1).fold(0, |sum, j| sum ^ b[j]))
}
