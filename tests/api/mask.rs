//! Masks: look-ups of every coordinate, exact values, and the structure of every baked table.

use bluedither::{ScalarMask, VectorMask};
use proptest::prelude::*;

/// Ranks in an order without symmetry: another one for every channel.
const fn rank_at(x: usize, y: usize, size: usize, channel: usize) -> u16 {
    ((y * size + x) * (2 * channel + 5) % (size * size)) as u16
}

const fn scalar<const S: usize>() -> ScalarMask<S> {
    let mut ranks = [[0; S]; S];
    let mut p = 0;
    while p < S * S {
        ranks[p / S][p % S] = rank_at(p % S, p / S, S, 0);
        p += 1;
    }
    ScalarMask::new(ranks)
}

const fn vector<const D: usize, const S: usize>() -> VectorMask<D, S> {
    let mut ranks = [[[0; D]; S]; S];
    let mut p = 0;
    while p < S * S * D {
        ranks[p / D / S][p / D % S][p % D] = rank_at(p / D % S, p / D / S, S, p % D);
        p += 1;
    }
    VectorMask::new(ranks)
}

/// Coordinates as an image has them, and as nobody has them.
const COORDINATES: [i32; 12] = [0, 1, 3, 4, 5, 255, 256, -1, -2, -256, i32::MAX, i32::MIN];

/// (2r + 1)/(2·S²) in 0.32: a rational of a power of two, so exact.
fn naive_value(rank: u16, size: usize) -> u32 {
    let value = ((2 * u128::from(rank) + 1) << 32) / (2 * (size * size) as u128);
    u32::try_from(value).expect("below 1")
}

/// Pairs of coordinates as a look-up takes them, each with the column and the row of a tile that it is to find.
fn look_ups(size: usize) -> impl Iterator<Item = [(u32, usize); 2]> {
    let place = move |c: i32| (c as u32, c.rem_euclid(size as i32) as usize);
    COORDINATES.into_iter().flat_map(move |y| COORDINATES.map(|x| [place(x), place(y)]))
}

fn check_scalar<const S: usize>(mask: &ScalarMask<S>) {
    let mut seen = vec![false; S * S];
    for [(x, column), (y, row)] in look_ups(S) {
        let rank = mask.rank(x, y);
        assert_eq!(rank, mask.ranks()[row][column], "{x}, {y} in {S}²");
        let value = mask.value_fx(x, y);
        assert_eq!(value, naive_value(rank, S), "rank {rank} of {S}²");
        assert_eq!(mask.value(x, y).to_bits(), bluedither::unit::to_f32(value).to_bits());
        assert!(mask.value(x, y) > 0.0 && mask.value(x, y) < 1.0);
    }
    let mut sum = 0u64;
    for y in 0..S as u32 {
        for x in 0..S as u32 {
            let rank = usize::from(mask.rank(x, y));
            assert!(!core::mem::replace(&mut seen[rank], true), "rank {rank} of {S}² comes twice");
            sum += u64::from(mask.value_fx(x, y));
        }
    }
    assert_eq!(sum, ((S * S) as u64) << 31, "the mean is one half");
    assert_eq!(1usize << ScalarMask::<S>::SIZE_LOG2, S);
}

fn check_vector<const D: usize, const S: usize>(mask: &VectorMask<D, S>) {
    for [(x, column), (y, row)] in look_ups(S) {
        let ranks = mask.rank(x, y);
        assert_eq!(ranks, mask.ranks()[row][column], "{x}, {y} in {S}²");
        let values = mask.value_fx(x, y);
        assert_eq!(values, ranks.map(|rank| naive_value(rank, S)));
        assert_eq!(mask.value(x, y), bluedither::unit::to_f32s(values));
    }
    for channel in 0..D {
        let mut seen = vec![false; S * S];
        for pixel in mask.ranks().as_flattened() {
            let rank = usize::from(pixel[channel]);
            assert!(!core::mem::replace(&mut seen[rank], true), "channel {channel}: rank {rank} of {S}² twice");
        }
    }
}

#[test]
fn scalar_masks_of_every_size() {
    check_scalar(&scalar::<1>());
    check_scalar(&scalar::<2>());
    check_scalar(&scalar::<4>());
    check_scalar(&scalar::<8>());
    check_scalar(&scalar::<16>());
    check_scalar(&scalar::<32>());
    check_scalar(&scalar::<64>());
    check_scalar(&scalar::<128>());
    check_scalar(&scalar::<256>());
}

#[test]
fn vector_masks_of_every_size() {
    check_vector(&vector::<1, 64>());
    check_vector(&vector::<2, 1>());
    check_vector(&vector::<2, 2>());
    check_vector(&vector::<2, 16>());
    check_vector(&vector::<2, 128>());
    check_vector(&vector::<2, 256>());
    check_vector(&vector::<3, 8>());
    check_vector(&vector::<4, 64>());
}

