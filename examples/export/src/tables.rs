//! The tables of this build, by the names of their features.

use crate::digest;

/// What a table's numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Ranks of one channel: thresholds or offsets.
    Scalar,
    /// Ranks of two channels: offsets or shifts.
    Vector,
    /// Ranks of one channel, a mask for every frame.
    Frames,
    /// The upper 16 digits of two keys.
    Keys,
    /// Swaps of seeds, four bits a round.
    Codes,
    /// Direction numbers, 32 a dimension.
    Directions,
}

/// A table of the library.
#[derive(Clone, Debug)]
pub struct Table {
    /// The feature that bakes it.
    pub name: &'static str,
    pub kind: Kind,
    /// Pixels in a row, or direction numbers of a dimension.
    pub width: usize,
    /// Row by row, channels interleaved.
    pub numbers: Vec<u32>,
}

impl Table {
    /// Numbers a pixel.
    pub fn channels(&self) -> usize {
        if matches!(self.kind, Kind::Vector | Kind::Keys) { 2 } else { 1 }
    }

    /// Rows, those of all frames together.
    pub fn rows(&self) -> usize {
        self.numbers.len() / self.width / self.channels()
    }

    /// Masks for so many frames.
    pub fn frames(&self) -> usize {
        if self.kind == Kind::Frames { self.rows() / self.width } else { 1 }
    }

    /// log₂ of the width.
    pub fn size_log2(&self) -> u32 {
        self.width.trailing_zeros()
    }

    /// Whether its numbers are ranks 0..width²−1.
    pub fn is_mask(&self) -> bool {
        matches!(self.kind, Kind::Scalar | Kind::Vector | Kind::Frames)
    }

    /// As in C: `threshold_64`.
    pub fn identifier(&self) -> String {
        self.name.replace('-', "_")
    }

    /// As it stands in the library's `tables/digests.txt`; direction numbers are not baked and have none there.
    pub fn digest(&self) -> Option<u64> {
        (self.kind != Kind::Directions).then(|| digest::digest(self.numbers.iter().map(|&number| i64::from(number))))
    }
}

/// Pairs over time, and two megabytes.
const LEFT_OUT: [&str; 3] = ["threshold-over-time-128", "offset-2d-over-time-32", "offset-2d-over-time-64"];

/// All tables that this build has, and the names of the others.
fn inventory() -> (Vec<Table>, Vec<&'static str>) {
    #[allow(unused_mut, reason = "without features there are none")]
    let mut built = Vec::new();
    #[allow(unused_mut, reason = "with all features there are no others")]
    let mut others = Vec::new();
    macro_rules! table {
        ($feature:literal, $width:literal, $table:ident, $kind:ident) => {
            #[cfg(feature = $feature)]
            built.push(Table {
                name: $feature,
                kind: Kind::$kind,
                width: $width,
                numbers: table!(@numbers $table, $kind),
            });
            #[cfg(not(feature = $feature))]
            others.push($feature);
        };
        (@numbers $table:ident, Scalar) => { wide(bluedither::tables::$table.ranks().as_flattened()) };
        (@numbers $table:ident, Vector) => { wide(bluedither::tables::$table.ranks().as_flattened().as_flattened()) };
        (@numbers $table:ident, Codes) => { wide(bluedither::tables::$table.codes().as_flattened()) };
        (@numbers $table:ident, Frames) => {
            bluedither::tables::$table.frames().iter().flat_map(|mask| wide(mask.ranks().as_flattened())).collect()
        };
        (@numbers $table:ident, Keys) => { digits(&bluedither::tables::$table) };
        (@numbers $table:ident, Directions) => { bluedither::shader::direction_words(&bluedither::tables::$table).collect() };
    }
    table!("threshold-16", 16, THRESHOLD_16, Scalar);
    table!("threshold-32", 32, THRESHOLD_32, Scalar);
    table!("threshold-64", 64, THRESHOLD_64, Scalar);
    table!("threshold-128", 128, THRESHOLD_128, Scalar);
    table!("threshold-256", 256, THRESHOLD_256, Scalar);
    table!("offset-1d-16", 16, OFFSET_1D_16, Scalar);
    table!("offset-1d-32", 32, OFFSET_1D_32, Scalar);
    table!("offset-1d-64", 64, OFFSET_1D_64, Scalar);
    table!("offset-1d-128", 128, OFFSET_1D_128, Scalar);
    table!("offset-2d-16", 16, OFFSET_2D_16, Vector);
    table!("offset-2d-32", 32, OFFSET_2D_32, Vector);
    table!("offset-2d-64", 64, OFFSET_2D_64, Vector);
    table!("offset-2d-128", 128, OFFSET_2D_128, Vector);
    table!("keys-64", 64, KEYS_64, Keys);
    table!("keys-128", 128, KEYS_128, Keys);
    table!("lattice-64", 64, LATTICE_64, Vector);
    table!("threshold-over-time-32", 32, THRESHOLD_OVER_TIME_32, Frames);
    table!("threshold-over-time-64", 64, THRESHOLD_OVER_TIME_64, Frames);
    table!("threshold-filtered-64", 64, THRESHOLD_FILTERED_64, Scalar);
    table!("threshold-filtered-over-time-64", 64, THRESHOLD_FILTERED_OVER_TIME_64, Frames);
    table!("seed-permutation", 64, SEED_PERMUTATION, Codes);
    table!("sobol-16", 32, SOBOL_16, Directions);
    table!("sobol-64", 32, SOBOL_64, Directions);
    table!("sobol-256", 32, SOBOL_256, Directions);
    table!("sobol-1024", 32, SOBOL_1024, Directions);
    (built, others)
}

/// The tables of these names, all if there are none. The error is one line with cause and cure.
pub fn named(names: &[String]) -> Result<Vec<Table>, String> {
    let (mut built, others) = inventory();
    for name in names {
        if LEFT_OUT.contains(&name.as_str()) {
            return Err(format!("{name} is not exported: take its words by the Rust crate's `shader`, frame by frame"));
        }
        if others.contains(&name.as_str()) {
            return Err(format!("{name} is not in this build: add it by `cargo run -p export --features {name} -- …`"));
        }
        if !built.iter().any(|table| table.name == name) {
            let there: Vec<_> = built.iter().map(|table| table.name).collect();
            let there = there.join(", ");
            let more =
                if others.is_empty() { String::new() } else { format!("; and, by --features, {}", others.join(", ")) };
            return Err(format!("no table is named {name}: there are {there}{more}"));
        }
    }
    built.retain(|table| names.is_empty() || names.iter().any(|name| name == table.name));
    Ok(built)
}

fn wide(numbers: &[u16]) -> Vec<u32> {
    numbers.iter().map(|&number| number.into()).collect()
}

#[allow(dead_code, clippy::cast_possible_truncation, reason = "without a feature of keys there are none; small sizes")]
fn digits<const S: usize>(keys: &bluedither::Keys<S>) -> Vec<u32> {
    (0..S * S).flat_map(|place| keys.key((place % S) as u32, (place / S) as u32)).map(|key| key >> 16).collect()
}
