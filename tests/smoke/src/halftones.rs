//! Rows of every format, with lengths that only the caller knows.

use bluedither::Dither;
use bluedither::dither::target::DitherTarget;
use bluedither::dither::{Samples, alpha, gamma, ordered, quantise};
use bluedither::tables::THRESHOLD_64;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888};
use embedded_graphics_core::primitives::Rectangle;

/// Rows.
#[unsafe(no_mangle)]
pub extern "C" fn halftones(
    seed: u32,
    y: u32,
    samples: usize,
    room: usize,
    bytes: &mut [u8; 256],
    wide: &[u16; 256],
    floats: &[f32; 256],
) -> usize {
    let (all, mut words, mut levels) = (*bytes, [0; 99], [[0; 3]; 99]);
    let Some(source) = all.get(..samples) else { return 0 };
    let (Some(wide), Some(floats)) = (wide.get(..samples), floats.get(..samples)) else { return 0 };
    let (Some(dst), Some(words)) = (bytes.get_mut(..room), words.get_mut(..room)) else { return 0 };
    let rows = [Samples::U8(source), Samples::U10(wide), Samples::U12(wide), Samples::U16(wide), Samples::F32(floats)];
    let mut errors = 0;
    for dither in [
        Dither::blue(&THRESHOLD_64).frame(seed).origin(seed, y),
        Dither::constant(seed),
        Dither::random(seed),
        Dither::ordered(seed).triangular(),
        Dither::ordered(seed).gamma(),
    ] {
        for row in rows {
            errors += dither.gray1_row(y, row, dst).is_err() as usize + dither.gray2_row(y, row, dst).is_err() as usize;
            errors +=
                dither.gray4_row(y, row, dst).is_err() as usize + dither.rgb332_row(y, row, dst).is_err() as usize;
            errors += dither.rgb565_row(y, row, words).is_err() as usize;
            errors += dither.rgb888_row(y, row, dst).is_err() as usize + row.len() + usize::from(row.is_empty());
            errors += dither.levels_row(y, row, [seed as u16; 3], &mut levels).is_err() as usize;
        }
        errors += dither.stencil_row(y, source, dst).is_err() as usize;
        errors += alpha::over_row(source, [1, 2, 3], words).is_err() as usize;
        errors += usize::from(dither.level(y, seed, seed, seed as u16, y as u16, samples as u16));
        errors += dither.threshold_fx(y, seed, seed) as usize;
    }
    errors
}

/// Single values.
#[unsafe(no_mangle)]
pub extern "C" fn values(a: u16, b: u16, levels: u16, threshold: u32) -> u32 {
    let mut sum = quantise::value(a, b, levels) ^ quantise::level(a, b, levels, threshold);
    sum ^= quantise::level_triangular(a, b, levels, threshold) ^ gamma::level(a, b, levels, threshold);
    sum ^= gamma::to_linear(a) ^ gamma::from_linear(b) ^ alpha::over(threshold.to_le_bytes(), [1, 2, 3])[1];
    u32::from(sum) ^ quantise::triangular(threshold) as u32 ^ ordered::value_fx(threshold, u32::from(a), u32::from(b))
}

struct Display<C>(u32, core::marker::PhantomData<C>);

impl<C> OriginDimensions for Display<C> {
    fn size(&self) -> Size {
        Size::new(self.0, self.0)
    }
}

impl<C: embedded_graphics_core::pixelcolor::PixelColor> DrawTarget for Display<C> {
    type Color = C;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(at, _) in pixels {
            self.0 ^= at.x as u32 ^ at.y as u32;
        }
        Ok(())
    }
}

/// Draw targets, with rectangles anywhere.
#[unsafe(no_mangle)]
pub extern "C" fn target(seed: u32, x: i32, y: i32, width: u32, height: u32) -> u32 {
    let dither = Dither::blue(&THRESHOLD_64).frame(seed);
    let (mut colors, mut bits) =
        (Display::<Rgb565>(seed, Default::default()), Display::<BinaryColor>(seed, Default::default()));
    let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
    let mut screen = DitherTarget::new(&mut colors, dither);
    let Ok(()) = screen.fill_solid(&area, Rgb888::new(1, 2, 3));
    let Ok(()) = screen.fill_contiguous(&area, core::iter::repeat(Rgb888::new(7, 8, 9)));
    let Ok(()) = screen.draw_iter([Pixel(Point::new(y, x), Rgb888::new(3, 2, 1))]);
    let mut screen = DitherTarget::new(&mut bits, dither);
    let Ok(()) = screen.fill_solid(&area, Gray8::new(4));
    colors.0 ^ bits.0
}
