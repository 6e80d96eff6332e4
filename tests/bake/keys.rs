//! Scrambling keys: tables, the structure that keys keep, and the search for ranks against brute force.

use crate::analysis::net::assert_net;
use crate::analysis::random::Random;
use crate::bake::keys::{Features, LANES, PREFIXES, choose_ranks, linear_digits, points, vectors};
use bluedither::tables::LINEAR_ORDER;
use bluedither::{Keyed, Keys, linear};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

fn random_keys<const S: usize>(seed: u64) -> (Vec<[u16; 2]>, Keys<S>) {
    let mut random = Random::new(seed);
    let digits: Vec<[u16; 2]> = (0..S * S).map(|_| [random.bits_32() as u16, random.bits_32() as u16]).collect();
    let keys = Keys::from_slice(&digits).expect("as many as pixels");
    (digits, keys)
}

#[test]
fn look_ups_wrap() {
    let (digits, table) = random_keys::<16>(1);
    for y in -40i32..40 {
        for x in -40i32..40 {
            let at = (y.rem_euclid(16) * 16 + x.rem_euclid(16)) as usize;
            let expected = digits[at].map(|digits| u32::from(digits) << 16);
            assert_eq!(table.key(x.cast_unsigned(), y.cast_unsigned()), expected);
        }
    }
    assert_eq!(Keys::<16>::from_slice(&digits[1..]), None);
    assert_eq!(size_of::<Keys<64>>(), 16_384);
    assert_eq!(size_of::<Keys<128>>(), 65_536);
}

#[test]
fn prefixes_are_nets() {
    let (_, keys) = random_keys::<64>(2);
    for (seed, domain) in [(0, 0), (1, 7), (9, 100)] {
        let pixel = Keyed::with_keys(&keys, seed).pixel(3, 5, 1);
        for m in 0..=11 {
            let points: Vec<[u32; 2]> = (0..1 << m).map(|i| pixel.draw_fx::<2>(domain, i)).collect();
            assert_net(&points, &format!("seed {seed}, the first 2^{m}"));
        }
    }
}

/// The definition: all pixels of a domain see one sequence in one order, each XORed with the key at its place. In the
/// lower digits they agree.
#[test]
fn pixels_differ_by_their_keys() {
    let (_, keys) = random_keys::<16>(3);
    for (seed, domain, frame) in [(0, 0, 0), (4, 5, 6), (u32::MAX, u32::MAX, u32::MAX)] {
        let sampler = Keyed::with_keys(&keys, seed);
        let [dx, dy] = bluedither::torus::offset(seed, domain, 0, frame, 4);
        let key = |x: u32, y: u32| keys.key(x.wrapping_add(dx), y.wrapping_add(dy));
        for index in (0..300).chain([1 << 20, u32::MAX]) {
            let at = |x, y| sampler.pixel(x, y, frame).draw_fx::<2>(domain, index);
            let (first, first_key) = (at(0, 0), key(0, 0));
            for (x, y) in [(1, 0), (0, 1), (15, 3), (16, 16), (u32::MAX, 7)] {
                let (sample, key) = (at(x, y), key(x, y));
                for k in 0..2 {
                    assert_eq!(sample[k] ^ first[k], key[k] ^ first_key[k], "sample {index} at {x}, {y}");
                }
            }
        }
    }
}

/// And the sequence is that of the linear order, whose first 2ᵏ points every domain visits first.
#[test]
fn samples_are_points_of_the_sequence() {
    let keys = Keys::<16>::from_slice(&[[0; 2]; 256]).expect("as many as pixels");
    for m in [0, 1, 4, 8, 11] {
        let pixel = Keyed::with_keys(&keys, 3).pixel(1, 2, 3);
        let sorted = |mut points: Vec<u64>| {
            points.sort_unstable();
            points
        };
        let drawn = (0..1 << m).map(|i| pixel.draw_fx::<2>(4, i).map(|v| v >> 16));
        let point = |i| LINEAR_ORDER.sequence.packed(i);
        let expected = (0..1 << m).map(|i| [point(i) >> 48, point(i) >> 16 & 0xffff]);
        assert_eq!(
            sorted(drawn.map(|[x, y]| u64::from(x) << 16 | u64::from(y)).collect()),
            sorted(expected.map(|[x, y]| x << 16 | y).collect()),
            "the first 2^{m}"
        );
    }
}

