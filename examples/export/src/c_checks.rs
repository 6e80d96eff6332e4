//! Every function of the header gives the bits of the library's: compiled by the C compiler of this machine, in strict
//! C99 and as C++, included in several translation units, and called with random and extreme arguments.

use crate::{c, tables};
use bluedither::tables as library;
use bluedither::{Dither, Keyed, Sampler, White, dither, hash, shift, sobol, strata, torus, unit, zorder};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Calls of each function.
const CALLS: u32 = 1 << 20;

type Arguments = [u32; 8];
type Results = [u32; 4];

/// What a function of the header returns, by the library.
type Twin = fn(Arguments) -> Results;

const FUNCTIONS: &[(&str, Twin)] = &[
    ("unit_to_f32", |a| one(unit::to_f32(a[0]).to_bits())),
    ("hash_mix", |a| one(hash::mix(a[0]))),
    ("hash_combine", |a| one(hash::combine(a[0], a[1]))),
    ("hash_laine_karras", |a| one(hash::laine_karras(a[0], a[1]))),
    ("hash_owen", |a| one(hash::owen(a[0], a[1]))),
    ("hash_other", |a| one(hash::other(a[0]))),
    ("hash_laine_karras_4", |a| one(hash::laine_karras_4(a[0], a[1]))),
    ("hash_owen_4", |a| one(hash::owen_4(a[0], a[1]))),
    ("hash_shuffle_rev", |a| one(hash::shuffle_rev(a[0], a[1]))),
    ("hash_shuffle", |a| one(hash::shuffle(a[0], a[1]))),
    ("hash_mix_64", |a| two(halves(hash::mix_64(u64::from(a[0]) << 32 | u64::from(a[1]))))),
    ("torus_wrap", |a| one(torus::wrap(a[0], 1 << (a[1] % 32)))),
    ("torus_offset", |a| {
        four(torus::offset(a[0], a[1], a[2], a[3], a[4]), torus::offset(a[0], a[1], a[2], a[3], a[5] % 33))
    }),
    ("sobol_point", |a| two(sobol::point(a[0]))),
    ("sobol_dimension_1_rev", |a| one(sobol::dimension_1_rev(a[0]))),
    ("sobol_owen_point", |a| two(sobol::owen_point(a[0], a[1]))),
    ("directions_dimension", |a| one(library::SOBOL_16.dimension(a[0], a[1]))),
    ("directions_owen", |a| one(library::SOBOL_16.owen(a[0], a[1], a[2]))),
    ("zorder_morton_16", |a| one(zorder::morton_16(a[0], a[1]))),
    ("strata_place_1d", |a| one(strata::place_1d(a[0], a[1], a[2]))),
    ("strata_place_2d", |a| two(strata::place_2d(a[0], a[1], [a[2], a[3]]))),
    ("shift_global", |a| one(shift::global([a[0]], [a[1]])[0])),
    ("shift_stratified_1d", |a| one(shift::stratified_1d(a[0], a[1], a[2], a[3]))),
    ("shift_stratified_2d", |a| two(shift::stratified_2d(a[0], a[1], [a[2], a[3]], [a[4], a[5]]))),
    ("scalar_rank", |a| {
        let [x, y] = [a[0], a[1]];
        [library::THRESHOLD_64.rank(x, y), library::THRESHOLD_256.rank(x, y), library::THRESHOLD_16.rank(x, y), 0]
            .map(u32::from)
    }),
    ("scalar_value", |a| {
        let [x, y] = [a[0], a[1]];
        let float = library::THRESHOLD_16.value(x, y).to_bits();
        [library::THRESHOLD_64.value_fx(x, y), library::THRESHOLD_256.value_fx(x, y), float, 0]
    }),
    ("vector_value", |a| four(library::OFFSET_2D_64.value_fx(a[0], a[1]), library::LATTICE_64.value_fx(a[0], a[1]))),
    ("time_mask_frame", |a| {
        let short = library::THRESHOLD_OVER_TIME_32.frame(a[2]).rank(a[0], a[1]);
        two([short.into(), library::THRESHOLD_OVER_TIME_64.frame(a[2]).rank(a[0], a[1]).into()])
    }),
    ("keys_key", |a| four(library::KEYS_64.key(a[0], a[1]), library::KEYS_128.key(a[0], a[1]))),
    ("dither_threshold_fx", |a| {
        let large = Dither::blue(&library::THRESHOLD_64).frame(a[3]).threshold_fx(a[0], a[1], a[2]);
        two([large, Dither::blue(&library::THRESHOLD_16).frame(a[3]).threshold_fx(a[0], a[1], a[2])])
    }),
    ("quantise_level", |a| one(dither::quantise::level(a[0] as u16, a[1] as u16, a[2] as u16, a[3]).into())),
    ("dither_gray1_row", |a| {
        let gray: Vec<u8> = a[2..].iter().flat_map(|word| word.to_le_bytes()).collect();
        let mut bits = [0xa5; 4];
        let row = Dither::blue(&library::THRESHOLD_64).frame(a[1]);
        row.gray1_row(a[0], &gray[..a[1] as usize % 25], &mut bits).expect("there is room for 24 pixels");
        bits.map(u32::from)
    }),
];

