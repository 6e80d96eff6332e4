//! Seeds and scrambles: bijections, avalanche, nets and prefixes.

use bluedither::hash::{combine, laine_karras, laine_karras_4, mix, mix_64, owen, owen_4, shuffle};
use proptest::prelude::*;

const SEEDS: [u32; 8] = [0, 1, 2, 0x7fff_ffff, 0x8000_0000, 0xffff_0000, u32::MAX - 1, u32::MAX];

/// Undoes `mix` step by step, which proves that it is a bijection.
fn unmix(mixed: u32) -> u32 {
    let mut h = mixed;
    h = h ^ (h >> 15) ^ (h >> 30);
    h = h.wrapping_mul(inverse(0xd35a_2d97));
    h = h ^ (h >> 15) ^ (h >> 30);
    h = h.wrapping_mul(inverse(0x21f0_aaad));
    h ^= h >> 16;
    h ^ 0xe6fe_3beb
}

/// The inverse of an odd number modulo 2³² (Newton).
fn inverse(odd: u32) -> u32 {
    (0..5).fold(odd, |x, _| x.wrapping_mul(2u32.wrapping_sub(odd.wrapping_mul(x))))
}

/// How far the chance that one input bit flips one output bit is from one half, over all 32×32 pairs.
fn worst_avalanche(rounds: u32, f: impl Fn(u32) -> u32) -> f64 {
    let mut worst = 0.0f64;
    for bit in 0..32 {
        let mut flips = [0u32; 32];
        for round in 0..rounds {
            // Small and spread values in turn: users pass both.
            let value = if round % 2 == 0 { round / 2 } else { round.wrapping_mul(0x9e37_79b9) };
            let changed = f(value) ^ f(value ^ 1 << bit);
            flips.iter_mut().enumerate().for_each(|(k, count)| *count += changed >> k & 1);
        }
        for count in flips {
            worst = worst.max((f64::from(count) / f64::from(rounds) - 0.5).abs());
        }
    }
    worst
}

#[test]
fn every_bit_flips_every_bit() {
    // The scatter of 1024 pairs at 8192 rounds alone reaches .02.
    let worst = [
        worst_avalanche(8192, mix),
        worst_avalanche(8192, |value| combine(5, value)),
        worst_avalanche(8192, |seed| combine(seed, 5)),
    ];
    assert!(worst.iter().all(|w| *w < 0.06), "{worst:?}");
}

#[test]
fn no_fixed_point_at_zero() {
    assert_ne!(mix(0), 0);
    assert_ne!(combine(0, 0), 0);
    assert_ne!(combine(0, 1), combine(1, 0));
}

#[test]
fn combine_of_neighbours_has_no_twins() {
    let mut all: Vec<u32> = (0..256).flat_map(|seed| (0..256).map(move |value| combine(seed, value))).collect();
    all.sort_unstable();
    // 65536 random numbers of 2³² have half a pair in common.
    let twins = all.windows(2).filter(|pair| pair[0] == pair[1]).count();
    assert!(twins < 5, "{twins}");
}

#[test]
fn laine_karras_permutes_the_lower_bits() {
    for seed in SEEDS {
        for bits in [1, 2, 3, 8, 14] {
            let count = 1usize << bits;
            let mut seen = vec![false; count];
            for value in 0..count as u32 {
                seen[laine_karras(value, seed) as usize & (count - 1)] = true;
            }
            assert!(seen.iter().all(|hit| *hit), "seed {seed}, {bits} bits");
        }
    }
}

#[test]
fn owen_flips_every_digit_half_of_the_time() {
    for value in [0u32, 1, 0x8000_0000, 0x1234_5678, u32::MAX] {
        let mut flips = [0u32; 32];
        let rounds = 4096;
        for seed in 0..rounds {
            let changed = owen(value, mix(seed)) ^ value;
            flips.iter_mut().enumerate().for_each(|(k, count)| *count += changed >> k & 1);
        }
        for (k, count) in flips.iter().enumerate() {
            // Standard deviation .0078.
            let chance = f64::from(*count) / f64::from(rounds);
            assert!((chance - 0.5).abs() < 0.035, "value {value:#x}, bit {k}: {chance}");
        }
    }
}