/// Why the table has no ranks: sample i ⊕ r under a key is sample i under the key ⊕ point r.
#[test]
fn a_rank_is_a_change_of_the_key() {
    let point = |i| LINEAR_ORDER.sequence.packed(i);
    let mut random = Random::new(4);
    for _ in 0..1000 {
        let (index, rank) = (random.bits_32(), random.bits_32());
        assert_eq!(point(index ^ rank), point(index) ^ point(rank));
    }
}

/// What ranks are searched with.
struct Problem {
    ranks_log2: u32,
    features: Vec<Vec<Features>>,
    kernel: Vec<i32>,
}

const SIZE_LOG2: u32 = 5;
const SIZE: i64 = 1 << SIZE_LOG2;

impl Problem {
    fn recorded(order: usize, ranks_log2: u32) -> Self {
        let inputs = crate::recorded().1;
        let order = &inputs.linear_order.orders[order];
        let digits = linear_digits(order, SIZE_LOG2, &mut Xoshiro256PlusPlus::seed_from_u64(5));
        let points = points(&LINEAR_ORDER.sequence, 1 << ranks_log2);
        let features = inputs
            .features_keys
            .chunks(LANES)
            .zip(PREFIXES)
            .filter(|(_, prefix)| *prefix < 1 << ranks_log2)
            .map(|(columns, prefix)| vectors(&digits, &points, prefix as usize, columns, &inputs.cosine))
            .collect();
        Self { ranks_log2, features, kernel: inputs.anneal_kernel }
    }

    fn choose(&self, proposals: usize, seed: u64) -> Vec<u8> {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        choose_ranks(SIZE_LOG2, self.ranks_log2, &self.features, &self.kernel, proposals, &mut rng)
    }

    fn vector(&self, g: usize, pixel: i64, rank: u8) -> Vec<i64> {
        let blocks = (1 << self.ranks_log2) / PREFIXES[g] as usize;
        let number = pixel as usize * blocks + usize::from(rank) / PREFIXES[g] as usize;
        self.features[g][number].as_flattened().iter().map(|&f| i64::from(f)).collect()
    }

    /// The terms of Σ_{p,q} w(p−q)⟨f_p, f_q⟩ in which a pixel takes part.
    fn around(&self, ranks: &[u8], pixel: i64) -> i64 {
        let (x, y) = (pixel % SIZE, pixel / SIZE);
        let mut sum = 0;
        for g in 0..self.features.len() {
            let own = self.vector(g, pixel, ranks[pixel as usize]);
            for dy in -4..=4i64 {
                for dx in -4..=4i64 {
                    let Some(&weight) = self.kernel.get((dx * dx + dy * dy) as usize) else { continue };
                    let q = (y + dy).rem_euclid(SIZE) * SIZE + (x + dx).rem_euclid(SIZE);
                    let dot: i64 = own.iter().zip(self.vector(g, q, ranks[q as usize])).map(|(a, b)| a * b).sum();
                    sum += i64::from(weight) * dot * if q == pixel { 1 } else { 2 };
                }
            }
        }
        sum
    }

    /// What a pixel alone adds to half the energy, the mean over all vectors of a prefix.
    fn power(&self) -> i64 {
        let halves = |features: &[Features]| {
            let squares = features.iter().map(|f| f.as_flattened().iter().map(|&f| i64::from(f).pow(2)).sum::<i64>());
            squares.map(|square| square * i64::from(self.kernel[0]) / 2).sum::<i64>() / features.len() as i64
        };
        self.features.iter().map(|features| halves(features)).sum()
    }