#[test]
fn a_mask_tiled_over_65536_squared_pixels_reaches_its_far_corner() {
    fn check<const S: usize>() {
        let (scalar, vector) = (scalar::<S>(), vector::<2, S>());
        for back in [0, 1, S - 1, S, 65535] {
            let far = 65535 - back as u32;
            let inside = (S - 1 - back % S, S - 1);
            assert_eq!(scalar.rank(far, 65535), scalar.ranks()[inside.1][inside.0], "{far}, 65535 in {S}²");
            assert_eq!(vector.rank(65535, far), vector.ranks()[inside.0][inside.1], "65535, {far} in {S}²");
        }
    }
    check::<1>();
    check::<64>();
    check::<256>();
}

#[test]
fn a_mask_can_be_a_constant() {
    static MASK: ScalarMask<16> = scalar();
    const VALUE: u32 = MASK.value_fx(3, 5);
    assert_eq!(VALUE, naive_value(rank_at(3, 5, 16, 0), 16));
}

#[cfg(feature = "bytemuck")]
#[test]
fn bytes_are_the_ranks_in_memory_order() {
    let mask = scalar::<16>();
    let ranks: Vec<u8> = mask.ranks().as_flattened().iter().flat_map(|rank| rank.to_ne_bytes()).collect();
    assert_eq!(mask.bytes(), ranks);
    let mask = vector::<2, 8>();
    let ranks: Vec<u8> =
        mask.ranks().as_flattened().as_flattened().iter().flat_map(|rank| rank.to_ne_bytes()).collect();
    assert_eq!(mask.bytes(), ranks);
}

/// Every table that the features ask for is a permutation in each channel; the pairs are the first S² Sobol points.
macro_rules! baked {
    ($($feature:literal $check:ident $table:ident;)*) => {$(
        #[cfg(feature = $feature)]
        #[test]
        #[allow(non_snake_case, reason = "named after the table")]
        fn $table() {
            $check(&bluedither::tables::$table);
        }
    )*};
}

baked! {
    "threshold-16" check_scalar THRESHOLD_16;
    "threshold-32" check_scalar THRESHOLD_32;
    "threshold-64" check_scalar THRESHOLD_64;
    "threshold-128" check_scalar THRESHOLD_128;
    "threshold-256" check_scalar THRESHOLD_256;
    "threshold-filtered-64" check_scalar THRESHOLD_FILTERED_64;
    "offset-1d-16" check_scalar OFFSET_1D_16;
    "offset-1d-32" check_scalar OFFSET_1D_32;
    "offset-1d-64" check_scalar OFFSET_1D_64;
    "offset-1d-128" check_scalar OFFSET_1D_128;
    "offset-2d-16" check_net OFFSET_2D_16;
    "offset-2d-32" check_net OFFSET_2D_32;
    "offset-2d-64" check_net OFFSET_2D_64;
    "offset-2d-128" check_net OFFSET_2D_128;
}

#[allow(dead_code, reason = "without a pair table there is nothing to check")]
fn check_net<const S: usize>(mask: &VectorMask<2, S>) {
    check_vector(mask);
    let digits = VectorMask::<2, S>::SIZE_LOG2 * 2;
    for x_digits in 0..=digits {
        let mut seen = vec![false; S * S];
        for [x, y] in mask.ranks().as_flattened() {
            let column = u32::from(*x) >> (digits - x_digits);
            let row = u32::from(*y) >> x_digits;
            let cell = (column << (digits - x_digits) | row) as usize;
            assert!(!core::mem::replace(&mut seen[cell], true), "two pairs in one interval of 2^-{x_digits} wide");
        }
    }
}

#[test]
fn the_check_of_nets_tells_a_net() {
    let pair = |index: usize| bluedither::sobol::point(index as u32).map(|value| (value >> 24) as u16);
    let net = VectorMask::<2, 16>::new(core::array::from_fn(|y| core::array::from_fn(|x| pair(y * 16 + x))));
    check_net(&net);
    let swapped = net.ranks().map(|row| row.map(|[x, y]| [x, y ^ u16::from(x % 2 == 0)]));
    assert!(std::panic::catch_unwind(|| check_net(&VectorMask::new(swapped))).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_tile_repeats_exactly(x: u32, y: u32, right: u32, down: u32) {
        static SCALAR: ScalarMask<32> = scalar();
        static VECTOR: VectorMask<2, 32> = vector();
        let (x2, y2) = (x.wrapping_add(right << 5), y.wrapping_add(down << 5));
        prop_assert_eq!(SCALAR.rank(x, y), SCALAR.rank(x2, y2));
        prop_assert_eq!(VECTOR.rank(x, y), VECTOR.rank(x2, y2));
    }
}
