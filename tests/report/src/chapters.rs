//! What is measured, in the order of the page.

use crate::arguments::{Arguments, Part};
use crate::bench::Bench;
use crate::error_part::{self, Errors};
use crate::field::Drawn;
use crate::page::{self, Chapter};
use crate::samplers;
use crate::speed::{self, Speeds};
use crate::table::Table;
use crate::{
    builds, charts, classic, dither_part, edges, instructions, masks_part, scene_part, set_up, several, shader_cost,
    singles, time_part, tracer_part,
};

/// The page's chapters, and files of numbers beside their tables.
#[derive(Debug)]
pub struct Report {
    pub chapters: Vec<Chapter>,
    pub csv: Vec<(&'static str, String)>,
    /// For the README.
    pub errors: Option<Errors>,
    pub speeds: Option<Speeds>,
}

/// Runs every part that was asked for.
pub fn measure(arguments: &Arguments) -> Result<Report, String> {
    let names = arguments.samplers();
    let bench = Bench::new();
    let mut report = Report { chapters: Vec::new(), csv: Vec::new(), errors: None, speeds: None };
    let seed = arguments.seed;
    let error = |all: &[Drawn]| error_part::measure(&bench, &names, all, arguments.seeds());
    let all_of = |count| Drawn::all_of(seed, count);
    // Chapters that need less certainty.
    let few = [seed, arguments.seeds().div_ceil(4)];

    let speeds = arguments.has(Part::Speed).then(|| speed::measure(&names, arguments.rounds()));
    if arguments.has(Part::Error) {
        let errors = error(&arguments.counts().iter().copied().map(all_of).collect::<Vec<_>>());
        report.csv.push(("error.csv", errors.csv()));
        report.chapters.extend(error_chapters(&errors, speeds.as_ref()));
        report.errors = Some(errors);
    }
    if arguments.has(Part::Several) {
        let (chapter, csv) = several::chapter(arguments)?;
        report.csv.push(("several.csv", csv));
        report.chapters.push(chapter);
    }
    if arguments.has(Part::Scene) {
        // Second, after the main picture: it is what people look at.
        let place = report.chapters.len().min(1);
        report.chapters.insert(place, scene_part::chapter(&names, seed, arguments.quick));
    }
    let mut add = |title: &str, text: &str, tables: Vec<Table>| {
        report.chapters.push(Chapter { title: title.into(), text: text.into(), figures: Vec::new(), tables });
    };
    if arguments.has(Part::Prefixes) {
        let taken: &[u32] = if arguments.quick { &[1, 4] } else { &[1, 2, 4, 8, 12] };
        let taken: Vec<Drawn> = taken.iter().map(|&count| Drawn { count, ..all_of(16) }).collect();
        let tables = error(&taken).brief("prefix", "W, sigma 1, the first of 16 samples");
        add("Prefixes", "Fewer samples taken than the sampler was told.", tables);
    }
    if arguments.has(Part::Odd) {
        let counts = &[3, 12, 48].map(all_of)[..if arguments.quick { 2 } else { 3 }];
        add("Not powers of two", "The sampler is told the count.", error(counts).brief("odd", "W, sigma 1"));
    }
    if arguments.has(Part::Singles) {
        let table = singles::table(&bench, &names, few, arguments.quick);
        add("One dimension", "Time, wavelength, a lobe: what is drawn as a number by itself.", vec![table]);
    }
    if arguments.has(Part::Frames) {
        add(
            "Animation",
            "One sample a pixel and frame, over white noise, which starts anew in every frame. The mean of so many frames; \
             and the moving average that temporal filters keep, which takes a fifth of every new frame.",
            animation(all_of(1), arguments.quick, error),
        );
        add(
            "Ways through time",
            "What can be done with a mask, with best candidates and with seeds from frame to frame.",
            time_part::tables(seed, arguments.quick),
        );
    }
    if arguments.has(Part::Classic) {
        add("Classic integrands", "Of the literature, one by one.", classic::tables(&bench, &names, few));
    }
    if arguments.has(Part::Tracer) {
        let text = "A box, two spheres, a lamp. The numbers of a vertex are one domain, those of camera and first vertex together.";
        add("A path tracer", text, tracer_part::tables(arguments));
    }
    if arguments.has(Part::Edges) {
        let text = "Dithering lives on neighbours that integrate nearly the same: how much of that is needed?";
        add("Moving edges", text, vec![edges::table(&bench, &names, few)]);
    }
    if arguments.has(Part::Size) {
        add("Size", "", vec![size(&names)]);
    }
    if arguments.has(Part::Instructions) {
        let (text, tables) = tables_or_line(instructions::tables(&names, &arguments.out));
        add("Instructions", &text, tables);
    }
    if arguments.has(Part::Shaders) && !arguments.quick {
        let (text, tables) = tables_or_line(shader_cost::table().map(|table| vec![table]));
        add("Shaders", &text, tables);
    }
    if arguments.has(Part::Builds) && !arguments.quick {
        let (text, tables) = tables_or_line(builds::table(&arguments.out).map(|table| vec![table]));
        add("Builds", &text, tables);
    }
    if let Some(speeds) = &speeds {
        let mut tables = speeds.tables();
        tables.push(set_up::table(&names, arguments.rounds()));
        add("Speed", "Compare columns of one run: clocks wander, ratios stay.", tables);
    }
    report.speeds = speeds;
    if arguments.has(Part::Masks) {
        report.chapters.push(masks_part::chapter());
    }
    if arguments.has(Part::Dither) {
        report.chapters.push(dither_part::chapter(arguments.quick));
    }
    Ok(report)
}

/// What was measured, or a line that says why nothing was.
fn tables_or_line(found: Result<Vec<Table>, String>) -> (String, Vec<Table>) {
    match found {
        Ok(tables) => (String::new(), tables),
        Err(line) => (page::escape(&line), Vec::new()),
    }
}

/// W at sigma 1 of means of frames, and of a moving average in a last column.
fn animation(one: Drawn, quick: bool, error: impl Fn(&[Drawn]) -> Errors) -> Vec<Table> {
    let frames: &[u32] = if quick { &[1, 4] } else { &[1, 2, 4, 16] };
    let means: Vec<Drawn> = frames.iter().map(|&frames| Drawn { frames, ..one }).collect();
    let mut tables = error(&means).brief("frames", "W, sigma 1, frames");
    let moving = error(&[Drawn { frames: 16, keep: 0.8, ..one }]).brief("moving", "");
    for (table, moving) in tables.iter_mut().zip(moving) {
        table.head[0] = "mean of frames".into();
        table.head.push("moving, 16".into());
        table.rows.iter_mut().zip(moving.rows).for_each(|(row, moving)| row.extend(moving.into_iter().nth(1)));
    }
    tables
}

fn error_chapters(errors: &Errors, speeds: Option<&Speeds>) -> Vec<Chapter> {
    let mut figures = speeds.map(|speeds| charts::error_against_time(errors, speeds)).unwrap_or_default();
    figures.extend(charts::error_against_samples(errors));
    let error = Chapter {
        title: "Error".into(),
        text:
            "W: what a viewer sees of the error, over white noise at the same number of samples. Filtered: a Gaussian \
               of that standard deviation in pixels. Integrands are the same in all pixels, and no optimiser has seen \
               them. In the first pictures lower left is better: thick lines are this crate's, thin ones what others \
               use. Point at a line, or tap it, to see it alone."
                .into(),
        figures,
        tables: errors.tables(),
    };
    let filters = Chapter {
        title: "Other filters".into(),
        text: "Gaussians of .7 and 4 pixels; boxes of 3 and 5 pixels on a side.".into(),
        tables: errors.filter_tables(),
        ..Chapter::default()
    };
    let spectra = Chapter {
        title: "Spectra".into(),
        text: "Power of the error image, averaged over directions, cut off at 3. Low is what shows.".into(),
        figures: [1, 4, 16]
            .into_iter()
            .filter(|c| errors.counts.contains(c))
            .flat_map(|c| charts::spectra(errors, c))
            .collect(),
        ..Chapter::default()
    };
    vec![error, filters, spectra]
}

/// What each sampler links.
fn size(names: &[&'static str]) -> Table {
    Table {
        id: "size".into(),
        title: "Bytes of tables".into(),
        about: "Linked with the sampler, without code; the peers' as packed as they can be.".into(),
        head: ["sampler", "bytes"].map(String::from).to_vec(),
        rows: names.iter().map(|name| vec![(*name).to_string(), samplers::bytes(name).to_string()]).collect(),
    }
}
