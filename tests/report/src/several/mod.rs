//! Several dimensions at once: what a picture asks for that takes its lens, light and material from one sample.
//!
//! All samplers are held against one baseline, white noise of padded pairs, so that what a joint sampler gains and what
//! a padded one loses both show. Texture is looked for in small windows of single error images, where no average hides
//! it; every cell that is worse than white noise is listed.

#[cfg(test)]
mod checks;
mod criteria;
mod family;
mod goals;
mod half_space;
mod integrands;
mod light;
mod measure;
mod numbers;
mod pictures;
mod render;
mod results;
mod ridges;
mod smooth;
mod spike;
mod tables;

use crate::arguments::Arguments;
use crate::page::{Chapter, escape};
pub use results::BASELINE;
use results::Results;
pub use tables::number;

/// Samples per pixel, if no others are asked for.
const COUNTS: [u32; 7] = [1, 2, 4, 8, 16, 32, 64];
const QUICK: [u32; 3] = [1, 4, 16];
const SEEDS: u32 = 8;

/// What the chapter gives: itself, and its numbers as CSV.
pub fn chapter(arguments: &Arguments) -> Result<(Chapter, String), String> {
    let (counts, seeds) = if arguments.quick { (&QUICK[..], 3) } else { (&COUNTS[..], SEEDS) };
    let counts = arguments.spp().unwrap_or_else(|| counts.to_vec());
    let seeds = arguments.chosen_seeds().unwrap_or(seeds);
    let (names, seeds_from) = (arguments.samplers_and_twins(), [arguments.seed, seeds]);
    let results = Results::measure(&names, &counts, seeds_from);
    pictures::save(&results, &arguments.out.join("several"))?;
    let rendered = render::measure(&names, &counts, seeds_from, if arguments.quick { 128 } else { 1024 });
    let mut tables =
        vec![goals::table(&results, &rendered), render::table(&rendered, &names, &counts, arguments.errors)];
    tables.extend([criteria::one_sample(&results), criteria::table(&results)]);
    tables.extend(tables::error(&results, arguments.errors));
    tables.extend(tables::spikes(&results));
    tables.extend(tables::harm(&results));
    let chapter = Chapter {
        title: "Several dimensions at once".into(),
        text: format!(
            "Eight numbers a sample, from one domain or a domain a pair; {seeds} seeds. Error images at four times their size: {}.",
            escape(&pictures::legend())
        ),
        figures: Vec::new(),
        tables,
    };
    Ok((chapter, tables::csv(&results)))
}
