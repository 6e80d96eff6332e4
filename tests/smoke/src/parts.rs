//! What samplers are made of.

use bluedither::sequence::Sequence;
use bluedither::sobol::Directions;
use bluedither::tables::{EFFORT, OFFSET_2D_64, SOBOL_16, THRESHOLD_64};
use bluedither::{Keys, ScalarMask, VectorMask, hash, lattice, net, shift, sobol, strata, torus, unit, warp, zorder};

/// Look-ups and bytes.
#[unsafe(no_mangle)]
pub extern "C" fn masks(x: u32, y: u32) -> f32 {
    let bytes = THRESHOLD_64.bytes().len() + OFFSET_2D_64.bytes().len() + EFFORT.name().len();
    let ranks = THRESHOLD_64.rank(x, y) ^ OFFSET_2D_64.rank(x, y)[1] ^ super::KEYS.key(x, y)[1] as u16;
    let all = THRESHOLD_64.ranks()[3][4] ^ OFFSET_2D_64.ranks()[3][4][1];
    let words = THRESHOLD_64.value_fx(x, y) ^ OFFSET_2D_64.value_fx(x, y)[0];
    THRESHOLD_64.value(x, y) + OFFSET_2D_64.value(x, y)[1] + unit::to_f32(bytes as u32 ^ words ^ u32::from(ranks ^ all))
}

/// Tables of a caller's, of any length.
#[unsafe(no_mangle)]
pub extern "C" fn own_tables(ranks: &[u16; 99], n: usize, x: u32, y: u32) -> u32 {
    let Some(ranks) = ranks.get(..n) else { return 0 };
    let (pairs, _) = ranks.as_chunks::<2>();
    let scalar = ScalarMask::<4>::from_slice(ranks).map_or(0, |mask| mask.value_fx(x, y));
    let vector = VectorMask::<2, 4>::from_slice(pairs).map_or(0, |mask| mask.value_fx(x, y)[1]);
    scalar ^ vector ^ Keys::<4>::from_slice(pairs).map_or(0, |keys| keys.key(x, y)[0])
}

/// Integer parts.
#[unsafe(no_mangle)]
pub extern "C" fn integers(a: u32, b: u32, c: u32) -> u32 {
    let mut sum = hash::combine(a, b) ^ hash::owen(a, b) ^ hash::shuffle(a, b) ^ hash::shuffle_rev(a, b) ^ hash::mix(a);
    sum ^= hash::laine_karras(a, b) ^ hash::laine_karras_4(a, b) ^ hash::owen_4(a, b) ^ hash::other(c);
    sum ^= hash::mix_64(u64::from(a)) as u32 ^ torus::wrap(a, b) ^ torus::offset(a, b, c, a, b)[1];
    sum ^= strata::permute(a, b, c)
        ^ strata::turn(a, b, c)
        ^ strata::jittered_1d(a, b, c)
        ^ strata::jittered_2d(a, b, c)[1];
    sum ^= strata::regular_1d(a, b) ^ strata::regular_2d(a, b)[0] ^ strata::place_1d(a, b, c);
    sum ^= strata::place_2d(a, b, [c, a])[0] ^ shift::global([a, b], [b, c])[1];
    sum ^= shift::stratified_1d(a, b, c, c) ^ shift::stratified_2d(a, b, [c, a], [b, c])[0];
    sum ^= lattice::fixed(a, b, c) ^ lattice::extensible(a, b) ^ lattice::r::<4>(a)[3];
    sum ^= lattice::r_64::<4>(u64::from(a) << 20)[3] as u32;
    sum ^ zorder::morton(a, b) as u32 ^ zorder::morton_16(a, b)
}

/// Sequences, one of the caller's own among them.
#[unsafe(no_mangle)]
pub extern "C" fn sequences(columns: &[[u32; 2]; 32], n: usize, a: u32, b: u32) -> u32 {
    let mut sum = sobol::dimension(a, b) ^ sobol::dimension_0(a) ^ sobol::dimension_1(a) ^ sobol::dimension_1_rev(b);
    sum ^= sobol::point(a)[1] ^ sobol::owen_point(a, b)[1] ^ SOBOL_16.dimension(a, b) ^ SOBOL_16.owen(a, b, a);
    let numbers = columns.as_flattened().get(..n).unwrap_or_default();
    sum ^= Directions::<3>::new([sobol::directions(a, numbers); 3]).owen(a, b, a);
    let own = Sequence::new(columns);
    sum ^ own.packed(a) as u32 ^ own.packed_rev(b) as u32
}

/// Columns of the joint net, of a caller's own tables.
#[unsafe(no_mangle)]
pub extern "C" fn joint_net(tables: &net::Tables, spp: u32, bits: u32) -> u32 {
    let frames = net::add_columns([spp; 4], &tables.frames, bits);
    tables.known(spp).map_or(0, |order| net::add(frames, net::add_columns([bits; 4], &order.samples, bits))[3])
}

/// Floats, and back.
#[unsafe(no_mangle)]
pub extern "C" fn floats(a: u32, value: f32) -> f64 {
    let back = unit::from_f32(value) ^ unit::from_f32(unit::to_f32(a));
    unit::to_f64(back) + f64::from(unit::to_f32s([a, back])[1])
}

/// Warps.
#[unsafe(no_mangle)]
pub extern "C" fn warps(u: f32, v: f32) -> f32 {
    let u = [u, v];
    let flat = warp::disk(u)[0] + warp::triangle(u)[2] + warp::gaussian(u)[1];
    flat + warp::cosine_hemisphere(u)[2] + warp::uniform_hemisphere(u)[2] + warp::sphere(u)[2]
}
