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
    let transposed = curve.reverse_bits().wrapping_mul(ODD[0]) >= 1 << 31;
    let (u, v) = if transposed { (y % 4, x % 4) } else { (x % 4, y % 4) };
    // Squares of 32×32 pixels: without the six digits inside one.
    let shift = hash::mix((curve >> 6 << 6).reverse_bits() ^ low);
    let own = hash::mix(x ^ y.rotate_right(16) ^ high);
    let rest: Digits = core::array::from_fn(|k| shift.wrapping_mul(ODD[k]) ^ high.wrapping_mul(ODD[3 - k]));

    // The pixel's own order of samples.
    let other = own.wrapping_mul(ODD[1]);
    let steps =
        [(1, own), (2, own >> 16), (4, other >> 8), (8, other >> 16), (1, own >> 24), (2, other), (4, other >> 20)];
    let frame_above = place.log2.map_or(0, |log2| frame << log2);
    let mut number: Vec<bool> = (0..16).map(|k| (u64::from(index) ^ frame_above) >> k & 1 == 1).collect();
    for (distance, mask) in steps {
        number =
            (0..16).map(|k| number[k] ^ (k + distance < 16 && number[k + distance] && mask >> k & 1 == 1)).collect();
    }
    let mut number = (0..16).fold(0, |sum, k| sum | u32::from(number[k]) << k);
    if let Some(log2) = place.log2 {
        number ^= (own >> 8) % (1 << log2);
    }

    // Later sequences are moved as a whole.
    let later = index >> 16;
    let anew: Digits = if later == 0 {
        [0; 4]
    } else {
        let key = hash::mix_64(key ^ u64::from(later) << 32);
        core::array::from_fn(|k| ((key >> 32) as u32).wrapping_mul(ODD[k]) ^ key as u32)
    };
    let rest: Digits = core::array::from_fn(|k| rest[k] ^ anew[k]);

    core::array::from_fn(|n| {
        let upper = (0..16).fold(0, |sum, j| {
            let frame = place.log2.is_none() && odd(frame_columns, frame as u32, n, j);
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
