//! Direction numbers of the Sobol sequence, from `tables/joe_kuo.txt`.

use std::path::Path;

use super::inputs::{damaged, integers};
use super::record::Digests;
use crate::sobol;

/// Dimensions of the tables; each is a feature of the crate.
pub const COUNTS: [usize; 4] = [16, 64, 256, 1024];

const NAME: &str = "joe_kuo";

/// The name of a table, as in `sobol_64`.
pub fn name(count: usize) -> String {
    format!("sobol_{count}")
}

/// Bytes of a table.
pub fn bytes(count: usize) -> usize {
    128 * count
}

/// All dimensions, the first of which the file leaves out. The error is one line with cause and cure.
pub fn read(tables: &Path, digests: &Digests) -> Result<Vec<[u32; 32]>, String> {
    let list = integers(tables, NAME, digests)?;
    let natural: Option<Vec<u32>> = list.iter().map(|&value| u32::try_from(value).ok()).collect();
    let mut rest = &natural.ok_or_else(|| damaged(NAME))?[..];
    let mut all = vec![core::array::from_fn(|bit| 1 << (31 - bit))];
    // Rows of dimension (from 1), degree, coefficients, and as many numbers as the degree.
    while let [dimension, degree, coefficients, numbers @ ..] = rest {
        let degree = *degree as usize;
        if *dimension as usize != all.len() + 1 || degree == 0 || degree > 32 || numbers.len() < degree {
            return Err(damaged(NAME));
        }
        all.push(sobol::directions(*coefficients, &numbers[..degree]));
        rest = &numbers[degree..];
    }
    if rest.is_empty() && all.len() == COUNTS[COUNTS.len() - 1] { Ok(all) } else { Err(damaged(NAME)) }
}
