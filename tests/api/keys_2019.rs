//! The formula of 2019 against its words, on tables that are not the published ones.

use crate::analysis::random::Random;
use bluedither::keys_2019::Tables2019;

fn bytes(count: usize, seed: u64) -> Vec<u8> {
    let mut random = Random::new(seed);
    (0..count).map(|_| random.bits_32() as u8).collect()
}

#[test]
fn values_are_those_of_the_formula() {
    let (sobol, scrambling, ranking) = (bytes(65_536, 1), bytes(131_072, 2), bytes(131_072, 3));
    let tables = Tables2019::from_slices(&sobol, &scrambling, &ranking).expect("the right lengths");
    let naive = |x: i64, y: i64, s: i64, d: i64| {
        let (i, j) = (x.rem_euclid(128), y.rem_euclid(128));
        let at = (d % 8 + (i + j * 128) * 8) as usize;
        let ranked = (s % 256) ^ i64::from(ranking[at]);
        sobol[(d % 256 + ranked * 256) as usize] ^ scrambling[at]
    };
    let mut random = Random::new(4);
    for _ in 0..100_000 {
        let [x, y, s, d] = core::array::from_fn(|_| random.bits_32());
        let value = tables.value(x, y, s, d);
        assert_eq!(value, naive(i64::from(x), i64::from(y), i64::from(s), i64::from(d)));
        assert_eq!(tables.value_f32(x, y, s, d), (f32::from(value) + 0.5) / 256.0);
    }
    // The last pixels and the highest dimensions, where the published code leaves its table.
    for d in 0..=300 {
        for s in [0, 255, 256] {
            assert_eq!(tables.value(127, 127, s, d), naive(127, 127, i64::from(s), i64::from(d)));
            assert_eq!(tables.value(u32::MAX, u32::MAX, s, d), tables.value(127, 127, s, d));
        }
    }
}

#[test]
fn other_lengths_are_refused() {
    let (sobol, tile) = (bytes(65_536, 1), bytes(131_072, 2));
    assert!(Tables2019::from_slices(&sobol, &tile, &tile).is_some());
    assert!(Tables2019::from_slices(&sobol[1..], &tile, &tile).is_none());
    assert!(Tables2019::from_slices(&sobol, &tile[1..], &tile).is_none());
    assert!(Tables2019::from_slices(&sobol, &tile, &tile[1..]).is_none());
}
