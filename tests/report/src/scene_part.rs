//! The render example's scene: its error by what is sampled, before and after a denoiser, and pictures.

use crate::denoise::denoise;
use crate::error_part::short;
use crate::film::Image;
use crate::measure::{SIGMAS, gaussian, rms};
use crate::page::{Chapter, escape};
use crate::progress::Progress;
use crate::reference::Reference;
use crate::samplers::{self, WHITE};
use crate::scene::{Dimensions, Sample, Scene};
use crate::shape::{Pixel, Sampler, Task};
use crate::table::Table;
use base64::prelude::*;
use glam::Vec3A;
use image::imageops;
use std::hint::black_box;
use std::time::Instant;

pub const SIZE: [u32; 2] = [192, 128];
const COUNTS: [u32; 3] = [1, 4, 16];
/// Samples of the pictures on the page, and the part of the scene that they show.
const SHOWN: u32 = 4;
const CROP: [u32; 4] = [60, 40, 96, 64];
/// Samples of white noise whose time the pictures at equal time have: enough for a difference to make one.
const BUDGET: u32 = 16;

/// Samples that are drawn at once.
const RUN: usize = 16;

/// What the numbers are for: lens, light and time, which one sample takes together.
const CAMERA: u32 = 0;
pub const ALL_DIMENSIONS: Dimensions = Dimensions { time: true, lens: true, light: true };

/// A picture of the scene.
pub struct Render<'a> {
    pub scene: &'a Scene,
    pub dimensions: Dimensions,
    pub spp: u32,
    pub seed: u32,
}

impl Task for Render<'_> {
    type Output = Image;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Image {
        let made = make(self.seed, self.spp);
        Image::render(SIZE, |x, y| {
            let pixel = made.pixel(x, y, 0);
            let mut samples = [[0.0; 5]; RUN];
            let mut sum = Vec3A::ZERO;
            for first in (0..self.spp).step_by(RUN) {
                let samples = &mut samples[..RUN.min((self.spp - first) as usize)];
                pixel.fill(CAMERA, first, samples);
                for &mut [u, v, a, b, time] in samples {
                    let sample = Sample { time, lens: [u, v], light: [a, b] };
                    sum += self.scene.radiance(x, y, sample.only(self.dimensions));
                }
            }
            sum / self.spp as f32
        })
    }
}

/// What is measured of an error image: as it is, after each Gaussian, after the denoiser.
fn sizes(error: &Image, guide: &Image) -> [f32; 4] {
    let [a, b] = SIGMAS.map(|sigma| rms(&gaussian(error, sigma)));
    [rms(error), a, b, rms(&denoise(error, guide))]
}

const SETS: [(&str, [bool; 3]); 4] = [
    ("time", [true, false, false]),
    ("lens", [false, true, false]),
    ("light", [false, false, true]),
    ("time, lens and light", [true; 3]),
];

