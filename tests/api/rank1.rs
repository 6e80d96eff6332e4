//! The shifted lattice: its definition, the structure of its prefixes, and why it needs no ranks.

use crate::analysis::random::Random;
use bluedither::lattice::{EXEW, extensible};
use bluedither::{Rank1, VectorMask};

/// Points, in no order.
fn sorted(points: impl IntoIterator<Item = [u32; 2]>) -> Vec<[u32; 2]> {
    let mut points: Vec<_> = points.into_iter().collect();
    points.sort_unstable();
    points
}

fn lattice(index: u32, shift: [u32; 2]) -> [u32; 2] {
    core::array::from_fn(|k| extensible(index, EXEW[k]).wrapping_add(shift[k]))
}

#[test]
fn prefixes_are_the_lattice_shifted_by_the_mask() {
    let values = |frame, domain, seed| {
        let sampler = Rank1::with_mask(crate::common::vector_mask(), seed);
        sorted((0..64 * 64).map(|p| sampler.pixel(p % 64, p / 64, frame).draw_fx::<2>(domain, 0)))
    };
    let mask = sorted((0..64 * 64).map(|p| crate::common::vector_mask().value_fx(p % 64, p / 64)));
    for (seed, domain, frame) in [(0, 0, 0), (1, 7, 2), (9, 100, u32::MAX)] {
        assert_eq!(values(frame, domain, seed), mask, "first samples are the values of the mask");
        let pixel = Rank1::with_mask(crate::common::vector_mask(), seed).pixel(3, 5, frame);
        let shift = pixel.draw_fx::<2>(domain, 0);
        for m in 0..=11 {
            let drawn = sorted((0..1 << m).map(|i| pixel.draw_fx::<2>(domain, i)));
            assert_eq!(drawn, sorted((0..1 << m).map(|i| lattice(i, shift))), "the first 2^{m}");
        }
    }
}

#[test]
fn a_rank_is_a_shift() {
    let mut random = Random::new(1);
    for _ in 0..50 {
        let (rank, shift) = (random.bits_32(), [random.bits_32(), random.bits_32()]);
        let moved = lattice(rank, shift);
        for m in 0..=10 {
            let ranked = sorted((0..1 << m).map(|i| lattice(i ^ rank, shift)));
            assert_eq!(ranked, sorted((0..1 << m).map(|i| lattice(i, moved))), "2^{m}, rank {rank}");
        }
    }
}

#[test]
fn pixels_read_the_mask_beside_each_other() {
    let ranks: Vec<[u16; 2]> = (0..256).map(|p| [p, 255 - p]).collect();
    let mask = VectorMask::<2, 16>::from_slice(&ranks).expect("as many as pixels");
    let sampler = Rank1::with_mask(&mask, 5);
    let at = |x: i32, y: i32| sampler.pixel(x.cast_unsigned(), y.cast_unsigned(), 1).draw_fx::<2>(2, 0);
    let rank = |x, y| at(x, y).map(|value| value >> 24);
    let [origin, _] = rank(0, 0);
    let (x0, y0) = ((origin % 16).cast_signed(), (origin / 16).cast_signed());
    for y in -20..20 {
        for x in -20..20 {
            let expected = ((y0 + y).rem_euclid(16) * 16 + (x0 + x).rem_euclid(16)).cast_unsigned();
            assert_eq!(rank(x, y), [expected, 255 - expected]);
        }
    }
}
