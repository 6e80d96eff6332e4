//! Smooth functions of many dimensions: products and sums of two soft steps, waves and bumps along random directions.

use super::family::Id;
use super::ridges::Ridges;
use crate::analysis::random::Random;

/// Functions of one family.
pub const COUNT: usize = Id::Smooth5.count();
const _: () = assert!(COUNT == Id::Smooth8.count() && COUNT.is_multiple_of(12), "a third of each kind, in fours");
const THIRD: usize = COUNT / 3;

/// Of each function two factors: a step and a wave, a wave and a bump, a bump and a step.
#[derive(Debug)]
pub struct Smooth {
    factors: [Ridges<COUNT>; 2],
}

#[derive(Clone, Copy)]
enum Kind {
    Step,
    Wave,
    Bump,
}

/// The factors of each third of the functions.
const KINDS: [[Kind; 3]; 2] = [[Kind::Step, Kind::Wave, Kind::Bump], [Kind::Wave, Kind::Bump, Kind::Step]];

impl Smooth {
    /// `dimensions` says in which of eight the directions of function k lie.
    pub fn new(random: &mut Random, mut dimensions: impl FnMut(&mut Random, usize) -> Vec<usize>) -> Self {
        let sets: Vec<Vec<usize>> = (0..COUNT).map(|k| dimensions(random, k)).collect();
        let factors = KINDS.map(|kinds| {
            Ridges::new(|k| {
                let mut normal = [0.0; 8];
                sets[k].iter().for_each(|&d| normal[d] = random.normal());
                let length = normal.iter().map(|a| a * a).sum::<f64>().sqrt();
                // Through a random point, which is the middle of the step, the wave's zero or the top of the bump.
                let distance: f64 = normal.iter().map(|a| a / length * random.between(0.2, 0.8)).sum();
                let (scale, offset) = match kinds[k / THIRD] {
                    Kind::Step => (1.0 / random.between(0.5, 1.0), 0.5),
                    Kind::Wave => (random.between(0.4, 1.0), 0.0),
                    Kind::Bump => (1.0 / random.between(0.8, 1.4), 0.0),
                };
                (normal.map(|a| a / length * scale), offset - distance * scale)
            })
        });
        Self { factors }
    }

    /// The value of each function at a point; every fourth is a sum.
    #[inline(always)]
    pub fn at(&self, x: &[f32; 8]) -> [f32; COUNT] {
        let [mut a, mut b] = self.factors.each_ref().map(|ridges| ridges.at(x));
        for (values, kinds) in [(&mut a, KINDS[0]), (&mut b, KINDS[1])] {
            for (part, kind) in values.chunks_exact_mut(THIRD).zip(kinds) {
                match kind {
                    Kind::Step => part.iter_mut().for_each(|t| *t = smooth_step(*t)),
                    Kind::Wave => part.iter_mut().for_each(|t| *t = wave(*t)),
                    Kind::Bump => part.iter_mut().for_each(|t| *t = bump(*t)),
                }
            }
        }
        core::array::from_fn(|k| if k % 4 == 3 { a[k] + b[k] } else { a[k] * b[k] })
    }
}

/// From 0 to 1 while t does, with level ends.
#[inline(always)]
pub fn smooth_step(t: f32) -> f32 {
    // Not `clamp`: these two are one instruction each.
    let t = if t > 0.0 { t } else { 0.0 };
    let t = if t < 1.0 { t } else { 1.0 };
    t * t * (3.0 - 2.0 * t)
}

/// A period of 1 between −1 and 1: parabolas that meet with their slopes, twice bent into a sine's shape.
#[inline(always)]
fn wave(t: f32) -> f32 {
    // To the nearest integer, by a sum that has no room for digits after the point.
    const ROUND: f32 = 12_582_912.0;
    let t = t - ((t + ROUND) - ROUND);
    let parabola = 8.0 * t * (1.0 - 2.0 * t.abs());
    parabola * (0.775 + 0.225 * parabola.abs())
}

/// 1 at 0, down to 0 at −1 and 1, twice differentiable.
#[inline(always)]
fn bump(t: f32) -> f32 {
    let height = 1.0 - t * t;
    let height = if height > 0.0 { height } else { 0.0 };
    height * height * height
}
