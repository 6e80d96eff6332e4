//! The tables that cases bind.

use bluedither::frames::masks::TimeMask;
use bluedither::shader::{self, Table};
use bluedither::sobol::Directions;
use bluedither::{Keys, ScalarMask, VectorMask};

use crate::device::Bound;

pub fn net() -> Bound {
    Bound { table: shader::NET, size: String::new(), words: shader::net_words().collect(), extent: [249, 1] }
}

pub fn sequence() -> Bound {
    let words = shader::sequence_words().collect();
    Bound { table: shader::SEQUENCE, size: String::new(), words, extent: [16, 7] }
}

pub fn scalar<const S: usize>(mask: &ScalarMask<S>) -> Bound {
    square::<S>(shader::SCALAR_MASK, shader::scalar_words(mask).collect())
}

pub fn vector<const S: usize>(mask: &VectorMask<2, S>) -> Bound {
    square::<S>(shader::VECTOR_MASK, shader::vector_words(mask).collect())
}

pub fn keys<const S: usize>(keys: &Keys<S>) -> Bound {
    square::<S>(shader::KEYS_TILE, shader::keys_words(keys).collect())
}

pub fn directions<const D: usize>(directions: &Directions<D>) -> Bound {
    let table = shader::DIRECTION_NUMBERS;
    let words = shader::direction_words(directions).collect();
    Bound { table, size: table.size_text(D).to_string(), words, extent: [32, D] }
}

pub fn over_time<const S: usize, const T: usize>(mask: &TimeMask<'_, S, T>) -> Bound {
    let table = shader::TIME_MASK;
    let size = format!("{}const BD_OVER_TIME_FRAMES = {T}u;\n", table.size_text(S));
    Bound { table, size, words: shader::time_words(mask).collect(), extent: [S, S * T] }
}

pub fn linear_light() -> Bound {
    let words = shader::linear_light_words().collect();
    Bound { table: shader::LINEAR_LIGHT, size: String::new(), words, extent: [256, 1] }
}

pub fn seed_swaps() -> Bound {
    square::<64>(shader::SEED_SWAPS, shader::seed_swap_words().collect())
}

fn square<const S: usize>(table: Table, words: Vec<u32>) -> Bound {
    Bound { table, size: table.size_text(S).to_string(), words, extent: [S, S] }
}
