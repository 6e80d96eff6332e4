//! The annealer against a twin that packs nothing and keeps no field, and the features that it is fed.

use bluedither::{lattice, sobol};
use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

use crate::bake::anneal::{Features, LANES, anneal};
use crate::bake::features::{Column, Pattern, value_order, value_set, vectors};
use crate::bake::inputs::Inputs;
use crate::bake::recipe::OFFSET_TIME_KERNEL;

impl Inputs {
    fn columns(&self, pattern: Pattern) -> &[Column] {
        match pattern {
            Pattern::Regular => &self.features_1d,
            Pattern::Sobol => &self.features_2d,
            Pattern::Lattice => &self.features_lattice,
        }
    }
}

const PATTERNS: [Pattern; 3] = [Pattern::Regular, Pattern::Sobol, Pattern::Lattice];

fn channels(pattern: Pattern) -> usize {
    if pattern == Pattern::Regular { 1 } else { 2 }
}

/// What a tile, or one for every frame, is annealed with.
struct Problem {
    size_log2: u32,
    frames_log2: u32,
    time_kernel: Vec<i32>,
    features: Vec<Features>,
    order: Vec<u16>,
    kernel: Vec<i32>,
}

impl Problem {
    fn recorded(pattern: Pattern, size_log2: u32) -> Self {
        let (inputs, set) = (crate::recorded().1, value_set(channels(pattern), size_log2));
        let features = vectors(&set, pattern, size_log2, inputs.columns(pattern), &inputs.cosine);
        let (order, kernel) = (value_order(&set), inputs.anneal_kernel);
        Self { size_log2, frames_log2: 0, time_kernel: Vec::new(), features, order, kernel }
    }

    fn anneal(&self, proposals: usize, seed: u64) -> Vec<u16> {
        let sizes = [self.size_log2, self.frames_log2];
        anneal(sizes, &self.features, &self.order, &self.kernel, &self.time_kernel, proposals, seed)
    }

    fn lane(&self, item: u16, lane: usize) -> i64 {
        i64::from(self.features[usize::from(item)][lane / 8][lane % 8])
    }

    /// F of a pixel, from nothing but the items around it. Frames lie one after the other.
    fn field(&self, items: &[u16], pixel: usize) -> [i64; LANES] {
        let (size, area) = (1i64 << self.size_log2, self.features.len());
        let mut field = [0; LANES];
        for (distance, &weight) in self.time_kernel.iter().enumerate().skip(1) {
            for frames in [distance, (items.len() / area) * 99 - distance] {
                let other = items[(pixel + frames * area) % items.len()];
                (0..LANES).for_each(|lane| field[lane] += i64::from(weight) * self.lane(other, lane));
            }
        }
        let (items, pixel) = (&items[pixel / area * area..], pixel % area);
        for dy in -4..=4 {
            for dx in -4..=4 {
                let r2 = (dx * dx + dy * dy) as usize;
                if r2 == 0 || r2 >= self.kernel.len() {
                    continue;
                }
                let x = (pixel as i64 % size + dx).rem_euclid(size);
                let y = (pixel as i64 / size + dy).rem_euclid(size);
                let features = self.features[usize::from(items[(y * size + x) as usize])].as_flattened();
                for (sum, &f) in field.iter_mut().zip(features) {
                    *sum += i64::from(self.kernel[r2]) * i64::from(f);
                }
            }
        }
        field
    }

    /// Σ_{p≠q} w(p−q)⟨f_p, f_q⟩ over the power of the items alone, w(0)Σ‖f‖²: −1 if the filtered image vanished.
    fn energy(&self, items: &[u16]) -> f64 {
        let dot = |p: usize| {
            let field = self.field(items, p);
            (0..LANES).map(|lane| self.lane(items[p], lane) * field[lane]).sum::<i64>()
        };
        let squares: i64 = items.iter().flat_map(|&i| (0..LANES).map(move |l| self.lane(i, l).pow(2))).sum();
        (0..items.len()).map(dot).sum::<i64>() as f64 / (squares * i64::from(self.kernel[0])) as f64
    }

