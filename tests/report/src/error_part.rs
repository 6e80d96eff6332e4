//! Error at powers of two: W, G, root mean squares and spikes of every sampler.

use crate::bench::{Bench, Measured, Setting};
use crate::family::Family;
use crate::field::Drawn;
use crate::figures::{Figures, Value, figures, spikes};
use crate::filter::{FILTERS, Filter};
use crate::frozen;
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

/// Measures all: each sampler, each of `all`, over so many seeds from the one there on.
pub fn measure(bench: &Bench, names: &[&'static str], all: &[Drawn], seeds: u32) -> Errors {
    // Transforms take the time of some samples.
    let cost = |drawn: &Drawn| 8 + (drawn.count * drawn.frames) as usize;
    let others = names.iter().filter(|name| **name != WHITE);
    let progress = Progress::new("error", all.iter().map(cost).sum::<usize>() * (1 + others.count()));
    let measure = |name: &str, first: &Drawn| {
        let found = bench.measure(name, Setting { first: *first, seeds });
        progress.add(cost(first));
        found
    };
    let white: Vec<Measured> = all.iter().map(|first| measure(WHITE, first)).collect();
    let mut entries = Vec::new();
    for &name in names {
        for (first, white) in all.iter().zip(&white) {
            let measured = if name == WHITE { white.clone() } else { measure(name, first) };
            let figures = Family::BOTH.map(|family| figures(&measured, white, family));
            entries.push(Entry { name, measured, figures });
        }
    }
    Errors { counts: white.iter().map(|found| found.count).collect(), entries }
}

impl Errors {
    /// One row a sampler, one column a sample count.
    fn table(&self, id: &str, title: &str, about: &str, cell: impl Fn(&Entry) -> String) -> Table {
        let head = core::iter::once("samples".to_string()).chain(self.counts.iter().map(u32::to_string)).collect();
        let row = |row: &[Entry]| core::iter::once(row[0].name.to_string()).chain(row.iter().map(&cell)).collect();
        let rows = self.entries.chunks(self.counts.len()).map(row).collect();
        Table { id: id.into(), title: title.into(), about: about.into(), head, rows }
    }

    /// W at sigma 1, 1.485 and 2.1, the first with what was published; G, root mean squares, spikes.
    pub fn tables(&self) -> Vec<Table> {
        let mut all = Vec::new();
        let families = || Family::BOTH.map(Family::name).into_iter().enumerate();
        for (k, family) in families() {
            let mut table = self.w(k, Filter::Gauss(1.0), family);
            if self.counts == COUNTS {
                table.rows.push(frozen::row(family));
            }
            all.push(table);
        }
        for (k, family) in families() {
            all.push(self.table(
                &format!("rms-{family}"),
                &format!("Root-mean-square error, {family}"),
                "Before any filter; in brackets the same over white noise's.",
                |entry| format!("{:.2e} ({})", entry.figures[k].rms, short(entry.figures[k].rms_over_white.mean)),
            ));
        }
        all.push(self.spike());
        for (k, family) in families() {
            all.extend([1.485, 2.1].map(|sigma| self.w(k, Filter::Gauss(sigma), family)));
            for filter in [1.0, 2.0].map(Filter::Gauss) {
                all.push(self.table(
                    &format!("gain-{}-{family}", filter.name()),
                    &format!("G({}), {family}", filter.name()),
                    "Filtered error over what the filter leaves of white noise of the same size.",
                    |entry| short(entry.figures[k].g[filter.place()]),
                ));
            }
        }
        all
    }

    /// W after the other filters.
    pub fn filter_tables(&self) -> Vec<Table> {
        let families = || Family::BOTH.map(Family::name).into_iter().enumerate();
        let filters = [Filter::Gauss(0.7), Filter::Gauss(4.0), Filter::Box(3), Filter::Box(5)];
        families().flat_map(|(k, family)| filters.map(|filter| self.w(k, filter, family))).collect()
    }

    /// W at sigma 1 alone, under another name and title.
    pub fn brief(&self, id: &str, title: &str) -> Vec<Table> {
        let brief = |(k, family): (usize, &str)| Table {
            id: format!("{id}-{family}"),
            title: format!("{title}, {family}"),
            ..self.w(k, Filter::Gauss(1.0), family)
        };
        Family::BOTH.map(Family::name).into_iter().enumerate().map(brief).collect()
    }

    fn spike(&self) -> Table {
        self.table(
            "spike",
            "Spike, half-planes",
            "Largest bin of the mean periodogram over the mean bin: mean over the lines (worst line). White: 2.3.",
            |entry| {
                let [mean, worst] = spikes(&entry.measured.spikes);
                format!("{mean:.1} ({worst:.0})")
            },
        )
    }

    /// Every figure at full length, a row each.
    pub fn csv(&self) -> String {
        let mut text = String::from("sampler,samples,family,figure,filter,value,standard_error\n");
        for entry in &self.entries {
            for (family, found) in Family::BOTH.into_iter().zip(&entry.figures) {
                let start = format!("{},{},{}", entry.name, entry.measured.count, family.name());
                let mut line = |figure: &str, filter: &str, value: f64, error: Option<f64>| {
                    let error = error.map(|e| e.to_string()).unwrap_or_default();
                    text += &format!("{start},{figure},{filter},{value},{error}\n");
                };
                for (f, filter) in FILTERS.into_iter().enumerate() {
                    let name = filter.name();
                    line("W", &name, found.w[f].mean, Some(found.w[f].error));
                    line("G", &name, found.g[f], None);
                    line("filtered", &name, found.filtered[f], None);
                }
                line("rms", "", found.rms, None);
                line("rms over white", "", found.rms_over_white.mean, Some(found.rms_over_white.error));
            }
            let [mean, worst] = spikes(&entry.measured.spikes);
            let start = format!("{},{},half-planes", entry.name, entry.measured.count);
            text += &format!("{start},spike mean,,{mean},\n{start},spike worst,,{worst},\n");
        }
        text
    }

    /// W of a family after a filter.
    pub fn w(&self, k: usize, filter: Filter, family: &str) -> Table {
        let place = filter.place();
        let filter = match filter {
            Filter::Box(_) => filter.name(),
            Filter::Gauss(_) => format!("sigma {}", filter.name()),
        };
        self.table(
            &format!("w-{}-{family}", filter.replace(' ', "-")),
            &format!("W, {filter}, {family}"),
            "Filtered error over that of white noise at the same number of samples, with standard errors in thousandths.",
            |entry| with_error(entry.figures[k].w[place]),
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
