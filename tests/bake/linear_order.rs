//! The linear pixel order's constants: what is frozen is what the search finds, and what the theory says is what pixels
//! do.

use bluedither::tables::LINEAR_ORDER;
use bluedither::{White, hash, linear};

use crate::analysis::error::{ErrorImage, kernel_norm};
use crate::analysis::net::assert_net;
use crate::bake::linear_order::LinearOrder;
use crate::columns::anneal::{Anneal, random_map};
use crate::columns::net::{self, Candidates};
use crate::columns::power::{self, Power, SIDE};
use crate::columns::response::{BLOCK, Responses};
use crate::tables;

#[test]
#[ignore = "writes tables/linear_order.txt after minutes of search"]
fn write_linear_order() {
    let start = std::time::Instant::now();
    let found = crate::columns::find(&|line| eprintln!("{:4.0} s  {line}", start.elapsed().as_secs_f64()));
    std::fs::write(tables().join("linear_order.txt"), found.text()).expect("tables/ can be written");
}

#[test]
#[ignore = "searches for minutes"]
fn frozen_constants_are_what_the_search_finds() {
    let found = crate::columns::find(&|line| eprintln!("{line}"));
    assert_eq!(found, LinearOrder::read(&tables()).expect("frozen constants"));
}

/// What is frozen is what the library holds.
#[test]
fn embedded_constants_are_the_frozen_ones() {
    let frozen = LinearOrder::read(&tables()).expect("frozen constants");
    assert_eq!(LINEAR_ORDER.known, frozen.orders[..9]);
    assert_eq!(LINEAR_ORDER.progressive, frozen.orders[9]);
    assert_eq!(LINEAR_ORDER.sequence, linear::Sequence::new(&frozen.sequence));
}

#[test]
fn a_damaged_file_is_noticed() {
    let text = std::fs::read_to_string(tables().join("linear_order.txt")).expect("frozen constants");
    let frozen = LinearOrder::parse(&text).expect("as it should be");
    assert_eq!(LinearOrder::parse(&frozen.text()), Some(frozen));
    let first = text.lines().position(|line| !line.starts_with('#')).expect("words");
    let lines: Vec<&str> = text.lines().collect();
    let without = |k: usize| [&lines[..k], &lines[k + 1..]].concat().join("\n");
    let swapped = [&lines[..first], &[lines[first + 1], lines[first]], &lines[first + 2..]].concat().join("\n");
    let longer = text.replacen("\nseal", "\n00000000\nseal", 1);
    let flipped = if lines[first].starts_with('0') { "1" } else { "0" };
    let other = text.replacen(lines[first], &(flipped.to_string() + &lines[first][1..]), 1);
    for damaged in [String::new(), without(first), without(lines.len() - 1), swapped, longer, other] {
        assert_eq!(LinearOrder::parse(&damaged), None);
    }
}

/// The sign of the digits in `c`, first digit in bit 0.
fn character(c: [u32; 2], [x, y]: [u32; 2]) -> i32 {
    let odd = (x.reverse_bits() & c[0]).count_ones() + (y.reverse_bits() & c[1]).count_ones();
    if odd.is_multiple_of(2) { 1 } else { -1 }
}

/// The whole theory: the error on a character is nothing, or a Walsh function over the pixels of a block.
#[test]
fn a_character_is_integrated_or_a_walsh_function_of_the_pixels() {
    let digits = |packed: u64| [(packed >> 32) as u32, packed as u32];
    let upper = |word: u32| [word & 0xffff_0000, word << 16];
    let mut left_over = 0;
    for (m, set) in [(1, &LINEAR_ORDER.known[1][0]), (2, &LINEAR_ORDER.known[2][3]), (4, &LINEAR_ORDER.progressive[7])]
    {
        for c in (1..1024u32).map(|c| [c & 31, c >> 5]) {
            let dual = (0..m).all(|bit| character(c, digits(LINEAR_ORDER.sequence.packed(1 << bit))) == 1);
            left_over += u32::from(dual);
            let function = (0..10).filter(|&bit| character(c, upper(set[bit])) == -1).fold(0, |w, bit| w | 1 << bit);
            for (p, shift) in (0..1024u32).zip((0..).map(hash::mix)) {
                // Columns of x and y take turns, and so do the bits of p.
                let (x, y) =
                    (0..5).fold((0, 0), |(x, y), k| (x | (p >> (2 * k) & 1) << k, y | (p >> (2 * k + 1) & 1) << k));
                let [kx, ky] = upper(linear::digits(set, x, y) ^ shift);
                let sample = |i| digits(LINEAR_ORDER.sequence.packed(i));
                let sum: i32 = (0..1 << m).map(|i| character(c, [sample(i)[0] ^ kx, sample(i)[1] ^ ky])).sum();
                let walsh = if (function & p).count_ones().is_multiple_of(2) { 1 } else { -1 };
                let expected = if dual { (character(c, upper(shift)) * walsh) << m } else { 0 };
                assert_eq!(sum, expected, "{c:?} at {x}, {y}");
            }
        }
    }
    assert!(left_over > 100);
}

