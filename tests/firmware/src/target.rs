//! What is drawn through the dithering target, pixel by pixel, in runs and in areas beyond the screen.

use bluedither::dither::target::{DitherTarget, DitheredFrom};
use bluedither::tables::THRESHOLD_32;
use bluedither::{Dither, hash};
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::raw::{RawData, RawU1, RawU4, RawU16};
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray4, Gray8, PixelColor, Rgb565, Rgb888};
use embedded_graphics_core::primitives::Rectangle;

/// A display that keeps a checksum of what it is told.
struct Screen<C: PixelColor> {
    sum: u32,
    bits: fn(C) -> u32,
}

impl<C: PixelColor> OriginDimensions for Screen<C> {
    fn size(&self) -> Size {
        Size::new(30, 20)
    }
}

impl<C: PixelColor> DrawTarget for Screen<C> {
    type Color = C;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(at, color) in pixels {
            for word in [at.x as u32, at.y as u32, (self.bits)(color)] {
                self.sum = hash::combine(self.sum, word);
            }
        }
        Ok(())
    }
}

pub(crate) fn target() -> u32 {
    let binary = on(|color: BinaryColor| RawU1::from(color).into_inner().into());
    let gray = on(|color: Gray4| RawU4::from(color).into_inner().into());
    let color = on(|color: Rgb565| RawU16::from(color).into_inner().into());
    crate::fold([binary, gray, color])
}

fn on<C: DitheredFrom<Rgb888> + DitheredFrom<Gray8>>(bits: fn(C) -> u32) -> u32 {
    let mut display = Screen { sum: 1, bits };
    let dither = Dither::blue(&THRESHOLD_32).frame(3);
    let part = Rectangle::new(Point::new(4, 3), Size::new(9, 7));
    let mut screen = DitherTarget::new(&mut display, dither);
    let Ok(()) = screen.draw_iter((0..40).map(|k| Pixel(Point::new(k - 9, 2 - k), Rgb888::new(200, 6 * k as u8, 17))));
    let Ok(()) = screen.fill_contiguous(&part, (0..63).map(|k| Rgb888::new(4 * k, 90, 255 - 4 * k)));
    let Ok(()) = screen.fill_solid(&Rectangle::new(Point::new(-9, 11), Size::new(u32::MAX, 400)), Rgb888::new(1, 2, 3));
    let mut screen = DitherTarget::new(&mut display, dither);
    let Ok(()) = screen.fill_contiguous(&part, (0..63).map(|k| Gray8::new(4 * k)));
    display.sum
}
