//! The joint net, bit by bit: a digit is the parity of what its columns add.

use bluedither::net::{Digits, Order};
use bluedither::tables::NET;
use bluedither::{Sampler, hash, zorder};
use proptest::prelude::*;

/// Digit j, the highest first, of number `number`.
fn digit(digits: &Digits, number: usize, j: usize) -> bool {
    let half = if number.is_multiple_of(2) { digits[number / 2] >> 16 } else { digits[number / 2] & 0xffff };
    half >> (15 - j) & 1 == 1
}

/// Whether an odd number of the columns whose bit is set have that digit.
fn odd(columns: &[Digits], bits: u32, number: usize, j: usize) -> bool {
    let adds = |k: usize| bits >> k & 1 == 1 && digit(&columns[k], number, j);
    (0..columns.len()).filter(|&k| adds(k)).count() % 2 == 1
}

/// The columns, and log₂ of the number of samples where it is known.
struct Place {
    order: &'static Order,
    log2: Option<u32>,
}

const ODD: [u32; 4] = [0x9e37_79b1, 0x85eb_ca77, 0xc2b2_ae3d, 0x27d4_eb2f];

/// Bits are added to lower ones, bit by bit.
fn ordered(number: u32, hash: u32) -> u32 {
    let [other, third] = [ODD[1], ODD[2]].map(|odd| hash.wrapping_mul(odd));
    let steps = [
        (1, hash),
        (2, hash >> 16),
        (4, other >> 16),
        (8, other >> 8),
        (1, third >> 16),
        (2, third >> 12),
        (4, third >> 8),
    ];
    let mut bits: Vec<bool> = (0..16).map(|k| number >> k & 1 == 1).collect();
    for (distance, mask) in steps {
        bits = (0..16).map(|k| bits[k] ^ (k + distance < 16 && bits[k + distance] && mask >> k & 1 == 1)).collect();
    }
    bits.iter().enumerate().fold(0, |sum, (k, &bit)| sum | u32::from(bit) << k)
}

/// Draws as the text of the module says, without a thought of speed.
fn twin(spp: Option<u32>, seed: u32, [x, y, frame]: [u32; 3], domain: u32, index: u32) -> [u32; 8] {
    let place = match spp.and_then(|spp| Some((NET.known(spp)?, spp.max(1)))) {
        Some((order, spp)) => Place { order, log2: Some(spp.trailing_zeros()) },
        None => Place { order: &NET.progressive, log2: None },
    };
    let (columns, frame_columns) = (&place.order.samples, &NET.frames);
    // Sixteen digits in all, or fifteen of a frame's own.
    let digits = place.log2.map_or(15, |log2| 16 - log2);
    let (frame, epoch) = (u64::from(frame) % (1 << digits), u64::from(frame) >> digits);

    let domain_word = u64::from(domain).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let key = hash::mix_64(hash::mix_64(u64::from(seed) * (1 << 32) + epoch) ^ domain_word);
    let (low, high) = ((key % (1 << 32)) as u32, (key / (1 << 32)) as u32);
    let (x, y) = (x.wrapping_add(high), y.wrapping_add(high.rotate_right(16)));
    let code = zorder::morton(x / 4, y / 4) as u32;
    // In the order of the smallest squares last: its first digits are the place among far squares.
    let curve = hash::laine_karras_4(code.reverse_bits(), low).reverse_bits();
    // Three digits of a hash choose a variant of the block.
    let variant = curve.reverse_bits().wrapping_mul(ODD[0]) >> 29;
    let (mut u, mut v) = if variant / 4 == 1 { (y % 4, x % 4) } else { (x % 4, y % 4) };
    if variant / 2 % 2 == 1 && v >= 2 {
        u = if u % 2 == 0 { u + 1 } else { u - 1 };
    }
    if variant % 2 == 1 && u >= 2 {
        v = if v % 2 == 0 { v + 1 } else { v - 1 };
    }
    // Squares of 32×32 pixels: without the six digits inside one.
    let shift = hash::mix((curve >> 6 << 6).reverse_bits() ^ low);
    let own = hash::mix(x ^ y.rotate_right(16) ^ high);
    let rest: Digits = core::array::from_fn(|k| shift.wrapping_mul(ODD[k]) ^ high.wrapping_mul(ODD[3 - k]));

    // A frame's samples in the pixel's own order; frames in one of 32×32 pixels, above them or by columns of their own.
    let bits = place.log2.unwrap_or(16);
    let per_frame = 1u64 << bits;
    let frames = (u64::from(index) / per_frame) ^ if place.log2.is_some() { frame } else { 0 };
    let per_sequence = (1 << 16) / per_frame;
    let upper = ordered((frames % per_sequence) as u32, shift) * per_frame as u32;
    let mut number = ordered((u64::from(index) % per_frame) as u32 + upper, own) % per_frame as u32;
    if place.log2.is_some() {
        number ^= (own >> 8) % per_frame as u32;
    }
    number += upper;
    let frame = ordered(frame as u32, shift);

    // Later sequences are moved as a whole.
    let later = frames / per_sequence;
    let anew: Digits = if later == 0 {
        [0; 4]
    } else {
        let key = hash::mix_64(key ^ later << 32);
        core::array::from_fn(|k| ((key >> 32) as u32).wrapping_mul(ODD[k]) ^ key as u32)
    };
    let rest: Digits = core::array::from_fn(|k| rest[k] ^ anew[k]);

    core::array::from_fn(|n| {
        let upper = (0..16).fold(0, |sum, j| {
            let frame = place.log2.is_none() && odd(frame_columns, frame, n, j);
            let set = digit(&rest, n, j)
                ^ odd(columns, number, n, j)
                ^ odd(&place.order.inside, u + 4 * v, n, j)
                ^ odd(&place.order.place, curve % 64, n, j)
                ^ frame;
            2 * sum + u32::from(set)
        });
        // Below the sixteen digits: what the neighbouring pair has at random.
        let below = rest[(n / 2) ^ 1];
        upper << 16 | if n.is_multiple_of(2) { below & 0xffff } else { below >> 16 }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn numbers_are_their_naive_twins(
        seed: u32, at: [u32; 3], domain: u32, index: u32, small in 0u32..300, known in 0usize..11,
    ) {
        let spp = [0, 1, 2, 4, 8, 16, 32, 64, 256, 128, 3][known];
        for index in [small, index] {
            for frame in [at[2] % 64, at[2]] {
                let at = [at[0], at[1], frame];
                let draw = |sampler: Sampler| sampler.pixel(at[0], at[1], at[2]).draw_fx::<8>(domain, index);
                prop_assert_eq!(draw(Sampler::with_spp(seed, spp)), twin(Some(spp), seed, at, domain, index));
                prop_assert_eq!(draw(Sampler::new(seed)), twin(None, seed, at, domain, index));
            }
        }
    }
}