    fn energy(&self, ranks: &[u8]) -> i64 {
        let all = |ranks: &[u8], pixel| {
            let once: i64 = (0..self.features.len())
                .map(|g| {
                    let own = self.vector(g, pixel, ranks[pixel as usize]);
                    own.iter().map(|f| f * f).sum::<i64>() * i64::from(self.kernel[0])
                })
                .sum();
            (self.around(ranks, pixel) + once) / 2
        };
        (0..SIZE * SIZE).map(|pixel| all(ranks, pixel)).sum()
    }

    /// The search as its words say, every change of the energy from scratch. Ranks, and how often one changed.
    fn twin(&self, proposals: usize, seed: u64) -> (Vec<u8>, usize) {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut ranks: Vec<u8> = (0..SIZE * SIZE).map(|_| (rng.next_u64() >> 62) as u8).collect();
        let mut changes = 0;
        let power = self.power();
        for tried in 0..proposals * ranks.len() {
            let left = (proposals - 1 - tried / ranks.len()) as i64;
            // Of what both sides of a pair gain.
            let threshold = power * 20 * left * left / (1000 * (proposals * proposals) as i64);
            let bits = rng.next_u64();
            let pixel = (bits >> (64 - 2 * SIZE_LOG2)) as usize;
            let reach = [3, 3, 15, 255][(bits >> 8 & 3) as usize] & ((1 << self.ranks_log2) - 1);
            let before = self.around(&ranks, pixel as i64);
            let kept = ranks[pixel];
            ranks[pixel] ^= (bits & reach) as u8;
            if self.around(&ranks, pixel as i64) < before + 2 * threshold {
                changes += 1;
            } else {
                ranks[pixel] = kept;
            }
        }
        (ranks, changes)
    }
}

#[test]
fn ranks_are_those_of_the_twin() {
    for (order, ranks_log2) in [(linear::ORDERS - 1, 6), (2, 2), (4, 4)] {
        let problem = Problem::recorded(order, ranks_log2);
        let (expected, changes) = problem.twin(20, 7);
        assert!(changes > 50, "{changes} changes show little");
        assert!(problem.choose(20, 7) == expected, "ranks below 2^{ranks_log2}");
    }
}

#[test]
fn more_proposals_lower_the_energy() {
    let problem = Problem::recorded(linear::ORDERS - 1, 6);
    let energies = [0, 1, 10, 100].map(|proposals| problem.energy(&problem.choose(proposals, 8)));
    assert!(energies.is_sorted_by(|before, after| before > after) && energies[3] > 0, "{energies:?}");
}

/// Every patch has the digits of one set, turned or not, but for a shift: found by trying all, from the columns alone.
#[test]
fn patches_are_parts_of_the_linear_order() {
    const SIDE: u32 = 16;
    let order = &LINEAR_ORDER.progressive;
    let digits = linear_digits(order, 7, &mut Xoshiro256PlusPlus::seed_from_u64(9));
    let naive = |set: &linear::Columns, x: u32, y: u32| {
        let bits = (0..5).flat_map(|bit| [x >> bit & 1, y >> bit & 1]);
        bits.zip(set).filter(|(bit, _)| *bit == 1).fold(0, |sum, (_, column)| sum ^ column)
    };
    let (mut seen, mut shifts) = ([[0; 2]; linear::SETS], Vec::new());
    for patch in 0..64 {
        let (left, top) = (patch % 8 * SIDE, patch / 8 * SIDE);
        let digits = |x: u32, y: u32| digits[((top + y) * 128 + left + x) as usize];
        let mut found = 0;
        for (set, seen) in order.iter().zip(&mut seen) {
            for (turned, seen) in seen.iter_mut().enumerate() {
                let is = |p: u32| {
                    let (x, y) = (p % SIDE, p / SIDE);
                    digits(x, y) ^ digits(0, 0) == if turned == 1 { naive(set, y, x) } else { naive(set, x, y) }
                };
                if (0..SIDE * SIDE).all(is) {
                    found += 1;
                    *seen += 1;
                }
            }
        }
        assert_eq!(found, 1, "patch {patch}");
        shifts.push(digits(0, 0));
    }
    assert!(seen.iter().all(|set| set[0] + set[1] > 0), "sets are left out: {seen:?}");
    assert!(seen.iter().map(|set| set[1]).sum::<i32>().abs_diff(32) < 16, "turned: {seen:?}");
    shifts.sort_unstable();
    shifts.dedup();
    assert_eq!(shifts.len(), 64, "a shift of its own for every patch");
}

