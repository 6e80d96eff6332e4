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
use crate::shape::{Sampler, Task};
use crate::table::Table;
use glam::Vec3A;
use image::imageops;

const SIZE: [u32; 2] = [192, 128];
const COUNTS: [u32; 3] = [1, 4, 16];
/// Samples of the pictures on the page, and the part of the scene that they show.
const SHOWN: u32 = 4;
const CROP: [u32; 4] = [60, 40, 96, 64];

/// What the numbers are for.
const TIME: u32 = 0;
const LENS: u32 = 1;
const LIGHT: u32 = 2;

struct Render<'a> {
    scene: &'a Scene,
    dimensions: Dimensions,
    spp: u32,
    seed: u32,
}

impl Task for Render<'_> {
    type Output = Image;

    fn run(&self, sampler: &impl Sampler) -> Image {
        let made = sampler.make(self.seed, self.spp);
        Image::render(SIZE, |x, y| {
            let pixel = sampler.pixel(&made, x, y, 0);
            let mut sum = Vec3A::ZERO;
            for index in 0..self.spp {
                let [time] = sampler.draw_1(pixel, TIME, index);
                let (lens, light) = (sampler.draw_2(pixel, LENS, index), sampler.draw_2(pixel, LIGHT, index));
                sum += self.scene.radiance(x, y, Sample { time, lens, light }.only(self.dimensions));
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
        let reference = Reference::render(&scene, SIZE, dimensions, reference_spp, seed);
        let progress = Progress::new("rendering the scene", counts.len() * names.len());
        for &spp in counts {
            let render = |name: &str, k: u32| {
                samplers::with(name, &Render { scene: &scene, dimensions, spp, seed: seed.wrapping_add(k) })
            };
            // Mean squares over the seeds.
            let measure = |name: &str| {
                let runs = (0..seeds).map(|k| sizes(&render(name, k).minus(&reference.image), &guide));
                runs.fold([0.0; 4], |sum: [f32; 4], run| core::array::from_fn(|k| sum[k] + run[k] * run[k]))
            };
            let white = measure(WHITE);
            let mut column = Vec::new();
            for name in names {
                let found = measure(name);
                column.push(core::array::from_fn(|k| (found[k] / white[k]).sqrt()));
                if spp == SHOWN && time && lens && light {
                    figures.push(picture(name, &render(name, 0)));
                }
                progress.add(1);
            }
            columns.push((format!("{label}, {spp}"), column));
        }
        if time && lens && light {
            figures.push(picture("reference", &reference.image));
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
            "The render example's moving sphere, lens and rectangular light, {}×{} pixels, {seeds} seeds: figures vary by some \
             percent. Pictures at {SHOWN} samples per pixel:",
            SIZE[0], SIZE[1]
        ),
        figures,
        tables: [1, 2, 3, 0].into_iter().zip(kinds).map(table).collect(),
    }
}

/// A part of a picture as an inline PNG, enlarged by the page.
fn picture(name: &str, image: &Image) -> String {
    let [x, y, width, height] = CROP;
    let crop = imageops::crop_imm(&image.develop(), x, y, width, height).to_image();
    let mut png = std::io::Cursor::new(Vec::new());
    crop.write_to(&mut png, image::ImageFormat::Png).expect("memory takes any image");
    let data = base_64(png.get_ref());
    format!(
        "<figure class=p><img alt=\"\" width={} height={} src=\"data:image/png;base64,{data}\"><figcaption>{}</figcaption></figure>",
        3 * width,
        3 * height,
        escape(name)
    )
}

/// RFC 4648.
fn base_64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let group = |three: &[u8]| {
        let bits = (0..3).fold(0u32, |bits, k| bits << 8 | u32::from(three.get(k).copied().unwrap_or(0)));
        let letter =
            |k: usize| if k <= three.len() { LETTERS[(bits >> (18 - 6 * k) & 63) as usize].into() } else { '=' };
        [0, 1, 2, 3].map(letter)
    };
    bytes.chunks(3).flat_map(group).collect()
}

#[cfg(test)]
mod checks {
    /// The test vectors of RFC 4648.
    #[test]
    fn base_64_is_the_standard() {
        for (text, expected) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            assert_eq!(super::base_64(text.as_bytes()), expected);
        }
    }
}
