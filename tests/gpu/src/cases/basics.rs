//! Numbers, words, hashes.

use bluedither::shader::*;
use bluedither::{hash, torus, unit};

use super::{long, low_high};
use crate::case::{Case, case};

pub fn cases() -> Vec<Case> {
    [units(), wides(), hashes()].into_iter().flatten().collect()
}

fn units() -> Vec<Case> {
    vec![
        case(UNIT, "bd_unit_to_f32(a)", |[a]| [unit::to_f32(a).to_bits()]),
        case(UNIT, "bd_unit_to_f32s2(vec2(a, b))", |given: [_; 2]| unit::to_f32s(given).map(f32::to_bits)),
        case(UNIT, "bd_unit_to_f32s3(vec3(a, b, c))", |given: [_; 3]| unit::to_f32s(given).map(f32::to_bits)),
        case(UNIT, "bd_unit_to_f32s4(vec4(a, b, c, d))", |given: [_; 4]| unit::to_f32s(given).map(f32::to_bits)),
        case(UNIT, "bd_unit_to_f32s5(array(a, b, c, d, e))", |given: [_; 5]| unit::to_f32s(given).map(f32::to_bits)),
        case(UNIT, "bd_unit_to_f32s6(array(a, b, c, d, e, f))", |given: [_; 6]| unit::to_f32s(given).map(f32::to_bits)),
        case(UNIT, "bd_unit_to_f32s7(array(a, b, c, d, e, f, g))", |given: [_; 7]| {
            unit::to_f32s(given).map(f32::to_bits)
        }),
        case(UNIT, "bd_unit_to_f32s8(array(a, b, c, d, e, f, g, h))", |given: [_; 8]| {
            unit::to_f32s(given).map(f32::to_bits)
        }),
        case(UNIT, "bd_unit_from_f32(bitcast<f32>(a))", |[a]| [unit::from_f32(f32::from_bits(a))]),
        // Bits around 1 and 0.
        case(UNIT, "bd_unit_from_f32(bitcast<f32>(0x2f000000u + a % 0x11000000u))", |[a]| {
            [unit::from_f32(f32::from_bits(0x2f00_0000 + a % 0x1100_0000))]
        }),
    ]
}

fn wides() -> Vec<Case> {
    vec![
        case(WIDE, "bd_wide_product(a, b)", |[a, b]| low_high(u64::from(a) * u64::from(b))),
        case(WIDE, "bd_wide_add(vec2(a, b), vec2(c, d))", |[a, b, c, d]| low_high(long(a, b).wrapping_add(long(c, d)))),
        case(WIDE, "bd_wide_mul(vec2(a, b), vec2(c, d))", |[a, b, c, d]| low_high(long(a, b).wrapping_mul(long(c, d)))),
        case(WIDE, "let divisor = max(c, 1u); bd_wide_divide(vec2(a, b % divisor), divisor)", |[a, b, c]| {
            let (divisor, dividend) = (u64::from(c.max(1)), long(a, b % c.max(1)));
            [(dividend / divisor) as u32, (dividend % divisor) as u32]
        }),
        case(WIDE, "bd_wide_isqrt(vec2(a, b))", |[a, b]| [long(a, b).isqrt() as u32]),
    ]
}

fn hashes() -> Vec<Case> {
    vec![
        case(HASH, "bd_hash_mix(a)", |[a]| [hash::mix(a)]),
        case(HASH, "bd_hash_combine(a, b)", |[a, b]| [hash::combine(a, b)]),
        case(HASH, "bd_hash_mix_64(vec2(a, b))", |[a, b]| low_high(hash::mix_64(long(a, b)))),
        case(HASH, "bd_hash_laine_karras(a, b)", |[a, b]| [hash::laine_karras(a, b)]),
        case(HASH, "bd_hash_owen(a, b)", |[a, b]| [hash::owen(a, b)]),
        case(HASH, "bd_hash_other(a)", |[a]| [hash::other(a)]),
        case(HASH, "bd_hash_laine_karras_4(a, b)", |[a, b]| [hash::laine_karras_4(a, b)]),
        case(HASH, "bd_hash_owen_4(a, b)", |[a, b]| [hash::owen_4(a, b)]),
        case(HASH, "bd_hash_shuffle_rev(a, b)", |[a, b]| [hash::shuffle_rev(a, b)]),
        case(HASH, "bd_hash_shuffle(a, b)", |[a, b]| [hash::shuffle(a, b)]),
        case(TORUS, "bd_torus_wrap(a, 1u << (b & 31u))", |[a, b]| [torus::wrap(a, 1 << (b & 31))]),
        case(TORUS, "bd_torus_offset(a, b, c, d, e)", |[a, b, c, d, e]| torus::offset(a, b, c, d, e)),
        case(TORUS, "bd_torus_offset(a, b, c, d, e & 15u)", |[a, b, c, d, e]| torus::offset(a, b, c, d, e & 15)),
    ]
}
