//! Keys: look-ups, the net that they are over a tile, the columns that they come from, and the nets of every pixel.

use crate::analysis::net::assert_net;
use crate::analysis::random::Random;
use crate::bake::keys::{COLUMNS, Features, LANES, PREFIXES, anneal, keys, points, start, vectors};
use bluedither::tables::SEQUENCE;
use bluedither::{Keyed, Keys, White, unit};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

fn random_keys<const S: usize>(seed: u64) -> (Vec<[u16; 2]>, Keys<S>) {
    let mut random = Random::new(seed);
    let digits: Vec<[u16; 2]> = (0..S * S).map(|_| [random.bits_32() as u16, random.bits_32() as u16]).collect();
    let keys = Keys::from_slice(&digits).expect("as many as pixels");
    (digits, keys)
}

fn baked_keys<const S: usize>(seed: u64) -> Keys<S> {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let problem = Problem::recorded(S.ilog2());
    let mut numbers = start(S.ilog2(), &mut rng);
    anneal(&mut numbers, &problem.features, &problem.kernel, 2, &mut rng);
    let digits = keys(&SEQUENCE, &numbers, &mut rng);
    let pairs: Vec<[u16; 2]> = digits.chunks(2).map(|pair| [pair[0], pair[1]]).collect();
    Keys::from_slice(&pairs).expect("as many as pixels")
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

/// The definition: a pixel's first 2ᵏ samples are the first 2ᵏ points of the sequence, ⊕ its key, in some order.
#[test]
fn samples_are_points_of_the_sequence() {
    let (_, keys) = random_keys::<16>(3);
    for (seed, domain, frame) in [(0, 0, 0), (4, 5, 6), (u32::MAX, u32::MAX, u32::MAX)] {
        let [dx, dy] = bluedither::torus::offset(seed, domain, 0, frame, 4);
        for (x, y) in [(0, 0), (1, 0), (15, 3), (16, 16), (u32::MAX, 7)] {
            let pixel = Keyed::with_keys(&keys, seed).pixel(x, y, frame);
            let key = keys.key(x.wrapping_add(dx), y.wrapping_add(dy)).map(|key| key >> 16);
            for m in [0, 1, 4, 8, 11] {
                let sorted = |mut points: Vec<[u32; 2]>| {
                    points.sort_unstable();
                    points
                };
                let drawn = (0..1 << m).map(|i| pixel.draw_fx::<2>(domain, i).map(|v| v >> 16));
                let point = |i| SEQUENCE.packed(i);
                let expected = (0..1 << m).map(|i| [(point(i) >> 48) as u32, (point(i) >> 16 & 0xffff) as u32]);
                let expected = expected.map(|p| [p[0] ^ key[0], p[1] ^ key[1]]);
                assert_eq!(sorted(drawn.collect()), sorted(expected.collect()), "{x}, {y}: the first 2^{m}");
            }
        }
    }
}

/// Over a tile the first samples are a net of S² points, and so are the second ones: each channel is a permutation.
#[test]
fn a_tile_is_a_net() {
    fn check<const S: usize>() {
        let keys = baked_keys::<S>(4);
        for (seed, domain, frame) in [(0, 0, 0), (7, 3, 9)] {
            let sampler = Keyed::with_keys(&keys, seed);
            for index in [0, 1] {
                let point = |p: u32| sampler.pixel(p % S as u32, p / S as u32, frame).draw_fx::<2>(domain, index);
                let points: Vec<[u32; 2]> = (0..(S * S) as u32).map(point).collect();
                assert_net(&points, &format!("{S}²: sample {index} of all pixels"));
            }
        }
    }
    check::<64>();
    check::<128>();
}

/// So no threshold is biased, not in any one picture of a tile.
#[test]
fn thresholds_are_met_exactly() {
    let keys = baked_keys::<64>(5);
    for seed in 0..4 {
        let sampler = Keyed::with_keys(&keys, seed);
        for spp in [1, 2] {
            let pixel = |p: u32| (0..spp).flat_map(move |i| sampler.pixel(p % 64, p / 64, 3).draw_fx::<2>(1, i));
            let values: Vec<f64> = (0..4096).flat_map(pixel).map(unit::to_f64).collect();
            for k in 1..100 {
                let threshold = f64::from(k) / 100.0;
                for channel in 0..2 {
                    let below = values.iter().skip(channel).step_by(2).filter(|&&v| v < threshold).count() as f64;
                    let found = below / f64::from(4096 * spp);
                    assert!((found - threshold).abs() <= 1.0 / 4096.0, "{spp} spp: {found} below {threshold}");
                }
            }
        }
    }
}

/// Every patch of 16×16 pixels has the numbers that the columns say, mirrored and turned, in a coset of its own.
#[test]
fn patches_are_cosets() {
    for size_log2 in [6, 7] {
        let numbers = start(size_log2, &mut Xoshiro256PlusPlus::seed_from_u64(6));
        let mut sorted = numbers.clone();
        sorted.sort_unstable();
        assert!(sorted.iter().copied().eq(0..1 << (2 * size_log2)), "each number once");
        let naive = |x: u32, y: u32| {
            let bits = (0..4).flat_map(|bit| [x >> bit & 1, y >> bit & 1]);
            bits.zip(COLUMNS).filter(|(bit, _)| *bit == 1).fold(0, |sum, (_, column)| sum ^ column)
        };
        let patches = 1 << (size_log2 - 4);
        let mut turned = [0; 2];
        for patch in 0..patches * patches {
            let at = |x: u32, y: u32| {
                numbers[((patch / patches * 16 + y) << size_log2 | (patch % patches * 16 + x)) as usize]
            };
            let is = |turn: bool| {
                (0..256).all(|p| {
                    let (x, y) = (p % 16, p / 16);
                    at(x, y) ^ at(0, 0) == if turn { naive(y, x) } else { naive(x, y) }
                })
            };
            let found = [is(false), is(true)];
            assert_ne!(found[0], found[1], "patch {patch}");
            turned[usize::from(found[1])] += 1;
        }
        assert!(turned[0] > 3 && turned[1] > 3, "{turned:?}");
    }
}

/// What numbers are annealed with.
struct Problem {
    features: Vec<Vec<Features>>,
    kernel: Vec<i32>,
}

impl Problem {
    fn recorded(size_log2: u32) -> Self {
        let inputs = crate::recorded().1;
        let points = points(&SEQUENCE, 1 << (2 * size_log2));
        let block = |(columns, prefix)| vectors(&points, prefix as usize, columns, &inputs.cosine);
        let features = inputs.features_keys.chunks(LANES).zip(PREFIXES).map(block).collect();
        Self { features, kernel: inputs.anneal_kernel }
    }

    /// ⟨f_a, f_b⟩ of the vectors of two numbers, all prefixes.
    fn dot(&self, a: u32, b: u32) -> i64 {
        let vector = |g: usize, number: u32| self.features[g][(number / PREFIXES[g]) as usize].as_flattened();
        let dot = |g| vector(g, a).iter().zip(vector(g, b)).map(|(&x, &y)| i64::from(x) * i64::from(y)).sum::<i64>();
        (0..PREFIXES.len()).map(dot).sum()
    }

    /// Σ_q w(p−q)⟨f_number, f_q⟩ over the neighbours of a pixel: what it would add there.
    fn at(&self, numbers: &[u32], pixel: usize, number: u32) -> i64 {
        let size = numbers.len().isqrt() as i64;
        let (x, y) = (pixel as i64 % size, pixel as i64 / size);
        let mut sum = 0;
        for (dx, dy) in (-4..=4).flat_map(|dy| (-4..=4).map(move |dx| (dx, dy))) {
            let weight = self.kernel.get((dx * dx + dy * dy) as usize).copied().unwrap_or(0);
            if (dx, dy) != (0, 0) && weight != 0 {
                let q = (y + dy).rem_euclid(size) * size + (x + dx).rem_euclid(size);
                sum += i64::from(weight) * self.dot(number, numbers[q as usize]);
            }
        }
        sum
    }

    fn energy(&self, numbers: &[u32]) -> i64 {
        (0..numbers.len()).map(|pixel| self.at(numbers, pixel, numbers[pixel])).sum()
    }

    /// w(0)‖f‖², the mean over the blocks of every prefix.
    fn power(&self) -> i64 {
        let squares = |features: &Vec<Features>| {
            let all = features.as_flattened().as_flattened().iter();
            all.map(|&f| i64::from(f).pow(2)).sum::<i64>() * i64::from(self.kernel[0]) / features.len() as i64
        };
        self.features.iter().map(squares).sum()
    }

    /// The search as its words say, every change of the energy from scratch.
    fn twin(&self, numbers: &mut [u32], proposals: usize, rng: &mut Xoshiro256PlusPlus) -> usize {
        let size = numbers.len().isqrt();
        let place = |numbers: &[u32], number: u32| numbers.iter().position(|&n| n == number).expect("each number once");
        for number in 0..numbers.len() as u32 {
            let (p, q) = (place(numbers, number), place(numbers, number ^ (rng.next_u64() >> 62) as u32));
            numbers.swap(p, q);
        }
        let (power, mut swaps) = (self.power(), 0);
        for tried in 0..proposals * numbers.len() {
            let left = (proposals - 1 - tried / numbers.len()) as i64;
            let threshold = power * 50 * left * left / (1000 * (proposals * proposals) as i64);
            let bits = rng.next_u64();
            let p = (bits >> (64 - numbers.len().ilog2())) as usize;
            let reach = [3, 15, 63, u32::MAX][[48, 60, 62].iter().filter(|&&bound| bits >> 32 & 63 >= bound).count()];
            let (here, there) = (numbers[p], numbers[p] ^ bits as u32 & reach & (numbers.len() as u32 - 1));
            let q = place(numbers, there);
            let apart = |a: usize, b: usize| a.abs_diff(b).min(size - a.abs_diff(b));
            if apart(p % size, q % size) <= 4 && apart(p / size, q / size) <= 4 {
                continue;
            }
            let at = |pixel, number| self.at(numbers, pixel, number);
            if at(p, there) - at(p, here) + at(q, here) - at(q, there) < threshold {
                numbers.swap(p, q);
                swaps += 1;
            }
        }
        swaps
    }
}

#[test]
fn numbers_are_those_of_the_twin() {
    let problem = Problem::recorded(6);
    let seeded = || Xoshiro256PlusPlus::seed_from_u64(7);
    let (mut found, mut expected) = (start(6, &mut seeded()), start(6, &mut seeded()));
    anneal(&mut found, &problem.features, &problem.kernel, 2, &mut seeded());
    let swaps = problem.twin(&mut expected, 2, &mut seeded());
    assert!(swaps > 100, "{swaps} swaps show little");
    assert!(found == expected);
}

#[test]
fn more_proposals_lower_the_energy() {
    let problem = Problem::recorded(6);
    let energies = [0, 1, 10, 100].map(|proposals| {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(8);
        let mut numbers = start(6, &mut rng);
        anneal(&mut numbers, &problem.features, &problem.kernel, proposals, &mut rng);
        problem.energy(&numbers)
    });
    assert!(energies.is_sorted_by(|before, after| before > after), "{energies:?}");
}

/// The vectors in floating point, from the points themselves: each may be off by its rounding. Phases are those of
/// centres of cells of 2⁻¹⁰, which is part of the definition.
#[test]
fn features_are_sums_of_cosines() {
    let inputs = crate::recorded().1;
    // A larger tile has further points.
    let points = points(&SEQUENCE, 1 << 14);
    for (columns, prefix) in inputs.features_keys.chunks(LANES).zip(PREFIXES) {
        let found = vectors(&points, prefix as usize, columns, &inputs.cosine);
        for (block, vector) in points.chunks(prefix as usize).zip(&found) {
            for (column, &found) in columns.iter().zip(vector.as_flattened()) {
                assert_eq!(column.samples, prefix);
                let cosine = |k: u32, cell: u32| {
                    libm::cos(core::f64::consts::PI * f64::from(k) * (f64::from(cell) + 0.5) / 1024.0)
                };
                let product = |point: &u32| cosine(column.k[0], point >> 22) * cosine(column.k[1], point >> 6 & 1023);
                let sum: f64 = block.iter().map(product).sum();
                let scale = column.weight as f64 / 1024.0;
                // Two cosines of 2⁻¹⁴ and their interpolation, a shift, and the last rounding.
                let off = 0.5 + f64::from(prefix) * scale * 3.0 / 16_384.0;
                assert!((f64::from(found) - sum * scale).abs() <= off, "{column:?}: {found}, not {}", sum * scale);
                assert!(found.abs() < 64);
            }
        }
    }
}

/// No frame's joint error of two domains is better or worse than another's: every pixel has an order of its own. All
/// pixels in one order had 0 to .5 where white noise has .35, at 4 samples.
#[test]
fn the_joint_error_of_two_domains_is_white() {
    let keys = baked_keys::<64>(9);
    let (keyed, white) = (Keyed::with_keys(&keys, 3), White::new(3));
    let integrands: [fn(f64, f64) -> f64; 3] = [
        |a, b| f64::from(u8::from((a < 0.5) != (b < 0.5))) - 0.5,
        |a, b| f64::from(u8::from(a + b < 1.0)) - 0.5,
        |a, b| a * b - 0.25,
    ];
    for spp in [2, 4, 16, 64] {
        // The mean square error of a frame.
        let error = |draw: &dyn Fn(u32, u32, u32) -> [f64; 2]| {
            integrands.map(|integrand| {
                let value = |p, i| integrand(draw(p, 0, i)[0], draw(p, 1, i)[0]);
                let error = |p| (0..spp).map(|i| value(p, i)).sum::<f64>() / f64::from(spp);
                (0..4096).map(|p| error(p).powi(2)).sum::<f64>() / 4096.0
            })
        };
        let found =
            |frame| error(&|p, domain, i| keyed.pixel(p % 64, p / 64, frame).draw_fx::<2>(domain, i).map(unit::to_f64));
        let of_white = error(&|p, domain, i| white.pixel(p % 64, p / 64, 0).draw_fx::<2>(domain, i).map(unit::to_f64));
        let frames: Vec<[f64; 3]> = (0..16).map(found).collect();
        for (k, of_white) in of_white.into_iter().enumerate() {
            let ratios: Vec<f64> = frames.iter().map(|frame| frame[k] / of_white).collect();
            let mean = ratios.iter().sum::<f64>() / 16.0;
            println!("{spp} spp, integrand {k}: mean {mean:.3} of white, frames {ratios:.2?}");
            let (least, most) = ratios.iter().fold((f64::MAX, 0.0f64), |(a, b), &r| (a.min(r), b.max(r)));
            assert!(least > 0.85 * mean && most < 1.15 * mean, "{spp} spp, integrand {k}: {least} to {most}");
            assert!(mean < 1.2 && (k > 0 || mean > 0.9), "{spp} spp, integrand {k}: {mean} of white");
        }
    }
}