#[test]
fn owen_flips_below_two_sides_of_a_digit_are_unrelated() {
    // Digit k+1 of a number and of its neighbour across digit k: flips agree half of the time.
    for digit in 0..12 {
        let (a, b) = (0x2a5a_1234u32, 0x2a5a_1234u32 ^ 0x8000_0000 >> digit);
        let next = 0x4000_0000u32 >> digit;
        let rounds = 4096;
        let agree =
            (0..rounds).filter(|&seed| ((owen(a, mix(seed)) ^ a) ^ (owen(b, mix(seed)) ^ b)) & next == 0).count();
        let share = agree as f64 / f64::from(rounds);
        assert!((share - 0.5).abs() < 0.06, "digit {digit}: {share}");
    }
}

/// What `laine_karras_4` does to the digit at `level` of numbers whose digits below are those of `below`.
fn permutation(below: u32, level: u32, seed: u32) -> [u32; 4] {
    let low = below & ((1 << (2 * level)) - 1);
    core::array::from_fn(|digit| laine_karras_4(low | (digit as u32) << (2 * level), seed) >> (2 * level) & 3)
}

#[test]
fn every_digit_of_base_4_goes_through_all_permutations() {
    let rounds = 24_000;
    for level in [0, 1, 2, 7, 15] {
        for below in [0, 0x1234_5678, u32::MAX] {
            let mut counts = std::collections::BTreeMap::new();
            for seed in 0..rounds {
                *counts.entry(permutation(below, level, mix(seed))).or_insert(0u32) += 1;
            }
            assert_eq!(counts.len(), 24, "level {level}, below {below:x}");
            for (permutation, count) in counts {
                let mut sorted = permutation;
                sorted.sort_unstable();
                assert_eq!(sorted, [0, 1, 2, 3]);
                // The values that stay one half of the four: those of the first bit, of the second, or of their sum.
                // Read in reversed order, the first bit of a digit is the lower one.
                let partner = (1..4).find(|&other| (permutation[0] ^ permutation[other]) & 1 == 0).expect("one");
                let share = f64::from(count) / f64::from(rounds);
                let expected = if partner == 3 { 2.0 } else { 3.0 } / 64.0;
                // Standard deviation .0014.
                assert!((share - expected).abs() < 0.007, "level {level}, below {below:x}: {permutation:?} {share}");
            }
        }
    }
}

#[test]
fn base_4_permutations_below_two_values_of_a_digit_differ() {
    // Two independent ones agree in 16·(3/64)² + 8·(2/64)² = .043 of all seeds; here, in fewer. Most pairs occur.
    let rounds = 16_000;
    for level in [1, 2, 9] {
        for other in 1..4 {
            let twins = (0..rounds).map(mix).map(|s| [0, other << (2 * level - 2)].map(|b| permutation(b, level, s)));
            let twins: Vec<_> = twins.collect();
            let share = twins.iter().filter(|[a, b]| a == b).count() as f64 / f64::from(rounds);
            assert!(share < 0.055, "level {level}, digit {other}: {share}");
            let pairs: std::collections::BTreeSet<_> = twins.into_iter().collect();
            assert!(pairs.len() > 24 * 24 / 3, "level {level}, digit {other}: {} pairs", pairs.len());
        }
    }
}

#[test]
fn mix_64_flips_every_bit_by_every_bit() {
    for bit in 0..64 {
        let mut flips = [0u32; 64];
        for round in 0..4096u64 {
            let changed = mix_64(round) ^ mix_64(round ^ 1 << bit);
            flips.iter_mut().enumerate().for_each(|(k, count)| *count += u32::from(changed >> k & 1 == 1));
        }
        for count in flips {
            // The scatter of 4096 pairs alone reaches .04.
            assert!((f64::from(count) / 4096.0 - 0.5).abs() < 0.1, "bit {bit}: {flips:?}");
        }
    }
}