/// The chapter: a table a kind of filter, a row a sampler; the pictures.
pub fn chapter(names: &[&'static str], seed: u32, quick: bool) -> Chapter {
    let (sets, counts, seeds, reference_spp) =
        if quick { (&SETS[3..], &COUNTS[..2], 1, 128) } else { (&SETS[..], &COUNTS[..], 4, 1024) };
    let scene = Scene::new(SIZE[0], SIZE[1]);
    let none = Dimensions { time: false, lens: false, light: false };
    let centre = Sample { time: 0.5, lens: [0.5; 2], light: [0.5; 2] };
    let guide = Image::render(SIZE, |x, y| scene.radiance(x, y, centre.only(none)));
    // Of each set and count: a sampler's sizes over those of white noise.
    let mut columns: Vec<(String, Vec<[f32; 4]>)> = Vec::new();
    let mut figures = Vec::new();
    for &(label, [time, lens, light]) in sets {
        let dimensions = Dimensions { time, lens, light };
        let reference = Reference::render(&scene, SIZE, dimensions, reference_spp, seed).image;
        let progress = Progress::new("rendering the scene", counts.len() * names.len());
        let render = |name: &str, spp: u32, k: u32| {
            samplers::with(name, &Render { scene: &scene, dimensions, spp, seed: seed.wrapping_add(k) })
        };
        for &spp in counts {
            // Mean squares over the seeds.
            let measure = |name: &str| {
                let runs = (0..seeds).map(|k| sizes(&render(name, spp, k).minus(&reference), &guide));
                runs.fold([0.0; 4], |sum: [f32; 4], run| core::array::from_fn(|k| sum[k] + run[k] * run[k]))
            };
            let white = measure(WHITE);
            let mut column = Vec::new();
            for name in names {
                let found = measure(name);
                column.push(core::array::from_fn(|k| (found[k] / white[k]).sqrt()));
                progress.add(1);
            }
            columns.push((format!("{label}, {spp}"), column));
        }
        if time && lens && light {
            let equal = names.iter().map(|name| (*name, SHOWN)).collect::<Vec<_>>();
            let timed = at_equal_time(names, &|name, k| render(name, SHOWN, k), if quick { 3 } else { 9 });
            for (title, all) in [
                (format!("At {SHOWN} samples per pixel"), equal),
                (format!("In the time of {BUDGET} samples of {WHITE}"), timed),
            ] {
                figures.push(format!("<h3>{title}</h3>"));
                let shown = all.iter().map(|(name, spp)| (*name, *spp, render(name, *spp, 0)));
                let shown: Vec<_> = shown
                    .map(|(name, spp, image)| (name, spp, rms(&gaussian(&image.minus(&reference), 1.0)), image))
                    .collect();
                let unit = shown.iter().find(|one| one.0 == WHITE).map_or(1.0, |one| one.2);
                figures.push(picture("reference", &reference));
                figures.extend(shown.iter().map(|(name, spp, error, image)| {
                    picture(&format!("{name}, {spp} spp: {}", short((error / unit).into())), image)
                }));
            }
        }
    }
    let table = |(k, (id, title)): (usize, (&str, &str))| Table {
        id: format!("scene-{id}"),
        title: format!("Scene, {title}"),
        about: "Root-mean-square error over that of white noise, by what is sampled and samples per pixel.".into(),
        head: core::iter::once("sampler".to_string()).chain(columns.iter().map(|(label, _)| label.clone())).collect(),
        rows: (0..names.len())
            .map(|row| {
                let cells = columns.iter().map(|(_, column)| short(column[row][k].into()));
                core::iter::once(names[row].to_string()).chain(cells).collect()
            })
            .collect(),
    };
    let kinds = [
        ("sigma-1", "after a Gaussian of 1 pixel"),
        ("sigma-2.1", "after a Gaussian of 2.1 pixels"),
        ("denoised", "after an edge-aware denoiser (à trous, 3 levels)"),
        ("plain", "before any filter"),
    ];
    Chapter {
        title: "A scene".into(),
        text: format!(
            "The render example's moving sphere, lens and rectangular light, {}×{} pixels, seeds: {seeds}. Figures vary by some \
             percent. Under each picture its error after a Gaussian of 1 pixel, over that of {WHITE}.",
            SIZE[0], SIZE[1]
        ),
        figures,
        tables: [1, 2, 3, 0].into_iter().zip(kinds).map(table).collect(),
    }
}

/// How many samples each sampler can take in the time of `BUDGET` ones of white noise, rendering included: by the
/// fastest of some rounds in which all take turns.
fn at_equal_time<'a>(names: &[&'a str], render: &dyn Fn(&str, u32) -> Image, rounds: u32) -> Vec<(&'a str, u32)> {
    let mut best = vec![f64::INFINITY; names.len()];
    for round in 0..rounds {
        for (name, best) in names.iter().zip(&mut best) {
            let start = Instant::now();
            black_box(render(name, round));
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    let white = names.iter().zip(&best).find(|(name, _)| **name == WHITE).map_or(1.0, |(_, time)| *time);
    let count = |time: f64| ((white / time * f64::from(BUDGET)).round() as u32).max(1);
    names.iter().zip(best).map(|(name, time)| (*name, count(time))).collect()
}

/// A part of a picture as an inline PNG, enlarged by the page.
fn picture(name: &str, image: &Image) -> String {
    let [x, y, width, height] = CROP;
    let crop = imageops::crop_imm(&image.develop(), x, y, width, height).to_image();
    let mut png = std::io::Cursor::new(Vec::new());
    crop.write_to(&mut png, image::ImageFormat::Png).expect("memory takes any image");
    let data = BASE64_STANDARD.encode(png.get_ref());
    format!(
        "<figure class=p><img alt=\"\" width={} height={} src=\"data:image/png;base64,{data}\"><figcaption>{}</figcaption></figure>",
        3 * width,
        3 * height,
        escape(name)
    )
}
