//! A draw target of `embedded-graphics` that dithers what is drawn into a display of fewer colours.
//!
//! ```text
//! let mut screen = DitherTarget::new(&mut display, Dither::blue(&THRESHOLD_32)); // display: Rgb565, Gray4, BinaryColor, …
//! Circle::new(Point::zero(), 64).into_styled(PrimitiveStyle::with_fill(Rgb888::CSS_CORAL)).draw(&mut screen)?;
//! ```
//!
//! Colours that are drawn are [`Rgb888`] or [`Gray8`]; grey displays take the luma of RGB, and a grey is drawn on
//! colour displays as the RGB that is as bright. Nothing is read back and nothing stored: every pixel is dithered at
//! its own place, so that parts drawn at different times fit.

use super::Dither;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
    RgbColor,
};
use embedded_graphics_core::primitives::{PointsIter, Rectangle};

/// A colour that can be dithered from colours of type `C`.
pub trait DitheredFrom<C: PixelColor>: PixelColor {
    /// The colour of the pixel at (x, y).
    fn dithered(color: C, x: u32, y: u32, dither: &Dither<'_>) -> Self;
}

/// Draws to `display`, dithered.
#[derive(Debug)]
pub struct DitherTarget<'d, 'm, D, C> {
    display: &'d mut D,
    dither: Dither<'m>,
    drawn: core::marker::PhantomData<C>,
}

impl<'d, 'm, D: DrawTarget, C> DitherTarget<'d, 'm, D, C> {
    /// What is drawn to the new target in colours of type `C` appears on `display`, dithered.
    pub fn new(display: &'d mut D, dither: Dither<'m>) -> Self {
        Self { display, dither, drawn: core::marker::PhantomData }
    }
}

impl<D: DrawTarget, C> Dimensions for DitherTarget<'_, '_, D, C> {
    fn bounding_box(&self) -> Rectangle {
        self.display.bounding_box()
    }
}

impl<D: DrawTarget<Color: DitheredFrom<C>>, C: PixelColor> DrawTarget for DitherTarget<'_, '_, D, C> {
    type Color = C;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        let dither = self.dither;
        self.display.draw_iter(pixels.into_iter().map(|Pixel(at, color)| Pixel(at, at_point(color, at, &dither))))
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), D::Error> {
        let dither = self.dither;
        let points = area.points().zip(colors);
        self.display.fill_contiguous(area, points.map(|(at, color)| at_point(color, at, &dither)))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), D::Error> {
        let dither = self.dither;
        // A solid area is cut to the display: an area may be as large as its numbers allow.
        let area = common(*area, self.display.bounding_box());
        self.display.fill_contiguous(&area, area.points().map(|at| at_point(color, at, &dither)))
    }
}

/// What two areas have in common. `Rectangle::intersection` takes no areas that end beyond the largest coordinate.
fn common(a: Rectangle, b: Rectangle) -> Rectangle {
    let (left, width) = overlap([a.top_left.x, b.top_left.x], [a.size.width, b.size.width]);
    let (top, height) = overlap([a.top_left.y, b.top_left.y], [a.size.height, b.size.height]);
    Rectangle::new(Point::new(left, top), Size::new(width, height))
}

/// Start and length of what two intervals have in common.
fn overlap(starts: [i32; 2], lengths: [u32; 2]) -> (i32, u32) {
    let [a, b] = [0, 1].map(|k: usize| i64::from(starts[k]) + i64::from(lengths[k]));
    let start = starts[0].max(starts[1]);
    (start, u32::try_from(a.min(b) - i64::from(start)).unwrap_or(0))
}

/// Coordinates may be negative: thresholds repeat there as well.
#[expect(clippy::cast_sign_loss, reason = "wraps")]
fn at_point<C: PixelColor, T: DitheredFrom<C>>(color: C, at: Point, dither: &Dither<'_>) -> T {
    T::dithered(color, at.x as u32, at.y as u32, dither)
}

/// One of `levels` in an area of 8 bits.
#[expect(clippy::cast_possible_truncation, reason = "at most 256 levels")]
fn level(dither: &Dither<'_>, x: u32, y: u32, channel: u32, value: u8, levels: u16) -> u8 {
    dither.level(x, y, channel, u16::from(value), 255, levels) as u8
}

/// Luma of ITU-R BT.709, in 256ths.
#[expect(clippy::cast_possible_truncation, reason = "the weights are 256 together")]
fn luma(color: Rgb888) -> Gray8 {
    let sum = 54 * u32::from(color.r()) + 183 * u32::from(color.g()) + 19 * u32::from(color.b());
    Gray8::new(((sum + 128) >> 8) as u8)
}

macro_rules! grays {
    ($($gray:ident: $levels:literal, |$level:ident| $make:expr;)*) => {$(
        impl DitheredFrom<Gray8> for $gray {
            fn dithered(color: Gray8, x: u32, y: u32, dither: &Dither<'_>) -> Self {
                let $level = level(dither, x, y, 0, color.luma(), $levels);
                $make
            }
        }

        impl DitheredFrom<Rgb888> for $gray {
            fn dithered(color: Rgb888, x: u32, y: u32, dither: &Dither<'_>) -> Self {
                Self::dithered(luma(color), x, y, dither)
            }
        }
    )*};
}

grays! {
    BinaryColor: 2, |level| if level == 0 { Self::Off } else { Self::On };
    Gray2: 4, |level| Self::new(level);
    Gray4: 16, |level| Self::new(level);
}

macro_rules! colors {
    ($($color:ident)*) => {$(
        impl DitheredFrom<Rgb888> for $color {
            fn dithered(color: Rgb888, x: u32, y: u32, dither: &Dither<'_>) -> Self {
                let channel = |k, value, max: u8| level(dither, x, y, k, value, u16::from(max) + 1);
                Self::new(
                    channel(0, color.r(), Self::MAX_R),
                    channel(1, color.g(), Self::MAX_G),
                    channel(2, color.b(), Self::MAX_B),
                )
            }
        }

        impl DitheredFrom<Gray8> for $color {
            fn dithered(color: Gray8, x: u32, y: u32, dither: &Dither<'_>) -> Self {
                let luma = color.luma();
                Self::dithered(Rgb888::new(luma, luma, luma), x, y, dither)
            }
        }
    )*};
}

colors! { Rgb555 Rgb565 Rgb666 Bgr555 Bgr565 Bgr666 }