#[test]
fn shuffle_keeps_every_power_of_two_prefix() {
    for seed in SEEDS {
        let mut seen = vec![false; 1 << 14];
        for bits in 0..=14 {
            let from = if bits == 0 { 0 } else { 1u32 << (bits - 1) };
            for index in from..1 << bits {
                let to = shuffle(index, seed);
                assert!(to < 1 << bits, "seed {seed}: {index} leaves the first {}", 1 << bits);
                assert!(!core::mem::replace(&mut seen[to as usize], true), "seed {seed}: {to} comes twice");
            }
        }
    }
}

#[test]
fn shuffle_keeps_aligned_runs_together() {
    // Indices that agree above bit k stay so: a run of 2ᵏ is one run of 2ᵏ.
    for seed in SEEDS {
        for bits in 1..10 {
            for run in 1..64u32 {
                let first = shuffle(run << bits, seed) >> bits;
                assert!((0..1 << bits).all(|k| shuffle(run << bits | k, seed) >> bits == first));
            }
        }
    }
}

#[test]
fn shuffles_of_two_seeds_differ() {
    let count = 1u32 << 12;
    let same = (0..count).filter(|&i| shuffle(i, mix(1)) == shuffle(i, mix(2))).count();
    assert!(same < 64, "{same} of {count} stay together");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn mix_can_be_undone(value: u32) {
        prop_assert_eq!(unmix(mix(value)), value);
    }

    #[test]
    fn combine_can_be_undone(seed: u32, value: u32) {
        prop_assert_eq!(unmix(combine(seed, value)).wrapping_sub(mix(seed)), value);
    }

    #[test]
    fn laine_karras_looks_only_down(value: u32, other: u32, seed: u32, bits in 0u32..32) {
        // Two numbers with the same lower bits have the same lower bits after it; a different one above, flipped.
        let low = (1u32 << bits) - 1;
        let twin = value & low | other & !low;
        let (a, b) = (laine_karras(value, seed), laine_karras(twin, seed));
        prop_assert_eq!(a & low, b & low);
        prop_assert_eq!((a ^ b) >> bits & 1, (value ^ twin) >> bits & 1);
    }

    #[test]
    fn owen_keeps_elementary_intervals(a: u32, b: u32, seed: u32, digits in 1u32..=32) {
        // In one interval of 2^-digits before, exactly then after.
        let same = |a: u32, b: u32| (a ^ b).leading_zeros() >= digits;
        let near = b >> (digits - 1) >> 1 ^ a & !(u32::MAX >> (digits - 1) >> 1);
        for b in [b, near] {
            prop_assert_eq!(same(a, b), same(owen(a, seed), owen(b, seed)));
        }
    }

    #[test]
    fn laine_karras_4_looks_only_down(value: u32, other: u32, seed: u32, digits in 0u32..16) {
        // Two numbers with the same lower digits have the same after it, and the first other digit stays another.
        let low = (1u32 << (2 * digits)) - 1;
        let twin = value & low | other & !low;
        let (a, b) = (laine_karras_4(value, seed), laine_karras_4(twin, seed));
        prop_assert_eq!(a & low, b & low);
        prop_assert_eq!((a ^ b) >> (2 * digits) & 3 == 0, (value ^ twin) >> (2 * digits) & 3 == 0);
    }

    #[test]
    fn owen_4_keeps_intervals_of_base_4(a: u32, b: u32, seed: u32, digits in 1u32..=16) {
        let same = |a: u32, b: u32| (a ^ b).leading_zeros() >= 2 * digits;
        let near = b >> (2 * digits - 1) >> 1 ^ a & !(u32::MAX >> (2 * digits - 1) >> 1);
        for b in [b, near] {
            prop_assert_eq!(same(a, b), same(owen_4(a, seed), owen_4(b, seed)));
        }
    }

    #[test]
    fn shuffle_keeps_the_top_bit(index: u32, seed: u32) {
        let top = |n: u32| n.checked_ilog2();
        prop_assert_eq!(top(shuffle(index, seed)), top(index));
    }

    #[test]
    fn shuffle_is_one_to_one(a: u32, b: u32, seed: u32) {
        for b in [b, a ^ 1, a ^ b >> 16] {
            prop_assert_eq!(a == b, shuffle(a, seed) == shuffle(b, seed));
        }
    }
}