#[test]
fn responses_are_what_a_filter_leaves_of_a_walsh_function() {
    let responses = Responses::new();
    let size = 128;
    for w in [0u32, 1, 2, 31, 33, 0b10101_00110, 1023, 512] {
        // One block, all else zero: the rest of the picture is independent of it.
        let sign = |p: u32| if (p & w).count_ones().is_multiple_of(2) { 1.0 } else { -1.0 };
        let inside = |c: u32| (32..32 + BLOCK as u32).contains(&c);
        let at = |x: u32, y: u32| if inside(x) && inside(y) { sign((y - 32) * BLOCK as u32 + x - 32) } else { 0.0 };
        let power = ErrorImage::new(size, 0.0, at).filtered_rms(1.0).powi(2) * (size * size) as f64;
        let white = (BLOCK * BLOCK) as f64 * kernel_norm(size, 1.0).powi(2);
        let ours = f64::from(responses.sigma_1[w as usize]);
        assert!((ours - power / white).abs() < 0.002 * (1.0 + ours), "{w}: {ours} and {}", power / white);
    }
    let mean = responses.sigma_1.iter().map(|&r| f64::from(r)).sum::<f64>() / responses.sigma_1.len() as f64;
    assert!((mean - 1.0).abs() < 1e-4, "{mean}");
}

#[test]
fn owen_variances_are_those_of_scrambled_points() {
    let f = |x: f64, y: f64| x * y + if x + 0.7 * y < 0.8 { 1.0 } else { 0.0 };
    let variances = power::owen_variances(&power::squares(&|x, y| f(x, y)));
    for m in [0, 1, 2, 4, 6] {
        let count = 1u32 << m;
        let estimate = |p: u32| {
            let pixel = White::new(7).pixel(p % 128, p / 128, 0);
            (0..count)
                .map(|i| pixel.draw_fx::<2>(0, i).map(|v| f64::from(v) / 4_294_967_296.0))
                .map(|[x, y]| f(x, y))
                .sum::<f64>()
                / f64::from(count)
        };
        let estimates: Vec<f64> = (0..128 * 128).map(estimate).collect();
        let mean = estimates.iter().sum::<f64>() / estimates.len() as f64;
        let measured = estimates.iter().map(|e| (e - mean) * (e - mean)).sum::<f64>() / estimates.len() as f64;
        // A variance over 2¹⁴ pixels is known to 1 or 2 %.
        assert!((measured / variances[m] - 1.0).abs() < 0.08, "{count}: {measured} and {}", variances[m]);
    }
}

/// A power that falls as that of integrands does, to try the searches on.
fn made_up_power() -> Power {
    let at = |c: usize| if c == 0 { 0.0 } else { 1.0 / (((c % SIDE + 1) * (c / SIDE + 1)) as f32).powi(2) };
    let one: Vec<f32> = (0..SIDE * SIDE).map(at).collect();
    Power { at: [vec![one.clone(); 9], vec![one; 9]] }
}

#[test]
fn an_annealers_energy_is_the_power_of_the_filtered_error() {
    let responses = Responses::new();
    let rows = net::prefix(&net::sobol(3), 2);
    let duals = [Candidates::new(&made_up_power(), 2).duals(&rows)];
    let search = Anneal::new(&duals, &responses, |_, family| Some((family, [1.0, 0.5][family])), 1.0, 1);
    let mut maps = [random_map(1)];
    let naive = |map: &_| {
        let [half_planes, smooth] = duals[0].filtered(map, &responses.both);
        half_planes + 0.5 * smooth
    };
    let before = naive(&maps[0]);
    let untouched = search.run(&mut maps, 1, 0, 0.1);
    assert!((untouched / before - 1.0).abs() < 1e-4);
    let after = search.run(&mut maps, 1, 500, 0.1);
    assert!((after / naive(&maps[0]) - 1.0).abs() < 1e-4, "kept and found anew");
    assert!(after < 0.7 * before, "{before} falls to {after}");
}

#[test]
fn constant_integrands_and_any_heat_end_in_finite_energies() {
    let squares = power::squares(&|_, _| 3.0);
    assert!((squares[0] - 9.0).abs() < 1e-4 && squares[1..].iter().all(|&square| square == 0.0));
    assert_eq!(power::owen_variances(&squares), [0.0; 9]);

    let responses = Responses::new();
    let rows = net::prefix(&net::sobol(3), 2);
    let nothing = Power { at: [vec![vec![0.0; SIDE * SIDE]; 9], vec![vec![0.0; SIDE * SIDE]; 9]] };
    for (power, constant) in [(nothing, true), (made_up_power(), false)] {
        let duals = [Candidates::new(&power, 2).duals(&rows)];
        let search = Anneal::new(&duals, &responses, |_, family| Some((family, 1.0)), 1.0, 1);
        for heat in [0.0, 1e-320, f64::MAX, f64::INFINITY, f64::NAN] {
            let energy = search.run(&mut [random_map(1)], 1, 50, heat);
            assert!(energy.is_finite() && (energy == 0.0) == constant, "heat {heat}: {energy}");
        }
    }
}

#[test]
fn rows_stay_those_of_a_net() {
    let mut rows = net::sobol(0);
    let mut random = crate::columns::anneal::Random::new(9);
    for _ in 0..200 {
        net::add_a_row(&mut rows, &mut random);
    }
    let columns = net::sequence(&rows);
    let sequence = linear::Sequence::new(&columns);
    let points: Vec<[u32; 2]> = (0..1024).map(|i| sequence.packed(i)).map(|p| [(p >> 32) as u32, p as u32]).collect();
    for m in 0..=10 {
        assert_net(&points[..1 << m], "scrambled rows");
    }
    // What the searches sum over: digit j of column b is bit b of row j.
    for (bit, column) in columns.iter().enumerate().take(8) {
        for (number, rows) in rows.iter().enumerate() {
            for (j, row) in rows.iter().enumerate() {
                assert_eq!(column[number] << j >> 31, u32::from(row >> bit & 1), "digit {j}, bit {bit}");
            }
        }
    }
}
