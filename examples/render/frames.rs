//! Frame after frame: a room of paths of ten bounces, with new white noise in every frame and with seeds that change
//! places.
//!
//! ```text
//! cargo run --release --features seed-permutation --example render -- --frames 16
//! ```
//!
//! With a still camera, and with one that pans. Seeds are not carried along with the picture; in this room, which is
//! smooth, two pixels a frame take nothing of the gain.

use crate::arguments::Arguments;
use crate::film::Image;
use crate::measure::{self, SIGMAS};
use crate::paths;
use bluedither::frames::seeds;
use bluedither::{White, hash};
use glam::Vec3A;
use image::{RgbImage, imageops};
use rayon::prelude::*;
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

/// Camera motions that are shown: name, and pixels a frame.
const MOTIONS: [(&str, f32); 3] = [("still", 0.0), ("half-pixel", 0.5), ("two-pixels", 2.0)];

/// Renders `count` frames each way; prints what filters leave of the last one's error, and saves the frames as animated
/// pictures, white noise to the left.
pub fn animate(count: u32, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    println!("filtered error of frame {} over that of white noise, sigma 1.0 / 2.1", count - 1);
    for (name, speed) in MOTIONS {
        let last = speed * (count - 1) as f32;
        let exact = Picture::new(arguments.size, last, 256, &first_seeds(arguments.size, !arguments.seed));
        for spp in [1, 16] {
            let white = |frame| first_seeds(arguments.size, hash::combine(arguments.seed, frame));
            let reference = left_by_filters(&exact, &Picture::new(arguments.size, last, spp, &white(count - 1)));
            let mut line = format!("{name:11} {spp:2} spp");
            for side in [4, 8] {
                let mut seeds = white(0);
                let mut pictures = Vec::new();
                for frame in 0..count {
                    let pan = speed * frame as f32;
                    let picture = Picture::new(arguments.size, pan, spp, &seeds);
                    let permute = if side == 4 { seeds::permute::<4> } else { seeds::permute::<8> };
                    permute(&mut seeds, &picture.luminances, arguments.size[0], frame);
                    if spp == 1 && side == 8 {
                        let noise = Picture::new(arguments.size, pan, spp, &white(frame));
                        pictures.push(beside(&noise.image().develop(), &picture.image().develop()));
                    }
                    if frame + 1 == count {
                        let [fine, coarse] = left_by_filters(&exact, &picture);
                        line += &format!("   {side}x{side} {:.2} / {:.2}", fine / reference[0], coarse / reference[1]);
                    }
                }
                if !pictures.is_empty() {
                    save(&pictures, &arguments.out.join(format!("paths-{name}.png")))?;
                }
            }
            println!("{line}");
        }
    }
    println!("written to {}: paths-*.png, animated", arguments.out.display());
    #[cfg(feature = "threshold-over-time-64")]
    {
        save(&crate::ways::pictures(count), &arguments.out.join("ways.png"))?;
        println!("and ways.png, frames above and their moving average below: {}", crate::ways::NAMES);
    }
    Ok(())
}

/// Luminances, row by row.
struct Picture {
    size: [u32; 2],
    luminances: Vec<f32>,
}

impl Picture {
    /// One seed a pixel, which is all that its samples depend on.
    fn new(size: [u32; 2], pan: f32, spp: u32, seeds: &[u32]) -> Self {
        let pixel = |(p, &seed): (usize, &u32)| {
            let sampler = White::new(seed).pixel(0, 0, 0);
            let place = [p as u32 % size[0], p as u32 / size[0]];
            let path = |index| paths::luminance(place, size, pan, |bounce| sampler.draw::<2>(bounce, index));
            (0..spp).map(path).sum::<f32>() / spp as f32
        };
        Self { size, luminances: seeds.par_iter().enumerate().map(pixel).collect() }
    }

    fn image(&self) -> Image {
        Image { size: self.size, pixels: self.luminances.iter().map(|&luminance| Vec3A::splat(luminance)).collect() }
    }
}

fn first_seeds(size: [u32; 2], seed: u32) -> Vec<u32> {
    (0..size[0] * size[1]).map(|p| hash::combine(seed, p)).collect()
}

/// What the filters leave of a picture's error.
fn left_by_filters(exact: &Picture, picture: &Picture) -> [f32; 2] {
    let error = picture.image().minus(&exact.image());
    SIGMAS.map(|sigma| measure::rms(&measure::gaussian(&error, sigma)))
}

fn beside(left: &RgbImage, right: &RgbImage) -> RgbImage {
    let mut both = RgbImage::new(left.width() + right.width() + 4, left.height());
    imageops::replace(&mut both, left, 0, 0);
    imageops::replace(&mut both, right, i64::from(left.width()) + 4, 0);
    both
}

/// An animated PNG of ten frames a second, for ever.
fn save(pictures: &[RgbImage], path: &Path) -> Result<(), Box<dyn Error>> {
    let [width, height] = [pictures[0].width(), pictures[0].height()];
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_animated(pictures.len() as u32, 0)?;
    encoder.set_frame_delay(1, 10)?;
    let mut writer = encoder.write_header()?;
    for picture in pictures {
        writer.write_image_data(picture.as_raw())?;
    }
    Ok(writer.finish()?)
}
