//! What is measured, in the order of the page.

use crate::arguments::{Arguments, Part};
use crate::bench::Bench;
use crate::error_part::{self, Errors};
use crate::field::Drawn;
use crate::page::Chapter;
use crate::samplers;
use crate::speed::{self, Speeds};
use crate::table::Table;
use crate::{charts, classic, domains, edges, masks_part, scene_part};

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
pub fn measure(arguments: &Arguments) -> Report {
    let names = arguments.samplers();
    let bench = Bench::new();
    let mut report = Report { chapters: Vec::new(), csv: Vec::new(), errors: None, speeds: None };
    let seed = arguments.seed;
    let error = |all: &[Drawn]| error_part::measure(&bench, &names, all, arguments.seeds());
    let all_of = |count| Drawn { seed, spp: count, count, frames: 1 };

    let speeds = arguments.has(Part::Speed).then(|| speed::measure(&names, arguments.rounds()));
    if arguments.has(Part::Error) {
        let errors = error(&arguments.counts().iter().copied().map(all_of).collect::<Vec<_>>());
        report.csv.push(("error.csv", errors.csv()));
        report.chapters.extend(error_chapters(&errors, speeds.as_ref()));
        report.errors = Some(errors);
    }
    if arguments.has(Part::Prefixes) {
        let taken: &[u32] = if arguments.quick { &[1, 4] } else { &[1, 2, 4, 8, 12] };
        let taken: Vec<Drawn> = taken.iter().map(|&count| Drawn { count, ..all_of(16) }).collect();
        report.chapters.push(Chapter {
            title: "Prefixes".into(),
            text: "Fewer samples taken than the sampler was told.".into(),
            tables: error(&taken).brief("prefix", "W, sigma 1, the first of 16 samples"),
            ..Chapter::default()
        });
    }
    if arguments.has(Part::Odd) {
        report.chapters.push(Chapter {
            title: "Not powers of two".into(),
            text: "The sampler is told the count.".into(),
            tables: error(&[3, 12, 48].map(all_of)[..if arguments.quick { 2 } else { 3 }]).brief("odd", "W, sigma 1"),
            ..Chapter::default()
        });
    }
    if arguments.has(Part::Frames) {
        let frames: &[u32] = if arguments.quick { &[1, 4] } else { &[1, 2, 4, 16] };
        let frames: Vec<Drawn> = frames.iter().map(|&frames| Drawn { frames, ..all_of(1) }).collect();
        report.chapters.push(Chapter {
            title: "Animation".into(),
            text: "One sample a pixel and frame, the mean of so many frames, over that of white noise, which starts anew in \
                   every frame."
                .into(),
            tables: error(&frames).brief("frames", "W, sigma 1, mean of frames"),
            ..Chapter::default()
        });
    }
    if arguments.has(Part::Classic) {
        report.chapters.push(Chapter {
            title: "Classic integrands".into(),
            text: "Of the literature, one by one.".into(),
            tables: classic::tables(&bench, &names, seed, arguments.seeds().div_ceil(4)),
            ..Chapter::default()
        });
    }
    if arguments.has(Part::Domains) {
        report.chapters.push(Chapter {
            title: "Many dimensions".into(),
            text: "One integrand takes the numbers of several pairs and domains. 1: they decorrelate.".into(),
            tables: domains::tables(&names, seed, arguments.seeds().div_ceil(4)),
            ..Chapter::default()
        });
    }
    if arguments.has(Part::Edges) {
        report.chapters.push(Chapter {
            title: "Moving edges".into(),
            text: "Dithering lives on neighbours that integrate nearly the same: how much of that is needed?".into(),
            tables: vec![edges::table(&bench, &names, seed, arguments.seeds().div_ceil(4))],
            ..Chapter::default()
        });
    }
    if arguments.has(Part::Scene) {
        report.chapters.push(scene_part::chapter(&names, seed, arguments.quick));
    }
    if arguments.has(Part::Masks) {
        report.chapters.push(masks_part::chapter());
    }
    if arguments.has(Part::Size) {
        report.chapters.push(Chapter { title: "Size".into(), tables: vec![size(&names)], ..Chapter::default() });
    }
    if let Some(speeds) = speeds {
        report.chapters.push(Chapter {
            title: "Speed".into(),
            text: "Compare columns of one run: clocks wander, ratios stay.".into(),
            tables: speeds.tables(),
            ..Chapter::default()
        });
        report.speeds = Some(speeds);
    }
    report
}

fn error_chapters(errors: &Errors, speeds: Option<&Speeds>) -> Vec<Chapter> {
    let mut figures = speeds.map(|speeds| charts::error_against_time(errors, speeds)).unwrap_or_default();
    figures.extend(charts::error_against_samples(errors));
    let error = Chapter {
        title: "Error".into(),
        text:
            "W: what a viewer sees of the error, over white noise at the same number of samples. Filtered: a Gaussian \
               of that standard deviation in pixels. Integrands are the same in all pixels, and no optimiser has seen \
               them. In the first pictures lower left is better."
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
    let bytes = samplers::NAMES.iter().zip(samplers::BYTES).filter(|(name, _)| names.contains(name));
    Table {
        id: "size".into(),
        title: "Bytes of tables".into(),
        about: "Linked with the sampler, without code; the peers' as packed as they can be.".into(),
        head: ["sampler", "bytes"].map(String::from).to_vec(),
        rows: bytes.map(|(name, bytes)| vec![(*name).to_string(), bytes.to_string()]).collect(),
    }
}
