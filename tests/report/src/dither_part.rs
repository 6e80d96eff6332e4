//! What a dithered pixel costs, beside copying memory: frames larger than most caches, one thread.

use crate::page::Chapter;
use crate::progress::Progress;
use crate::table::Table;
use bluedither::Dither;
use bluedither::tables::THRESHOLD_64;
use std::hint::black_box;
use std::time::Instant;

const WIDTH: usize = 8192;
/// Of grey; two thirds of it as RGB have as many bytes.
const HEIGHT: usize = 12288;

/// A row of the table: what is timed is a whole frame.
struct Work<'a> {
    name: String,
    frame: Box<dyn FnMut() + 'a>,
}

impl<'a> Work<'a> {
    fn new(name: &str, frame: impl FnMut() + 'a) -> Self {
        Self { name: name.into(), frame: Box::new(frame) }
    }
}

pub fn chapter(quick: bool) -> Chapter {
    let height = if quick { HEIGHT / 8 } else { HEIGHT };
    let rounds = if quick { 3 } else { 9 };
    let source: Vec<u8> = (0..WIDTH * height).map(|i| (i * 7 + i / WIDTH * 13) as u8).collect();
    let progress = Progress::new("dither", 2 * rounds);
    let mut works =
        methods().map(|(name, dither)| Work::new(name, to_1_bit(&source, dither))).into_iter().collect::<Vec<_>>();
    works.extend(peers(&source));
    let of_gray = ["dither-gray", "8-bit grey to 1 bit"];
    let gray = table(of_gray, &source, [source.len(), source.len() / 8], works, rounds, &progress);
    let works = methods().map(|(name, dither)| Work::new(name, to_rgb565(&source, dither))).into();
    let pixels = source.len() / 3;
    let of_color = ["dither-color", "RGB888 to RGB565"];
    let color = table(of_color, &source, [pixels, 2 * pixels], works, rounds, &progress);
    Chapter {
        title: "Halftoning".into(),
        text: "Rows of a frame, one thread, baseline target; medians of rounds in which all take turns.".into(),
        figures: Vec::new(),
        tables: vec![gray, color],
    }
}

fn methods() -> [(&'static str, Dither<'static>); 4] {
    [
        ("blue noise, 64²", Dither::blue(&THRESHOLD_64)),
        ("ordered (Bayer), 64²", Dither::ordered(6)),
        ("constant", Dither::constant(1 << 31)),
        ("random", Dither::random(1)),
    ]
}

fn to_1_bit<'a>(source: &'a [u8], dither: Dither<'a>) -> impl FnMut() + use<'a> {
    let mut bits = vec![1; source.len() / 8];
    move || {
        let rows = source.chunks_exact(WIDTH).zip(bits.chunks_exact_mut(WIDTH / 8));
        for (y, (row, bits)) in (0..).zip(rows) {
            dither.gray1_row(y, row, bits).expect("rows of equal width");
        }
        black_box(&mut bits);
    }
}

fn to_rgb565<'a>(source: &'a [u8], dither: Dither<'a>) -> impl FnMut() + use<'a> {
    let mut words = vec![1; source.len() / 3];
    move || {
        let rows = source.chunks_exact(3 * WIDTH).zip(words.chunks_exact_mut(WIDTH));
        for (y, (row, words)) in (0..).zip(rows) {
            dither.rgb565_row(y, row, words).expect("rows of equal width");
        }
        black_box(&mut words);
    }
}

/// The `blue-noise` package by a mask of the same size: grey to black and white, whose pixels it writes as RGB888.
#[cfg(feature = "blue-noise")]
fn peers(source: &[u8]) -> Option<Work<'_>> {
    use blue_noise::{BlueNoiseTexture, Color, DitherOptions, apply_dithering_to_image};
    let mask = (0..64 * 64).map(|p| (THRESHOLD_64.value(p % 64, p / 64) * 256.0) as u8).collect();
    let mask = BlueNoiseTexture::from_data(mask, 64, 64).ok()?;
    let [width, height] = [WIDTH, source.len() / WIDTH].map(|side| side as u32);
    let image = image::DynamicImage::from(image::GrayImage::from_raw(width, height, source.to_vec())?);
    let frame = move || {
        let [foreground, background] = [0, 255].map(|v| Color::new(v, v, v));
        let options = DitherOptions { foreground, background, width: None, height: None, contrast: None };
        black_box(apply_dithering_to_image(&image, &mask, options));
    };
    Some(Work::new("blue-noise package (writes RGB888)", frame))
}

#[cfg(not(feature = "blue-noise"))]
fn peers(_: &[u8]) -> Option<Work<'static>> {
    None
}

/// Times all, and a copy that reads and writes as many bytes as the first together: `source` and `written`.
fn table<'a>(
    [id, title]: [&str; 2],
    source: &'a [u8],
    [pixels, written]: [usize; 2],
    mut works: Vec<Work<'a>>,
    rounds: usize,
    progress: &Progress,
) -> Table {
    let half = &source[..(source.len() + written) / 2];
    let mut copy = vec![1; half.len()];
    let copying = move || {
        copy.copy_from_slice(black_box(half));
        black_box(&mut copy);
    };
    works.insert(0, Work::new("copy of as many bytes", copying));
    let mut times = vec![Vec::new(); works.len()];
    for _ in 0..rounds {
        for (Work { frame, .. }, times) in works.iter_mut().zip(&mut times) {
            let start = Instant::now();
            frame();
            times.push(start.elapsed().as_secs_f64());
        }
        progress.add(1);
    }
    let medians: Vec<f64> = times.into_iter().map(crate::speed::median).collect();
    let row = |(Work { name, .. }, time): (&Work<'_>, &f64)| {
        vec![name.clone(), format!("{:.3}", time * 1e9 / pixels as f64), format!("{:.1}", time / medians[0])]
    };
    Table {
        id: id.into(),
        title: title.into(),
        about: "Nanoseconds a pixel; time over that of the copy.".into(),
        head: ["", "ns a pixel", "copies"].map(String::from).to_vec(),
        rows: works.iter().zip(&medians).map(row).collect(),
    }
}
