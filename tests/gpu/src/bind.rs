//! The tables that cases bind.

use bluedither::shader::{self, Table};
use bluedither::{ScalarMask, VectorMask};

use crate::device::Bound;

pub fn linear_order() -> Bound {
    let words = shader::linear_order_words().collect();
    Bound { table: shader::LINEAR_ORDER, size: "", words, extent: [16, 57] }
}

pub fn scalar<const S: usize>(mask: &ScalarMask<S>) -> Bound {
    square::<S>(shader::SCALAR_MASK, shader::scalar_words(mask).collect())
}

pub fn vector<const S: usize>(mask: &VectorMask<2, S>) -> Bound {
    square::<S>(shader::VECTOR_MASK, shader::vector_words(mask).collect())
}

fn square<const S: usize>(table: Table, words: Vec<u32>) -> Bound {
    Bound { table, size: table.size(S), words, extent: [S, S] }
}