/// The same draws as in `checks/samplers.c`.
macro_rules! draws {
    ($name:literal, |$a:ident| $sampler:expr) => {
        &[
            (concat!($name, "_draw1"), |$a| {
                let pixel = $sampler.pixel($a[2], $a[3], $a[4]);
                two([pixel.draw_fx::<1>($a[5], $a[6])[0], pixel.draw::<1>($a[5], $a[6])[0].to_bits()])
            }),
            draws!(2 $name, |$a| $sampler),
            draws!(3 $name, |$a| $sampler),
            draws!(4 $name, |$a| $sampler),
            draws!(5 $name, |$a| $sampler),
            draws!(6 $name, |$a| $sampler),
            draws!(7 $name, |$a| $sampler),
            draws!(8 $name, |$a| $sampler),
        ]
    };
    ($d:literal $name:literal, |$a:ident| $sampler:expr) => {
        (concat!($name, "_draw", $d), |$a| {
            let pixel = $sampler.pixel($a[2], $a[3], $a[4]);
            let (fx, floats) = (pixel.draw_fx::<$d>($a[5], $a[6]), pixel.draw::<$d>($a[5], $a[6]));
            let mut all = [0u32; 4];
            for (k, (fx, float)) in fx.into_iter().zip(floats).enumerate() {
                all[k % 4] = hash::combine(all[k % 4].wrapping_add(fx), float.to_bits());
            }
            all
        })
    };
}

const SAMPLERS: [&[(&str, Twin)]; 3] = [
    draws!("sampler", |a| if a[7] & 1 == 1 { Sampler::new(a[0]) } else { Sampler::with_spp(a[0], a[1]) }),
    draws!("white", |a| if a[7] & 1 == 1 { White::new(a[0]) } else { White::with_spp(a[0], a[1]) }),
    draws!("keyed", |a| Keyed::with_keys(&library::KEYS_64, a[0])),
];

const fn one(value: u32) -> Results {
    [value, 0, 0, 0]
}

const fn two([first, second]: [u32; 2]) -> Results {
    [first, second, 0, 0]
}

const fn four(first: [u32; 2], second: [u32; 2]) -> Results {
    [first[0], first[1], second[0], second[1]]
}

fn halves(word: u64) -> [u32; 2] {
    [(word >> 32) as u32, word as u32]
}

/// Words of a call: any, small, with one bit set, or near a border, each by chance.
fn arguments(call: u32) -> Arguments {
    core::array::from_fn(|place| {
        let random = hash::combine(hash::combine(1, call), place as u32);
        match hash::mix(random) % 8 {
            0 => [0, 1, 2, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, 0xffff, 0x1_0000][random as usize % 8],
            1 => 1 << (random % 32),
            2 => (1u32 << (random % 32)).wrapping_sub(1),
            3 | 4 => random >> 24,
            _ => random,
        }
    })
}

/// Compiles the checks against the header in a folder of their own; the program's path.
fn compile(compiler: &str, standard: &[&str], name: &str) -> PathBuf {
    let checks = Path::new(env!("CARGO_MANIFEST_DIR")).join("checks");
    let folder = std::env::current_exe().expect("this test has a path").with_file_name(format!("c-checks-{name}"));
    std::fs::create_dir_all(&folder).expect("a folder beside this test");
    let all = tables::named(&[]).expect("all tables");
    std::fs::write(folder.join("bluedither.h"), c::header(&all)).expect("a file beside this test");
    let program = folder.join("checks");
    let output = Command::new(compiler)
        .args(standard)
        .args(["-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Wshadow", "-Wundef", "-Werror", "-O2", "-I"])
        .arg(&folder)
        .args(["main.c", "functions.c", "samplers.c"].map(|file| checks.join(file)))
        .arg("-o")
        .arg(&program)
        .output()
        .unwrap_or_else(|error| panic!("{compiler} does not run ({error}): install gcc and g++"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    program
}

/// Holds every function against its twin.
fn compare(program: &Path) {
    let calls = program.with_file_name("calls");
    let all: Vec<Arguments> = (0..CALLS).map(arguments).collect();
    let bytes: Vec<u8> = all.as_flattened().iter().flat_map(|word| word.to_ne_bytes()).collect();
    std::fs::write(&calls, bytes).expect("a file beside this test");
    for &(name, twin) in FUNCTIONS.iter().chain(SAMPLERS.into_iter().flatten()) {
        let output = Command::new(program).arg(name).arg(&calls).output().expect("the checks run");
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(output.stdout.len(), all.len() * size_of::<Results>(), "{name} was not called often enough");
        for (found, &arguments) in output.stdout.chunks_exact(size_of::<Results>()).zip(&all) {
            let word = |k: usize| u32::from_ne_bytes(core::array::from_fn(|byte| found[4 * k + byte]));
            assert_eq!(core::array::from_fn(word), twin(arguments), "{name} of {arguments:#x?}");
        }
    }
}

#[test]
fn c99_has_the_same_bits() {
    compare(&compile("cc", &["-std=c99"], "c"));
}

/// Compiled only: the same text, and nothing in it that C++ reads differently.
#[test]
fn cpp_compiles() {
    compile("c++", &["-x", "c++", "-std=c++11"], "cpp");
}

/// A header without tables, by itself.
#[test]
fn a_header_without_tables_compiles() {
    let folder = std::env::current_exe().expect("this test has a path").with_file_name("c-checks-bare");
    std::fs::create_dir_all(&folder).expect("a folder beside this test");
    let file = folder.join("bluedither.h");
    std::fs::write(&file, c::header(&[])).expect("a file beside this test");
    let flags = ["-std=c99", "-x", "c", "-Wall", "-Wextra", "-pedantic", "-Wconversion", "-Werror", "-fsyntax-only"];
    let output = Command::new("cc").args(flags).arg(&file).output().expect("cc runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