/// Every pixel's 64 samples are a net, whatever its rank, and so are its digits' blocks of 4 and 16.
#[test]
fn ranks_keep_nets() {
    let digits = linear_digits(&LINEAR_ORDER.progressive, 4, &mut Xoshiro256PlusPlus::seed_from_u64(10));
    let points = points(&LINEAR_ORDER.sequence, 64);
    for (pixel, digits) in digits.iter().enumerate().step_by(17) {
        for rank in [0, 5, 62] {
            for m in 0..=6 {
                let point = |i: usize| points[i ^ rank] ^ digits;
                let set: Vec<[u32; 2]> =
                    (0..1 << m).map(point).map(|point| [point & 0xffff_0000, point << 16]).collect();
                assert_net(&set, &format!("pixel {pixel}, rank {rank}, the first 2^{m}"));
            }
        }
    }
}

/// The vectors in floating point, from the points themselves: each may be off by its rounding. Phases are those of
/// centres of cells of 2⁻¹⁰, which is part of the definition.
#[test]
fn features_are_sums_of_cosines() {
    let inputs = crate::recorded().1;
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(6);
    let digits: Vec<u32> = (0..64).map(|_| rng.next_u64() as u32).collect();
    let points = points(&LINEAR_ORDER.sequence, 64);
    for (columns, prefix) in inputs.features_keys.chunks(LANES).zip(PREFIXES) {
        let found = vectors(&digits, &points, prefix as usize, columns, &inputs.cosine);
        let blocks = 64 / prefix as usize;
        for (number, vector) in found.iter().enumerate() {
            let first = number % blocks * prefix as usize;
            for (column, &found) in columns.iter().zip(vector.as_flattened()) {
                assert_eq!(column.samples, prefix);
                let sum: f64 = points[first..first + prefix as usize]
                    .iter()
                    .map(|point| {
                        let cosine = |k: u32, cell: u32| {
                            libm::cos(core::f64::consts::PI * f64::from(k) * (f64::from(cell) + 0.5) / 1024.0)
                        };
                        let place = point ^ digits[number / blocks];
                        cosine(column.k[0], place >> 22) * cosine(column.k[1], place >> 6 & 1023)
                    })
                    .sum();
                let scale = column.weight as f64 / 1024.0;
                // Two cosines of 2⁻¹⁴ and their interpolation, a shift, and the last rounding.
                let off = 0.5 + f64::from(prefix) * scale * 3.0 / 16_384.0;
                assert!((f64::from(found) - sum * scale).abs() <= off, "{column:?}: {found}, not {}", sum * scale);
                assert!(found.abs() < 64);
            }
        }
    }
}

/// A baked table has the linear order's sets: with 64 samples it is that order.
#[cfg(feature = "keys-64")]
#[test]
fn baked_keys_are_the_linear_order_with_ranks() {
    use crate::bake::recipe::{Kind, Recipe};
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(Recipe { kind: Kind::Keys, size_log2: 6 }.seed());
    let digits = linear_digits(&LINEAR_ORDER.progressive, 6, &mut rng);
    let points = points(&LINEAR_ORDER.sequence, 64);
    let mut seen = [0u32; 64];
    for (p, digits) in (0..).zip(digits) {
        let [x, y] = bluedither::tables::KEYS_64.key(p % 64, p / 64);
        let rank = points.iter().position(|point| point ^ digits == x | y >> 16);
        seen[rank.expect("a rank below 64")] += 1;
    }
    assert!(seen.iter().filter(|&&count| count > 0).count() > 32, "the search has done little: {seen:?}");
}
