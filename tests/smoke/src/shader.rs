//! Texts and words for shaders.

use bluedither::frames::masks::TimeMask;
use bluedither::tables::{KEYS_64, OFFSET_2D_64, SOBOL_16, THRESHOLD_64};
use bluedither::{ScalarMask, shader};

/// Words of tables.
#[unsafe(no_mangle)]
pub extern "C" fn words() -> u32 {
    static MASK: ScalarMask<2> = ScalarMask::new([[0, 1], [2, 3]]);
    static OWN: TimeMask<'_, 2, 1> = TimeMask::new([&MASK]);
    shader::direction_words(&SOBOL_16)
        .chain(shader::keys_words(&KEYS_64))
        .chain(shader::linear_light_words())
        .chain(shader::net_words())
        .chain(shader::scalar_words(&THRESHOLD_64))
        .chain(shader::seed_swap_words())
        .chain(shader::sequence_words())
        .chain(shader::time_words(&OWN))
        .chain(shader::vector_words(&OFFSET_2D_64))
        .fold(0, |sum, word| sum ^ word)
}

/// Texts of any parts, and of tables of any size.
#[unsafe(no_mangle)]
pub extern "C" fn texts(all: bool, side: usize) -> usize {
    let parts = if all { shader::ALL } else { shader::SAMPLER.and(shader::DITHER) };
    let texts: usize = parts.texts().map(str::len).sum();
    let names: usize = parts.names().map(str::len).sum();
    texts + names + shader::SCALAR_MASK.size_text(side).len() + shader::DIRECTION_NUMBERS.size_text(side).len()
}
