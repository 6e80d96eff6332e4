//! Contact sheets: samplers side by side, samples per pixel downwards, a magnified crop in each cell.

use embedded_graphics::mono_font::ascii::{FONT_7X13, FONT_9X18_BOLD, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::{DrawTarget, OriginDimensions, Pixel, Point, Size};
use embedded_graphics::text::{Baseline, Text};
use image::{Rgb, RgbImage, imageops};

pub const TITLE: &MonoFont<'_> = &FONT_10X20;
pub const HEAD: &MonoFont<'_> = &FONT_9X18_BOLD;
pub const SMALL: &MonoFont<'_> = &FONT_7X13;

/// An image that `embedded-graphics` draws text on.
pub struct Canvas(pub RgbImage);

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(self.0.width(), self.0.height())
    }
}

impl DrawTarget for Canvas {
    type Color = Rgb888;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, colour) in pixels {
            if let Some(pixel) = self.0.get_pixel_mut_checked(point.x.cast_unsigned(), point.y.cast_unsigned()) {
                *pixel = Rgb([colour.r(), colour.g(), colour.b()]);
            }
        }
        Ok(())
    }
}

impl Canvas {
    pub fn new(width: u32, height: u32) -> Self {
        Self(RgbImage::from_pixel(width, height, Rgb([22, 22, 24])))
    }

    /// Text with its upper left corner at (x, y).
    pub fn text(&mut self, text: &str, x: u32, y: u32, font: &MonoFont) {
        let style = MonoTextStyle::new(font, Rgb888::new(236, 236, 232));
        let drawn = Text::with_baseline(text, Point::new(x.cast_signed(), y.cast_signed()), style, Baseline::Top);
        let Ok(_) = embedded_graphics::Drawable::draw(&drawn, self);
    }

    /// A picture whose every pixel becomes a square of `zoom` pixels.
    pub fn picture(&mut self, picture: &RgbImage, x: u32, y: u32, zoom: u32) {
        let [width, height] = [picture.width() * zoom, picture.height() * zoom];
        let large = imageops::resize(picture, width, height, imageops::FilterType::Nearest);
        imageops::replace(&mut self.0, &large, x.into(), y.into());
    }

    /// The outline of a rectangle.
    pub fn outline(&mut self, corner: [u32; 2], size: [u32; 2]) {
        for i in 0..=size[0].max(size[1]) {
            let [dx, dy] = [i.min(size[0]), i.min(size[1])];
            for [x, y] in [[dx, 0], [dx, size[1]], [0, dy], [size[0], dy]] {
                if let Some(pixel) = self.0.get_pixel_mut_checked(corner[0] + x, corner[1] + y) {
                    *pixel = Rgb([255, 255, 255]);
                }
            }
        }
    }
}

/// One cell of a sheet: what is shown and the line below it.
pub struct Cell {
    pub picture: RgbImage,
    pub caption: String,
}

/// What stands above the cells.
pub struct Banner<'a> {
    pub title: &'a str,
    pub lines: &'a [String],
    pub picture: &'a RgbImage,
    /// The part of `picture` that the cells show.
    pub crop: Option<Crop>,
}

/// A part of a picture: its upper left corner and its size.
#[derive(Clone, Copy)]
pub struct Crop {
    pub corner: [u32; 2],
    pub size: [u32; 2],
}

impl Crop {
    pub fn of(&self, picture: &RgbImage) -> RgbImage {
        let ([x, y], [width, height]) = (self.corner, self.size);
        imageops::crop_imm(picture, x, y, width, height).to_image()
    }
}

/// A labelled grid. `rows` hold one cell a column.
pub fn contact_sheet(banner: &Banner, columns: &[&str], rows: &[(String, Vec<Cell>)], zoom: u32) -> RgbImage {
    const GAP: u32 = 8;
    const LEFT: u32 = 76;
    let cell = rows[0].1[0].picture.dimensions();
    let step = [cell.0 * zoom + GAP, cell.1 * zoom + 16 + GAP];
    let head = banner.picture.height() + 2 * GAP + 46;
    let width = (LEFT + step[0] * columns.len() as u32).max(banner.picture.width() + 560);
    let mut canvas = Canvas::new(width, head + step[1] * rows.len() as u32);

    canvas.picture(banner.picture, LEFT, GAP, 1);
    if let Some(crop) = banner.crop {
        canvas.outline([LEFT + crop.corner[0], GAP + crop.corner[1]], crop.size);
    }
    let text = LEFT + banner.picture.width() + 2 * GAP;
    canvas.text(banner.title, text, GAP, TITLE);
    for (i, line) in (0..).zip(banner.lines) {
        canvas.text(line, text, GAP + 34 + 18 * i, SMALL);
    }
    for (i, name) in (0..).zip(columns) {
        let x = LEFT + step[0] * i;
        let (first, second) = name.split_once('-').unwrap_or((name, ""));
        canvas.text(first, x, head - 42, HEAD);
        canvas.text(second, x, head - 22, HEAD);
    }
    for (j, (label, cells)) in (0..).zip(rows) {
        let y = head + step[1] * j;
        canvas.text(label, GAP, y, HEAD);
        for (i, cell) in (0..).zip(cells) {
            let x = LEFT + step[0] * i;
            canvas.picture(&cell.picture, x, y, zoom);
            canvas.text(&cell.caption, x, y + cell.picture.height() * zoom + 2, SMALL);
        }
    }
    canvas.0
}

/// The picture for a README: two samplers one above the other, each with a magnified crop and the error there.
pub fn hero(rows: &[(String, RgbImage, RgbImage)], crop: Crop, zoom: u32) -> RgbImage {
    const GAP: u32 = 6;
    const LABEL: u32 = 22;
    let (width, height) = rows[0].1.dimensions();
    let inset = [crop.size[0] * zoom, crop.size[1] * zoom];
    let step = height.max(inset[1]) + LABEL + GAP;
    let mut canvas = Canvas::new(width + 2 * (inset[0] + GAP) + 2 * GAP, step * rows.len() as u32 + GAP);
    for (j, (label, picture, error)) in (0..).zip(rows) {
        let y = GAP + step * j;
        canvas.text(label, GAP, y, HEAD);
        canvas.picture(picture, GAP, y + LABEL, 1);
        canvas.outline([GAP + crop.corner[0], y + LABEL + crop.corner[1]], crop.size);
        let x = width + 2 * GAP;
        canvas.picture(&crop.of(picture), x, y + LABEL, zoom);
        canvas.text("error", x + inset[0] + GAP, y, HEAD);
        canvas.picture(&crop.of(error), x + inset[0] + GAP, y + LABEL, zoom);
    }
    canvas.0
}
