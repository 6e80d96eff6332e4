//! What samplers are made of.

use crate::fold;
use bluedither::tables::{KEYS_64, LATTICE_64, NET, OFFSET_2D_64, SEQUENCE, SOBOL_16, THRESHOLD_32, THRESHOLD_64};
use bluedither::{Keys, ScalarMask, VectorMask, hash, lattice, net, shift, sobol, strata, torus, unit, zorder};

pub(crate) fn integers() -> u32 {
    fold((0..99).flat_map(|k| {
        let v = hash::mix(k);
        let long = hash::mix_64(u64::from(v));
        [hash::owen(v, k), hash::owen_4(v, k), hash::shuffle(v, k), hash::other(v), long as u32, (long >> 32) as u32]
            .into_iter()
            .chain([hash::laine_karras(v, k), hash::laine_karras_4(v, k), hash::shuffle_rev(v, k), torus::wrap(v, 8)])
            .chain(torus::offset(v, k, 1, k, k))
    }))
}

pub(crate) fn sequences() -> u32 {
    fold((0..99).flat_map(|k| {
        let v = hash::mix(k);
        let long = zorder::morton(k, v) ^ lattice::r_64::<3>(u64::from(v) << k % 32)[2];
        sobol::owen_point(k, v)
            .into_iter()
            .chain([0, 1, 2, 3].map(|dimension| sobol::dimension(v, dimension)))
            .chain([SOBOL_16.dimension(v, k), SOBOL_16.owen(v, k, k), zorder::morton_16(k, v)])
            .chain([lattice::extensible(k, v), lattice::fixed(k, 99, v), lattice::FIBONACCI[k as usize % 46]])
            .chain(lattice::r::<4>(v))
            .chain(net::add(NET.frames[k as usize % 15], net::add_columns([v; 4], &NET.progressive.place, k)))
            .chain([long as u32, (long >> 32) as u32, SEQUENCE.packed(v) as u32, sobol::directions(k, &[v, 1])[9]])
    }))
}

pub(crate) fn offsets() -> u32 {
    fold((0..99).flat_map(|k| {
        let v = hash::mix(k);
        shift::stratified_2d(v, k, [v, k], [k, v])
            .into_iter()
            .chain([shift::stratified_1d(v, k, v, v), strata::permute(v, k, v), strata::turn(v, k, v)])
            .chain(strata::jittered_2d(v, k, v))
            .chain(strata::regular_2d(v, k))
            .chain([strata::jittered_1d(v, k, v), strata::regular_1d(v, k)])
            .chain(shift::global([v, k], [k, v]))
    }))
}

pub(crate) fn masks() -> u32 {
    let ranks: [u16; 16] = core::array::from_fn(|k| hash::mix(k as u32) as u16 >> 12);
    let scalar = ScalarMask::<4>::from_slice(&ranks).map_or(0, |mask| mask.value_fx(7, 9));
    let vector =
        VectorMask::<2, 4>::from_slice(&ranks.map(|rank| [rank; 2])).map_or([0; 2], |mask| mask.value_fx(7, 9));
    let keys = Keys::<4>::from_slice(&ranks.map(|rank| [rank; 2])).map_or([0; 2], |keys| keys.key(7, 9));
    let refused = ScalarMask::<4>::from_slice(&ranks[1..]).is_none();
    let own = [scalar, vector[0], vector[1], keys[0], keys[1], u32::from(refused)];
    let bytes = THRESHOLD_64.bytes().first_chunk().map_or(0, |&rank| u16::from_ne_bytes(rank));
    let own = own.into_iter().chain([bytes.into()]);
    fold(own.chain((0..4096).flat_map(|p| {
        let (x, y) = (p % 64, p / 64);
        let [[a, b], [c, d], [e, f]] = [OFFSET_2D_64.value_fx(x, y), LATTICE_64.value_fx(x, y), KEYS_64.key(x, y)];
        [THRESHOLD_64.value_fx(x, y), u32::from(THRESHOLD_32.rank(x, y)), a, b, c, d, e, f]
    })))
}

/// Floats of fixed point, and back.
pub(crate) fn conversions() -> u32 {
    fold((0..99).flat_map(|k| {
        let float = unit::to_f32(hash::mix(k));
        let double = unit::to_f64(hash::mix(k)).to_bits();
        let back = [f32::NAN, f32::INFINITY, -1.0, 2.0, float].map(unit::from_f32);
        back.into_iter().chain([float.to_bits(), double as u32, (double >> 32) as u32])
    }))
}
