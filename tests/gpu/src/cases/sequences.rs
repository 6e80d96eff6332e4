//! Sequences, strata and shifts.

use bluedither::shader::*;
use bluedither::tables::{NET, SOBOL_16};
use bluedither::{lattice, net, shift, sobol, strata, zorder};

use super::{long, low_high};
use crate::bind;
use crate::case::{Case, case};

pub fn cases() -> Vec<Case> {
    [sobols(), lattices(), curves(), nets(), stratas(), shifts()].into_iter().flatten().collect()
}

fn sobols() -> Vec<Case> {
    vec![
        case(SOBOL, "bd_sobol_dimension_0(a)", |[a]| [sobol::dimension_0(a)]),
        case(SOBOL, "bd_sobol_dimension_1(a)", |[a]| [sobol::dimension_1(a)]),
        case(SOBOL, "bd_sobol_dimension_1_rev(a)", |[a]| [sobol::dimension_1_rev(a)]),
        case(SOBOL, "bd_sobol_point(a)", |[a]| sobol::point(a)),
        case(SOBOL, "bd_sobol_dimension(a, b)", |[a, b]| [sobol::dimension(a, b)]),
        case(SOBOL, "bd_sobol_owen_point(a, b)", |[a, b]| sobol::owen_point(a, b)),
        case(DIRECTIONS, "bd_directions_dimension(a, b)", |[a, b]| [SOBOL_16.dimension(a, b)])
            .with(bind::directions(&SOBOL_16)),
        case(DIRECTIONS, "bd_directions_owen(a, b, c)", |[a, b, c]| [SOBOL_16.owen(a, b, c)])
            .with(bind::directions(&SOBOL_16)),
    ]
}

fn lattices() -> Vec<Case> {
    vec![
        case(LATTICE, "bd_lattice_fixed(a, b, c)", |[a, b, c]| [lattice::fixed(a, b, c)]),
        case(LATTICE, "bd_lattice_extensible(a, b)", |[a, b]| [lattice::extensible(a, b)]),
        case(LATTICE, "bd_lattice_r1(a)", |[a]| lattice::r::<1>(a)),
        case(LATTICE, "bd_lattice_r2(a)", |[a]| lattice::r::<2>(a)),
        case(LATTICE, "bd_lattice_r3(a)", |[a]| lattice::r::<3>(a)),
        case(LATTICE, "bd_lattice_r4(a)", |[a]| lattice::r::<4>(a)),
        case(LATTICE, "bd_lattice_r1_64(vec2(a, b), c)", |[a, b, _]| low_high(lattice::r_64::<1>(long(a, b))[0])),
        case(LATTICE, "bd_lattice_r2_64(vec2(a, b), c)", |[a, b, c]| {
            low_high(lattice::r_64::<2>(long(a, b))[c as usize % 2])
        }),
        case(LATTICE, "bd_lattice_r3_64(vec2(a, b), c)", |[a, b, c]| {
            low_high(lattice::r_64::<3>(long(a, b))[c as usize % 3])
        }),
        case(LATTICE, "bd_lattice_r4_64(vec2(a, b), c)", |[a, b, c]| {
            low_high(lattice::r_64::<4>(long(a, b))[c as usize % 4])
        }),
    ]
}

fn curves() -> Vec<Case> {
    vec![
        case(ZORDER, "bd_zorder_morton(a, b)", |[a, b]| low_high(zorder::morton(a, b))),
        case(ZORDER, "bd_zorder_morton_16(a, b)", |[a, b]| [zorder::morton_16(a, b)]),
    ]
}

fn nets() -> Vec<Case> {
    vec![
        case(JOINT_NET, "bd_net_add(vec4(a, b, c, d), vec4(e, f, g, h))", |[a, b, c, d, e, f, g, h]| {
            net::add([a, b, c, d], [e, f, g, h])
        })
        .with_read(bind::net()),
        case(JOINT_NET, "bd_net_add_columns(vec4(a, b, c, d), BD_NET_FRAMES, e & 0x7fffu)", |[a, b, c, d, e]| {
            net::add_columns([a, b, c, d], &NET.frames, e)
        })
        .with(bind::net()),
        // Inside of any order.
        case(JOINT_NET, "bd_net_add_four(vec4(a, b, c, d), 26u * (e % 9u) + 16u, f, 0u)", |[a, b, c, d, e, f]| {
            let mut orders = NET.known.iter().chain([&NET.progressive]);
            net::add_columns([a, b, c, d], &orders.nth(e as usize % 9).expect("there are 9").inside, f)
        })
        .with(bind::net()),
    ]
}

fn stratas() -> Vec<Case> {
    vec![
        case(STRATA, "bd_strata_place_1d(a, b, c)", |[a, b, c]| [strata::place_1d(a, b, c)]),
        case(STRATA, "bd_strata_place_2d(a, b, vec2(c, d))", |[a, b, c, d]| strata::place_2d(a, b, [c, d])),
        case(STRATA, "bd_strata_place_2d(a, b & 1023u, vec2(c, d))", |[a, b, c, d]| {
            strata::place_2d(a, b & 1023, [c, d])
        }),
        // Squares, where the root jumps.
        case(STRATA, "let root = a & 0xffffu; bd_strata_place_2d(b, root * root + c % 3u - 1u, vec2(d, e))", |given| {
            let [a, b, c, d, e] = given;
            let square = (a & 0xffff) * (a & 0xffff);
            strata::place_2d(b, square.wrapping_add(c % 3).wrapping_sub(1), [d, e])
        }),
        case(STRATA, "bd_strata_regular_1d(a, b)", |[a, b]| [strata::regular_1d(a, b)]),
        case(STRATA, "bd_strata_regular_2d(a, b)", |[a, b]| strata::regular_2d(a, b)),
        case(STRATA, "bd_strata_jittered_1d(a, b, c)", |[a, b, c]| [strata::jittered_1d(a, b, c)]),
        case(STRATA, "bd_strata_jittered_2d(a, b, c)", |[a, b, c]| strata::jittered_2d(a, b, c)),
        case(STRATA, "bd_strata_permute(a, b, c)", |[a, b, c]| [strata::permute(a, b, c)]),
        case(STRATA, "bd_strata_turn(a, b, c)", |[a, b, c]| [strata::turn(a, b, c)]),
    ]
}

fn shifts() -> Vec<Case> {
    vec![
        case(SHIFT, "bd_shift_global1(a, b)", |[a, b]| shift::global([a], [b])),
        case(SHIFT, "bd_shift_global2(vec2(a, b), vec2(c, d))", |[a, b, c, d]| shift::global([a, b], [c, d])),
        case(SHIFT, "bd_shift_global3(vec3(a, b, c), vec3(d, e, f))", |[a, b, c, d, e, f]| {
            shift::global([a, b, c], [d, e, f])
        }),
        case(SHIFT, "bd_shift_global4(vec4(a, b, c, d), vec4(e, f, g, h))", |[a, b, c, d, e, f, g, h]| {
            shift::global([a, b, c, d], [e, f, g, h])
        }),
        case(SHIFT, "bd_shift_stratified_1d(a, b, c, d)", |[a, b, c, d]| [shift::stratified_1d(a, b, c, d)]),
        case(SHIFT, "bd_shift_stratified_2d(a, b, vec2(c, d), vec2(e, f))", |[a, b, c, d, e, f]| {
            shift::stratified_2d(a, b, [c, d], [e, f])
        }),
    ]
}
