//! What baking reads from `tables/`: lists of integers, each with its provenance and its formula.
//!
//! They are files and not calls of `exp` and `cos`, so that no recorded mask changes with a library's last digit. What
//! is read is held against its formula and its digest, so that a damaged file is an error and not a worse picture.

use std::path::Path;

use super::anneal::LANES;
use super::digest::digest;
use super::features::Column;
use super::filter::Filter;
use super::keys;
use super::record::{Digests, read_text};
use super::sequence::Columns;

/// The contents of `tables/`, checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inputs {
    /// The weights of [`VOID_AND_CLUSTER`] at index r².
    pub void_and_cluster_kernel: Vec<i32>,
    /// The weights of [`ANNEAL`] at index r².
    pub anneal_kernel: Vec<i32>,
    /// 2¹⁴·cos(π i/512), i = 0..=256.
    pub cosine: Vec<i32>,
    /// What [`super::features`] says of one dimension.
    pub features_1d: Vec<Column>,
    /// What [`super::features`] says of two dimensions.
    pub features_2d: Vec<Column>,
    /// What [`super::keys`] says of 1, 4, 16 and 64 samples, in this order.
    pub features_keys: Vec<Column>,
    /// What [`super::features`] says of shifted lattices.
    pub features_lattice: Vec<Column>,
    /// What keys are points of.
    pub sequence: Columns,
    /// Not of a file: what the user says comes after the mask.
    pub filter: Filter,
}

/// A list that is a formula: file name, number of entries, entry.
type Formula = (&'static str, usize, fn(f64) -> f64);

/// 2·1.4²: the narrower Gaussian of the next.
pub const NARROW: f64 = 3.92;
/// 2²⁰·(exp(−r²/(2·1.4²)) + exp(−r²/(2·2.5²))/10). Ulichney's deviation of 1.5 alone leaves a twelfth more
/// error on smooth integrands and a fortieth on steps; the wide part holds down what is left after a wide filter.
pub const VOID_AND_CLUSTER: Formula =
    ("void_and_cluster_kernel", 101, |r2| 1_048_576.0 * (libm::exp(-r2 / NARROW) + 0.1 * libm::exp(-r2 / 12.5)));
/// 128·exp(−r²/2.2²), up to a distance of 4.9: the kernel of Georgiev and Fajardo, a little wider (2.1 leaves more
/// error after wide filters, 2.3 after narrow ones).
pub const ANNEAL: Formula = ("anneal_kernel", 25, |r2| 128.0 * libm::exp(-r2 / 4.84));
/// 2¹⁴·cos(π i/512): a quarter of a wave.
pub const COSINE: Formula = ("cosine", 257, |i| 16384.0 * libm::cos(i * core::f64::consts::PI / 512.0));

impl Inputs {
    /// Reads and checks them all. The error is one line with cause and cure.
    pub fn read(tables: &Path, digests: &Digests) -> Result<Self, String> {
        let formula = |(name, count, entry): Formula| -> Result<Vec<i32>, String> {
            let list = integers(tables, name, digests)?;
            // One unit either way: libm's last digit is not ours to promise.
            let fits = |(i, &value): (usize, &i64)| (value as f64 - entry(i as f64)).abs() <= 1.0;
            if list.len() != count || !list.iter().enumerate().all(fits) {
                return Err(damaged(name));
            }
            list.iter().map(|&value| i32::try_from(value).map_err(|_| damaged(name))).collect()
        };
        let columns = |name, lanes| -> Result<Vec<Column>, String> {
            let list = integers(tables, name, digests)?;
            let column = |row: &[i64]| {
                let natural = |i: usize| u32::try_from(row[i]).ok().filter(|&n| n <= 64);
                Some(Column { samples: natural(0)?, k: [natural(1)?, natural(2)?], weight: row[3] })
            };
            let columns: Option<Vec<Column>> = list.chunks_exact(4).map(column).collect();
            columns.filter(|columns| columns.len() == lanes && list.len() == 4 * lanes).ok_or_else(|| damaged(name))
        };
        Ok(Self {
            void_and_cluster_kernel: formula(VOID_AND_CLUSTER)?,
            anneal_kernel: formula(ANNEAL)?,
            cosine: formula(COSINE)?,
            features_1d: columns("features_1d", LANES)?,
            features_2d: columns("features_2d", LANES)?,
            features_keys: columns("features_keys", keys::PREFIXES.len() * keys::LANES)?,
            features_lattice: columns("features_lattice", LANES)?,
            sequence: Columns::read(tables)?,
            filter: Filter::default(),
        })
    }
}

/// The integers of `tables/NAME.txt`, where `#` starts a comment, when their digest is the recorded one.
pub fn integers(tables: &Path, name: &str, digests: &Digests) -> Result<Vec<i64>, String> {
    let text = read_text(tables, name)?;
    let words = text.lines().flat_map(|line| line.split('#').next().unwrap_or("").split_whitespace());
    let list: Result<Vec<i64>, _> = words.map(str::parse).collect();
    let list = list.map_err(|_| damaged(name))?;
    match digests.get("input", name) {
        Some(recorded) if recorded == digest(list.iter().copied()) => Ok(list),
        _ => Err(damaged(name)),
    }
}

/// The line that says so.
pub fn damaged(name: &str) -> String {
    format!("tables/{name}.txt is damaged: restore it from the package, or record it anew (see tables/digests.txt)")
}