    /// The algorithm in one thread, on the whole torus. Returns the items, too, with the number of swaps and the
    /// largest |Δ| met.
    fn twin(&self, proposals: usize, seed: u64) -> (Vec<u16>, usize, i64) {
        let (size, area, frames) = (1usize << self.size_log2, self.features.len(), 1 << self.frames_log2);
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut items: Vec<u16> = (0..frames * area).map(|i| (i % area) as u16).collect();
        for frame in items.chunks_mut(area) {
            for i in (1..area as u64).rev() {
                frame.swap(i as usize, (((rng.next_u64() >> 32) * (i + 1)) >> 32) as usize);
            }
        }
        let squares: i64 = items.iter().flat_map(|&i| (0..LANES).map(move |l| self.lane(i, l).pow(2))).sum();
        let power = squares * i64::from(self.kernel[0].abs()) / area as i64 / frames as i64;
        let (halves, margin) = if size < 64 { (1, 0) } else { (2, 4) };
        let (mut level, mut swaps, mut largest) = (65_536i64, 0, 0);
        for _ in 0..96 {
            let turn = (rng.next_u64() >> (64 - self.size_log2)) as usize;
            items = items.chunks(area).flat_map(|t| (0..area).map(|p| t[(p + turn * size) % area])).collect();
            let threshold = power * 65 / 1000 * level / 65_536;
            let seeds = [rng.next_u64(), rng.next_u64()];
            for (half, &seed) in seeds[..halves].iter().enumerate() {
                let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
                let rows = half * size / halves + margin..(half + 1) * size / halves - margin;
                let part = |frame| frame * area + rows.start * size..frame * area + rows.end * size;
                let mut pixels: Vec<usize> = (0..frames).flat_map(part).collect();
                let count = (pixels.len() / frames) as u64;
                let span = count * level as u64 / 131_072;
                pixels.sort_by_key(|&p| (p / area, self.order[usize::from(items[p])]));
                for _ in 0..proposals * items.len() / halves / 96 {
                    let bits = rng.next_u64();
                    let a = ((bits >> 32) * pixels.len() as u64) >> 32;
                    let b = a / count * count + (a % count + 1 + (((bits % (1 << 32)) * span) >> 32)) % count;
                    let (p, q) = (pixels[a as usize], pixels[b as usize]);
                    let apart = |p: usize, q: usize| p.abs_diff(q).min(size - p.abs_diff(q));
                    if apart(p % size, q % size) <= 4 && apart(p / size % size, q / size % size) <= 4 {
                        continue;
                    }
                    let (at_p, at_q) = (self.field(&items, p), self.field(&items, q));
                    let term = |l| (self.lane(items[q], l) - self.lane(items[p], l)) * (at_p[l] - at_q[l]);
                    let first: i64 = (0..8).map(term).sum();
                    if first > 4 * threshold {
                        continue;
                    }
                    let delta = first + (8..LANES).map(term).sum::<i64>();
                    largest = largest.max(delta.abs());
                    if delta < threshold {
                        items.swap(p, q);
                        pixels.sort_by_key(|&p| (p / area, self.order[usize::from(items[p])]));
                        swaps += 1;
                    }
                }
            }
            level = level * 63_509 / 65_536;
        }
        (items, swaps, largest)
    }

    /// Asserts that both say the same; returns what the twin does.
    fn check(&self, proposals: usize, seed: u64) -> (Vec<u16>, usize, i64) {
        let twin = self.twin(proposals, seed);
        let same = self.anneal(proposals, seed) == twin.0;
        assert!(same, "2^{}, {proposals} proposals, seed {seed}: another mask", self.size_log2);
        twin
    }
}

#[test]
fn masks_are_those_of_the_twin() {
    for pattern in PATTERNS {
        let problem = Problem::recorded(pattern, 4);
        for seed in [1, 0x1234_5678_9abc_def0] {
            let (_, swaps, _) = problem.check(200, seed);
            assert!(swaps > 500, "{pattern:?}: {swaps} swaps show little");
        }
        problem.check(0, 3);
        problem.check(1, 3);
        Problem::recorded(pattern, 5).check(40, 4);
    }
}

/// From 64 pixels on there are two halves with a margin.
#[test]
fn halves_are_those_of_the_twin() {
    for pattern in PATTERNS {
        let (_, swaps, _) = Problem::recorded(pattern, 6).check(8, 5);
        assert!(swaps > 500, "{pattern:?}: {swaps} swaps show little");
    }
}

