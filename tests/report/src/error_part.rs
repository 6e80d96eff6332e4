//! Error at powers of two: W, G, root mean squares and spikes of every sampler.

use crate::family::Family;
use crate::figures::{Figures, Value, figures, spikes};
use crate::filter::FILTERS;
use crate::measure::{Bench, Measured, Setting};
use crate::progress::Progress;
use crate::samplers::WHITE;
use crate::table::Table;

/// Samples per pixel of the error figures.
pub const COUNTS: [u32; 8] = [1, 2, 4, 8, 16, 32, 64, 256];

/// A sampler at one number of samples.
#[derive(Debug)]
pub struct Entry {
    pub name: &'static str,
    pub measured: Measured,
    /// Smooth, half-planes.
    pub figures: [Figures; 2],
}

/// Everything that was found, sampler after sampler, sample count after sample count.
#[derive(Debug)]
pub struct Errors {
    pub counts: Vec<u32>,
    pub entries: Vec<Entry>,
}

/// Measures all. `counts` are pairs of what the sampler is told and how many samples are taken.
pub fn measure(bench: &Bench, names: &[&'static str], counts: &[(u32, u32)], seed: u32, seeds: u32) -> Errors {
    let total: u32 = counts.iter().map(|(_, count)| 8 + count).sum();
    let progress = Progress::new("error", total as usize * names.len());
    let mut entries = Vec::new();
    let mut white = Vec::new();
    for &(spp, count) in counts {
        let found = bench.measure(WHITE, Setting { spp, count, first_seed: seed, seeds });
        progress.add(8 + count as usize);
        white.push(found);
    }
    for &name in names {
        for (&(spp, count), white) in counts.iter().zip(&white) {
            let measured = if name == WHITE {
                white.clone()
            } else {
                let found = bench.measure(name, Setting { spp, count, first_seed: seed, seeds });
                progress.add(8 + count as usize);
                found
            };
            let figures = Family::BOTH.map(|family| figures(&measured, white, family));
            entries.push(Entry { name, measured, figures });
        }
    }
    Errors { counts: counts.iter().map(|(_, count)| *count).collect(), entries }
}

impl Errors {
    /// One row a sampler, one column a sample count.
    fn table(&self, id: &str, title: &str, about: &str, cell: impl Fn(&Entry) -> String) -> Table {
        let head = core::iter::once("samples".to_string()).chain(self.counts.iter().map(u32::to_string)).collect();
        let row = |row: &[Entry]| core::iter::once(row[0].name.to_string()).chain(row.iter().map(&cell)).collect();
        let rows = self.entries.chunks(self.counts.len()).map(row).collect();
        Table { id: id.into(), title: title.into(), about: about.into(), head, rows }
    }

    /// All tables of this part.
    pub fn tables(&self) -> Vec<Table> {
        let mut all = Vec::new();
        for (k, family) in Family::BOTH.map(Family::name).into_iter().enumerate() {
            for f in [0, 1, 2] {
                all.push(self.w(k, f, family));
            }
        }
        for (k, family) in Family::BOTH.map(Family::name).into_iter().enumerate() {
            for (f, sigma) in [(0, "1"), (7, "2")] {
                all.push(self.table(
                    &format!("gain-{sigma}-{family}"),
                    &format!("G({sigma}), {family}"),
                    "Filtered error over what the filter leaves of white noise of the same size.",
                    |entry| short(entry.figures[k].g[f]),
                ));
            }
            all.push(self.table(
                &format!("rms-{family}"),
                &format!("Root-mean-square error, {family}"),
                "Before any filter; in brackets over that of white noise.",
                |entry| format!("{:.2e} ({})", entry.figures[k].rms, short(entry.figures[k].rms_over_white.mean)),
            ));
        }
        all.push(self.table(
            "spike",
            "Spike, half-planes",
            "Largest bin of the mean periodogram over the mean bin: mean over the lines (worst line). White: 2.3.",
            |entry| {
                let [mean, worst] = spikes(&entry.measured.spikes);
                format!("{mean:.1} ({worst:.0})")
            },
        ));
        all
    }

    /// W of a family after a filter.
    pub fn w(&self, k: usize, f: usize, family: &str) -> Table {
        let filter = match FILTERS[f].name() {
            name if name.starts_with("box") => name,
            name => format!("sigma {name}"),
        };
        self.table(
            &format!("w-{}-{family}", filter.replace(' ', "-")),
            &format!("W, {filter}, {family}"),
            "Filtered error over that of white noise at the same number of samples, with standard errors in thousandths.",
            |entry| with_error(entry.figures[k].w[f]),
        )
    }
}

/// `.423 ±5`: three digits, the standard error in thousandths.
pub fn with_error(value: Value) -> String {
    format!("{} ±{:.0}", short(value.mean), (value.error * 1000.0).ceil())
}

/// Three digits, no zero before the point.
pub fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.strip_prefix('0').map(str::to_string).unwrap_or(text)
}
