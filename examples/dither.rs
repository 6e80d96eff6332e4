//! Dithers your picture to a chosen depth by every method, side by side.
//!
//! ```text
//! cargo run --release --example dither --features gamma -- photo.jpg --depth rgb332
//! ```
//!
//! From left to right: the picture itself, constant threshold, random, ordered (Bayer 8×8), blue noise; above as most
//! programs do it, below in linear light. To copy: `dithered`.
#![allow(missing_docs, unreachable_pub, reason = "a program: its parts are read where they stand")]
#![allow(clippy::std_instead_of_core, clippy::cast_possible_truncation, reason = "for desktops, on small numbers")]

use bluedither::Dither;
use bluedither::dither::{RowError, alpha, quantise};
use bluedither::tables::THRESHOLD_64;
use clap::{Parser, ValueEnum};
use image::{ImageReader, Rgb, RgbImage, RgbaImage};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Dither a picture to few levels by every method; write them side by side.
#[derive(Parser)]
#[command(name = "dither")]
struct Arguments {
    /// The picture, PNG or JPEG
    picture: PathBuf,

    /// Levels of the display
    #[arg(long, value_enum, default_value_t = Depth::Gray1)]
    depth: Depth,

    /// Frame number: the same, with the thresholds elsewhere
    #[arg(long, default_value_t = 0)]
    frame: u32,

    /// The file to write, PNG
    #[arg(long, default_value = "dithered.png")]
    out: PathBuf,
}

#[derive(Clone, Copy, ValueEnum)]
enum Depth {
    Gray1,
    Gray2,
    Gray4,
    Rgb111,
    Rgb332,
    Rgb565,
}

impl Depth {
    /// Levels of red, green and blue, and whether they are one channel.
    const fn levels(self) -> ([u16; 3], bool) {
        match self {
            Self::Gray1 => ([2; 3], true),
            Self::Gray2 => ([4; 3], true),
            Self::Gray4 => ([16; 3], true),
            Self::Rgb111 => ([2; 3], false),
            Self::Rgb332 => ([8, 8, 4], false),
            Self::Rgb565 => ([32, 64, 32], false),
        }
    }
}

/// Pixels between the pictures.
const GAP: u32 = 8;

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(line) => {
            eprintln!("error: {line}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    let picture = read(&arguments.picture)?;
    let (width, height) = picture.dimensions();
    let methods = [Dither::constant(1 << 31), Dither::random(1), Dither::ordered(3), Dither::blue(&THRESHOLD_64)]
        .map(|method| method.frame(arguments.frame));
    let too_large = || format!("{width}x{height} pixels are too many for a sheet of ten: make the picture smaller");
    let columns = methods.len() as u32 + 1;
    let sheet_width = (width.checked_add(GAP)).and_then(|w| w.checked_mul(columns)).ok_or_else(too_large)?;
    let sheet_height = (height.checked_add(GAP)).and_then(|h| h.checked_mul(2)).ok_or_else(too_large)?;
    if u64::from(sheet_width) * u64::from(sheet_height) > 1 << 28 {
        return Err(too_large());
    }
    let mut sheet = RgbImage::from_pixel(sheet_width - GAP, sheet_height - GAP, Rgb([255; 3]));
    for (row, linear_light) in [false, true].into_iter().enumerate() {
        let top = i64::from(row as u32 * (height + GAP));
        // A finer display than any: the picture as it would be.
        let best = ([256; 3], arguments.depth.levels().1);
        let shown = dithered(&picture, Dither::constant(1 << 31), best);
        image::imageops::replace(&mut sheet, &shown.map_err(|error| error.to_string())?, 0, top);
        for (column, method) in methods.into_iter().enumerate() {
            let method = if linear_light { method.gamma() } else { method };
            let shown = dithered(&picture, method, arguments.depth.levels()).map_err(|error| error.to_string())?;
            image::imageops::replace(&mut sheet, &shown, i64::from((column as u32 + 1) * (width + GAP)), top);
        }
    }
    let out = &arguments.out;
    sheet
        .save_with_format(out, image::ImageFormat::Png)
        .map_err(|error| format!("{} cannot be written ({error}): choose another by --out", out.display()))?;
    println!("written to {}: original, constant, random, ordered, blue; below in linear light", out.display());
    Ok(())
}

fn read(path: &Path) -> Result<RgbaImage, String> {
    let reader = ImageReader::open(path).and_then(ImageReader::with_guessed_format);
    let reader =
        reader.map_err(|error| format!("{} cannot be read ({error}): name a PNG or JPEG file", path.display()))?;
    let picture = reader.decode();
    let picture = picture.map_err(|error| format!("{} is no whole PNG or JPEG file ({error})", path.display()))?;
    Ok(picture.to_rgba8())
}

/// Row by row: over white, dithered to levels, and what these look like.
fn dithered(picture: &RgbaImage, dither: Dither<'_>, depth: ([u16; 3], bool)) -> Result<RgbImage, RowError> {
    let (width, height) = picture.dimensions();
    let ([red, green, blue], gray) = depth;
    let mut shown = RgbImage::new(width, height);
    let mut colors = vec![0; 3 * width as usize];
    let mut found = vec![[0; 3]; width as usize];
    let mut found_gray = vec![[0; 1]; width as usize];
    for (y, rgba) in (0..height).zip(picture.chunks_exact(4 * width as usize)) {
        alpha::over_row(rgba, [255; 3], &mut colors)?;
        if gray {
            let lumas: Vec<u16> = colors.chunks_exact(3).map(luma).collect();
            dither.levels_row(y, &lumas[..], [red], &mut found_gray)?;
            found.iter_mut().zip(&found_gray).for_each(|(found, gray)| *found = [gray[0]; 3]);
        } else {
            dither.levels_row(y, &colors[..], [red, green, blue], &mut found)?;
        }
        for (x, found) in (0..width).zip(&found) {
            let value = |c: usize| quantise::value(u16::from(found[c]), 255, [red, green, blue][c]) as u8;
            shown.put_pixel(x, y, Rgb([value(0), value(1), value(2)]));
        }
    }
    Ok(shown)
}

/// Luma of ITU-R BT.709.
fn luma(rgb: &[u16]) -> u16 {
    let sum = 54 * u32::from(rgb[0]) + 183 * u32::from(rgb[1]) + 19 * u32::from(rgb[2]);
    ((sum + 128) >> 8) as u16
}
