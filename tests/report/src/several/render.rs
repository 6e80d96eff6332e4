//! The render example as one more family: lens, light and time are five numbers of one domain.

use super::results::BASELINE;
use crate::figures::{Value, mean, root_of_ratio};
use crate::film::Image;
use crate::measure::{self, gaussian, rms};
use crate::progress::Progress;
use crate::reference::Reference;
use crate::samplers::{self, WHITE};
use crate::scene::Scene;
use crate::scene_part::{ALL_DIMENSIONS, Render};
use crate::table::Table;

const SIZE: [u32; 2] = crate::scene_part::SIZE;
/// Places of `measure::SIGMAS` in W.
pub const SIGMAS: [usize; 2] = [1, 2];

/// A sampler at one number of samples: W unfiltered, and after each Gaussian of `measure::SIGMAS`.
#[derive(Debug)]
pub struct Rendered {
    pub name: &'static str,
    pub count: u32,
    pub w: [Value; 3],
}

/// Mean squares of an error picture: as it is, and filtered.
fn squares(error: &Image) -> [f64; 3] {
    let [fine, coarse] = measure::SIGMAS.map(|sigma| rms(&gaussian(error, sigma)));
    [rms(error), fine, coarse].map(|root| f64::from(root).powi(2))
}

/// Every sampler's pictures, against a reference of which its own error is taken off.
pub fn measure(names: &[&'static str], counts: &[u32], [seed, seeds]: [u32; 2], reference_spp: u32) -> Vec<Rendered> {
    let scene = Scene::new(SIZE[0], SIZE[1]);
    let reference = Reference::render(&scene, SIZE, ALL_DIMENSIONS, reference_spp, seed);
    let [fine, coarse] = reference.filtered;
    let noise = [reference.error, fine, coarse].map(|error| f64::from(error).powi(2));
    let progress = Progress::new("rendering the scene", counts.iter().sum::<u32>() as usize * (1 + names.len()));
    let of = |name: &str, spp: u32, first: u32, seeds: u32| -> [Value; 3] {
        let one = |k: u32| {
            let render = Render { scene: &scene, dimensions: ALL_DIMENSIONS, spp, seed: first.wrapping_add(k) };
            let found = squares(&samplers::with(name, &render).minus(&reference.image));
            core::array::from_fn::<f64, 3, _>(|k| found[k] - noise[k])
        };
        let all: Vec<[f64; 3]> = (0..seeds).map(one).collect();
        progress.add(spp as usize);
        core::array::from_fn(|k| mean(&all.iter().map(|one| one[k]).collect::<Vec<f64>>()))
    };
    let mut all = Vec::new();
    for &count in counts {
        let white = of(WHITE, count, seed.wrapping_add(BASELINE), 2 * seeds);
        for name in names {
            let found = of(name, count, seed, seeds);
            all.push(Rendered { name, count, w: core::array::from_fn(|k| root_of_ratio(found[k], white[k])) });
        }
    }
    all
}

/// One row a sampler.
pub fn table(rendered: &[Rendered], names: &[&'static str], counts: &[u32], with_errors: bool) -> Table {
    let row = |name: &&'static str| {
        let cell = |found: &Rendered| {
            let [plain, fine, coarse] = found.w.map(|value| super::tables::number(value, with_errors));
            format!("{plain}: {fine} {coarse}")
        };
        let cells = rendered.iter().filter(|one| one.name == *name).map(cell);
        core::iter::once((*name).to_string()).chain(cells).collect()
    };
    Table {
        id: "several-render".into(),
        title: "W, the render example".into(),
        about: "Lens, light and time from one domain; over padded white noise: unfiltered, after sigma 1 and 2.1."
            .into(),
        head: core::iter::once("samples".to_string()).chain(counts.iter().map(u32::to_string)).collect(),
        rows: names.iter().map(row).collect(),
    }
}