/// Several frames, also fewer than the kernel reaches, and in halves.
#[test]
fn frames_are_those_of_the_twin() {
    for (size_log2, frames_log2, proposals) in [(4, 2, 30), (4, 1, 30), (5, 3, 3), (6, 1, 2)] {
        let time_kernel = OFFSET_TIME_KERNEL.to_vec();
        let problem = Problem { frames_log2, time_kernel, ..Problem::recorded(Pattern::Sobol, size_log2) };
        let (items, swaps, _) = problem.check(proposals, 6);
        assert!(swaps > 500, "{swaps} swaps show little");
        for frame in items.chunks(problem.features.len()) {
            let mut sorted = frame.to_vec();
            sorted.sort_unstable();
            assert!(sorted.iter().enumerate().all(|(i, &item)| i == usize::from(item)), "every value in every frame");
        }
    }
}

/// Other kernels, some without rings and some without symmetry in sign.
#[test]
fn other_kernels_make_no_difference() {
    for kernel in [&[128, 100][..], &[128, 0, 60], &[90, -30, 20, 9, -128, 3, 1, 1, 77], &[128; 25]] {
        let mut problem = Problem::recorded(Pattern::Sobol, 4);
        problem.kernel = kernel.to_vec();
        problem.check(20, 6);
    }
}

#[test]
fn no_sum_overflows() {
    let kernel = crate::recorded().1.anneal_kernel;
    let offsets = (-4i64..=4).flat_map(|y| (-4i64..=4).map(move |x| (x * x + y * y) as usize));
    let weights: i64 = offsets.filter(|r2| (1..25).contains(r2)).map(|r2| i64::from(kernel[r2])).sum();
    // All lanes at once, p's neighbours and q's as unlike as can be.
    let most = LANES as i64 * 126 * 126 * weights;
    assert!(most <= i64::from(i32::MAX), "{most}");
    assert!(48 * 63 * 63 * 128 * 65 / 1000 * 4 <= i64::from(i32::MAX), "the screen");

    // An upended kernel gathers like items: such neighbours do come up. The first eight lanes would screen them off.
    for first_lanes in [63, 0] {
        let vector = |i: usize| {
            let mut vector = [[if i < 128 { 63 } else { -63 }; 8]; LANES / 8];
            vector[0] = [if i < 128 { first_lanes } else { -first_lanes }; 8];
            vector
        };
        let problem = Problem {
            features: (0..256).map(vector).collect(),
            // Both kinds alternate: either is within reach to the end.
            order: (0..256u16).map(|i| i % 128 * 2 + i / 128).collect(),
            kernel: kernel.iter().map(|weight| -weight).collect(),
            ..Problem::recorded(Pattern::Regular, 4)
        };
        let (_, _, largest) = problem.check(100, 7);
        println!("largest {largest} of {most}");
        assert!(first_lanes != 0 || largest > most / 2, "{largest} is far from the extreme of {most}");
    }
    // One lane low, the next high, at random: borrows between packed lanes.
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(8);
    let mut extreme = || if rng.next_u64() >> 63 == 0 { 63 } else { -63 };
    let features = (0..256).map(|_| core::array::from_fn(|_| core::array::from_fn(|_| extreme()))).collect();
    Problem { features, order: (0..256).collect(), kernel, ..Problem::recorded(Pattern::Regular, 4) }.check(100, 9);
}

/// Nothing to improve: constant items, no window, no tries. The energy can not fall, and items stay what they are.
#[test]
fn constant_features_and_empty_kernels_end_in_a_permutation() {
    let problem = Problem::recorded(Pattern::Sobol, 4);
    let constant =
        |value| Problem { features: vec![[[value; 8]; LANES / 8]; 256], ..Problem::recorded(Pattern::Sobol, 4) };
    let untouched = problem.anneal(0, 3);
    for (name, odd, still) in [
        // No power, no threshold: equally good is not good enough.
        ("all features nothing", constant(0), true),
        (
            "a kernel of zeros",
            Problem { kernel: vec![0; problem.kernel.len()], ..Problem::recorded(Pattern::Sobol, 4) },
            true,
        ),
        ("all features alike", constant(63), false),
        ("all features alike and negative", constant(-63), false),
        ("the pixel alone", Problem { kernel: vec![1000], ..Problem::recorded(Pattern::Sobol, 4) }, false),
    ] {
        let mut items = odd.anneal(50, 3);
        assert_eq!(items == untouched, still, "{name}");
        items.sort_unstable();
        assert!(items.into_iter().eq(0..256), "{name}");
    }
}

#[test]
fn items_are_a_permutation() {
    for size_log2 in 4..=6 {
        let mut items = Problem::recorded(Pattern::Sobol, size_log2).anneal(20, 10);
        items.sort_unstable();
        assert!(items.iter().enumerate().all(|(i, &item)| i == usize::from(item)), "2^{size_log2}");
    }
}

