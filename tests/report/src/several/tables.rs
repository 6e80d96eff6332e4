//! Results as tables, pictures and numbers.

use super::family::FAMILIES;
use super::numbers::Form;
use super::results::{Cell, Results, SIGMAS};
use crate::figures::Value;
use crate::table::Table;

/// A table a family and form: W, unfiltered and after each filter.
pub fn error(results: &Results, with_errors: bool) -> Vec<Table> {
    let of = |(form, place): (Form, usize)| {
        let name = FAMILIES[place].name;
        let cell = |cell: &Cell| {
            let [plain, filtered @ ..] = &cell.w[place];
            let filtered: Vec<String> = filtered.iter().map(|value| number(*value, with_errors)).collect();
            format!("{}: {}", number(*plain, with_errors), filtered.join(" "))
        };
        let about = if FAMILIES[place].plain { "" } else { " For information: no picture is made of this." };
        Table {
            id: format!("several-{}-{}", slug(form.name()), slug(name)),
            title: format!("W, {name}, {}", form.name()),
            about: format!("Over padded white noise: unfiltered, then after sigma 1, 2.1, 4, 8.{about}"),
            ..rows(results, form, cell)
        }
    };
    Form::BOTH.into_iter().flat_map(|form| (0..FAMILIES.len()).map(move |place| (form, place))).map(of).collect()
}

/// A table a form: median and worst local spike over the families that are plain.
pub fn spikes(results: &Results) -> Vec<Table> {
    let of = |form: Form| {
        let cell = |cell: &Cell| {
            let plain = || cell.spikes.iter().zip(FAMILIES).filter(|(_, family)| family.plain);
            let [median, worst] = [0, 1].map(|k| plain().map(|(spike, _)| spike[k]).fold(0.0, f32::max));
            format!("{median:.0} {worst:.0}")
        };
        Table {
            id: format!("several-spikes-{}", slug(form.name())),
            title: format!("Local spike, {}", form.name()),
            about: "Strongest frequency over the mean in windows of 32×32 pixels of an error image: the median of the \
                    family that is worst in that, and the worst window of all plain families. White noise: 7, and 13 to 24 by how rare its errors are."
                .into(),
            ..rows(results, form, cell)
        }
    };
    let mut all = Form::BOTH.map(of).to_vec();
    all.push(spikes_of_families(results));
    all
}

/// The same of each family, numbers from one domain.
fn spikes_of_families(results: &Results) -> Table {
    let row = |(name, place): (&str, usize)| {
        let cell = |cell: &Cell| cell.spikes[place].map(|spike| format!("{spike:.0}")).join(" ");
        let cells = results.row(name, Form::One).iter().map(cell);
        core::iter::once(format!("{name}: {}", FAMILIES[place].name)).chain(cells).collect()
    };
    let places = results.names.iter().flat_map(|name| (0..FAMILIES.len()).map(move |place| (*name, place)));
    Table {
        id: "several-spikes-families".into(),
        title: "Local spike, by families".into(),
        about: "Median and worst window over seeds and integrands, numbers from one domain.".into(),
        rows: places.map(row).collect(),
        ..rows(results, Form::One, |_| String::new())
    }
}

/// One row a sampler, one column a number of samples.
fn rows(results: &Results, form: Form, cell: impl Fn(&Cell) -> String) -> Table {
    let row = |name: &&'static str| {
        let cells = results.row(name, form).iter().map(&cell);
        core::iter::once((*name).to_string()).chain(cells).collect()
    };
    let counts = results.counts.iter().map(u32::to_string);
    let head = core::iter::once("samples".to_string()).chain(counts).collect();
    let rows = results.names.iter().map(row).collect();
    Table { id: String::new(), title: String::new(), about: String::new(), head, rows }
}

/// Every cell of a plain family that is above white noise by more than two standard errors, the worst first; then how
/// many there are of all, and how many of xor and checkers.
pub fn harm(results: &Results) -> Vec<Table> {
    struct Harm {
        excess: f64,
        row: Vec<String>,
    }
    let mut harms = Vec::new();
    let mut totals = Vec::new();
    for name in &results.names {
        let (mut all, mut found) = ([0, 0], [0, 0]);
        let cells = || Form::BOTH.into_iter().flat_map(|form| results.row(name, form));
        for cell in cells() {
            for (family, w) in FAMILIES.iter().zip(&cell.w) {
                for (sigma, w) in SIGMAS.iter().zip(w) {
                    let kind = usize::from(!family.plain);
                    all[kind] += 1;
                    let excess = w.mean - 2.0 * w.error - 1.0;
                    if excess <= 0.0 {
                        continue;
                    }
                    found[kind] += 1;
                    if family.plain {
                        let place = [family.name.into(), cell.count.to_string(), sigma.to_string()];
                        let w = format!("{:.3} ±{:.0}", w.mean, (w.error * 1000.0).ceil());
                        let row =
                            [vec![(*name).to_string(), cell.form.name().into()], place.to_vec(), vec![w]].concat();
                        harms.push(Harm { excess, row });
                    }
                }
            }
        }
        let share = |kind: usize| format!("{} of {}", found[kind], all[kind]);
        totals.push(vec![(*name).to_string(), share(0), share(1)]);
    }
    harms.sort_by(|a, b| b.excess.total_cmp(&a.excess));
    let head = |names: &[&str]| names.iter().map(|name| (*name).to_string()).collect();
    let list = Table {
        id: "several-harm".into(),
        title: "Harm".into(),
        about: "Cells of plain families above white noise by more than two standard errors, the largest excess first."
            .into(),
        head: head(&["sampler", "numbers from", "family", "samples", "sigma", "W"]),
        rows: harms.into_iter().map(|harm| harm.row).collect(),
    };
    let count = Table {
        id: "several-harm-count".into(),
        title: "Cells above white noise".into(),
        about: "By more than two standard errors. Chance alone puts one in forty there: see white's own row.".into(),
        head: head(&["sampler", "plain families", "xor and checkers"]),
        rows: totals,
    };
    vec![count, list]
}

/// Every figure at full length, a row each.
pub fn csv(results: &Results) -> String {
    let mut text = String::from("sampler,numbers from,samples,family,figure,sigma,value,standard_error\n");
    for cell in &results.cells {
        for ((family, w), [median, worst]) in FAMILIES.iter().zip(&cell.w).zip(&cell.spikes) {
            let start = format!("{},{},{},\"{}\"", cell.name, cell.form.name(), cell.count, family.name);
            for (sigma, w) in SIGMAS.iter().zip(w) {
                text += &format!("{start},W,{sigma},{},{}\n", w.mean, w.error);
            }
            text += &format!("{start},spike median,,{median},\n{start},spike worst,,{worst},\n");
        }
    }
    text
}

/// Two digits, no zero before the point; with its standard error in thousandths.
pub fn number(value: Value, with_error: bool) -> String {
    let text = format!("{:.2}", value.mean);
    let text = text.strip_prefix('0').unwrap_or(&text);
    if with_error { format!("{text}±{:.0}", (value.error * 1000.0).ceil()) } else { text.to_string() }
}

/// A name as part of a file's.
pub fn slug(name: &str) -> String {
    name.replace(", ", "-").replace(' ', "-")
}
