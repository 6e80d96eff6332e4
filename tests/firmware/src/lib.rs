//! Checksums of every family of functions, the same on every machine, and the calls whose cost the README states.
#![no_std]

pub mod calls;
mod floats;
mod halftones;
mod parts;
mod samplers;
mod target;
mod time;

use bluedither::tables::THRESHOLD_64;
use bluedither::{Dither, hash};

/// A family and how its checksum is made.
pub type Family = (&'static str, fn() -> u32);

/// Integers only: `run.sh` looks for floating point in what [`integers`] links on a machine without it.
pub const INTEGERS: &[Family] = &[
    ("hash, unit, torus", parts::integers),
    ("sobol, zorder, lattice, sequence, net", parts::sequences),
    ("strata, shift", parts::offsets),
    ("masks", parts::masks),
    ("sampler", samplers::sampler),
    ("sampler, progressive", samplers::progressive),
    ("dithered", samplers::dithered),
    ("dithered, strata", samplers::stratified),
    ("white", samplers::white),
    ("keyed", samplers::keyed),
    ("lattice", samplers::lattice),
    ("masks over time", time::masks),
    ("seed permutation", time::seeds),
    ("best candidate", time::candidate),
    ("dither, grey", halftones::grays),
    ("dither, colour and alpha", halftones::colors),
    ("dither, triangular", halftones::triangular),
    ("dither, gamma", halftones::gamma),
    ("dither, draw target", target::target),
];

/// What returns floats or takes them.
pub const FLOATS: &[Family] = &[
    ("floats of samplers and masks", floats::samplers),
    ("warp", floats::warps),
    #[cfg(feature = "float")]
    ("dither, float rows", floats::rows),
];

/// All families of integers.
#[must_use]
pub fn integers() -> u32 {
    INTEGERS.iter().fold(0, |sum, (_, work)| hash::combine(sum, work()))
}

fn fold(words: impl IntoIterator<Item = u32>) -> u32 {
    words.into_iter().fold(1, hash::combine)
}

/// One row of 400 pixels of grey to 1 bit, for counting instructions; the first byte.
#[inline(never)]
pub fn one_row(y: u32, source: &[u8; 400], bits: &mut [u8; 50]) -> u8 {
    const BLUE: Dither<'_> = Dither::blue(&THRESHOLD_64);
    match BLUE.gray1_row(y, source, bits) {
        Ok(()) => bits[0],
        Err(_) => 0,
    }
}