#[test]
fn more_proposals_lower_the_energy() {
    for pattern in PATTERNS {
        for size_log2 in [4, 5] {
            let problem = Problem::recorded(pattern, size_log2);
            let energies = [0, 1, 10, 100, 1000].map(|proposals| problem.energy(&problem.anneal(proposals, 11)));
            println!("{pattern:?} 2^{size_log2}: {energies:.4?}");
            assert!(energies[0].abs() < 0.2, "shuffled items are no noise: {energies:?}");
            assert!(energies.is_sorted_by(|before, after| before > after), "{energies:?}");
            assert!(energies[4] < -0.7, "{energies:?}");
        }
    }
}

/// A feature in floating point, and how far it may be off: each number by its rounding. Phases are in steps of
/// 2π/1024, as the table of cosines has them: that error is part of the definition.
fn feature(pattern: Pattern, column: &Column, value: [u16; 2], area: f64) -> [f64; 2] {
    let scale = column.weight as f64 / 1024.0;
    let term = |i: u32| -> f64 {
        let in_unit = |x: u32| f64::from(x) / 4_294_967_296.0;
        let point = match pattern {
            Pattern::Regular => [f64::from(i) / f64::from(column.samples), 0.0],
            Pattern::Sobol => sobol::point(i).map(in_unit),
            Pattern::Lattice => [lattice::EXEW[0], lattice::EXEW[1]].map(|z| in_unit(lattice::extensible(i, z))),
        };
        let cosine = |j: usize| {
            let x = point[j] + (f64::from(value[j]) + 0.5) / area;
            let steps = (512.0 * f64::from(column.k[j]) * (x - x.floor()) + 0.5).floor();
            libm::cos(core::f64::consts::PI * steps / 512.0)
        };
        cosine(0) * cosine(1)
    };
    let samples = f64::from(column.samples);
    let off = 0.5 + scale * samples * 3.0 / 16384.0;
    [scale * (0..column.samples).map(term).sum::<f64>(), off]
}

#[test]
fn features_are_sums_of_cosines() {
    let inputs = crate::recorded().1;
    for (pattern, size_log2) in PATTERNS.into_iter().flat_map(|pattern| [(pattern, 4), (pattern, 6)]) {
        let (set, columns) = (value_set(channels(pattern), size_log2), inputs.columns(pattern));
        let vectors = vectors(&set, pattern, size_log2, columns, &inputs.cosine);
        for (&value, vector) in set.iter().zip(&vectors) {
            for (column, &found) in columns.iter().zip(vector.as_flattened()) {
                let [expected, off] = feature(pattern, column, value, set.len() as f64);
                assert!(off < 0.6, "a bound that says little: {off}");
                let error = (f64::from(found) - expected).abs();
                assert!(error <= off, "{pattern:?}, {value:?}, {column:?}: {found} instead of {expected}");
            }
        }
    }
}

#[test]
fn features_stay_below_64() {
    let inputs = crate::recorded().1;
    for pattern in PATTERNS {
        for size_log2 in 4..=7 {
            let set = value_set(channels(pattern), size_log2);
            let vectors = vectors(&set, pattern, size_log2, inputs.columns(pattern), &inputs.cosine);
            let largest = vectors.as_flattened().as_flattened().iter().map(|f| f.abs()).max().expect("features");
            assert!((32..=63).contains(&largest), "{pattern:?}, 2^{size_log2}: {largest}");
        }
    }
}

#[test]
fn neighbours_in_the_order_are_near() {
    for size_log2 in 4..=7 {
        let identity: Vec<u16> = (0..=u16::MAX).take(1 << (2 * size_log2)).collect();
        assert_eq!(value_order(&value_set(1, size_log2)), identity);

        let set = value_set(2, size_log2);
        let order = value_order(&set);
        let mut sorted = vec![[0; 2]; set.len()];
        order.iter().zip(&set).for_each(|(&place, &value)| sorted[usize::from(place)] = value);
        let mut places = order;
        places.sort_unstable();
        assert_eq!(places, identity);
        // The set is a net: every square of side 2^-k holds a 4^-k part of it, which the order does not leave.
        for k in 0..=size_log2 {
            for block in sorted.chunks(set.len() >> (2 * k)) {
                let square = |value: &[u16; 2]| value.map(|rank| u32::from(rank) >> (2 * size_log2 - k));
                assert!(block.iter().all(|value| square(value) == square(&block[0])), "2^{size_log2}, k = {k}");
            }
        }
    }
}
