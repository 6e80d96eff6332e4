//! Alpha: blended with a background before dithering, or dithered itself.
//!
//! Blending rounds to 16 bits, so next to nothing is lost before the dither. For a picture on top of what a screen
//! already shows, dither the alpha: [`Dither::stencil_row`](super::Dither::stencil_row) says which pixels to draw, and
//! [`Dither::levels_row`](super::Dither::levels_row) of four channels gives it any number of levels.

use super::RowError;

/// A pixel with alpha (not premultiplied) over a background, 16 bits a channel, rounded to the nearest.
#[inline]
#[must_use]
pub fn over(pixel: [u8; 4], background: [u8; 3]) -> [u16; 3] {
    let [r, g, b, alpha] = pixel;
    let blend = |front: u8, back: u8| {
        let front = u32::from(front) * u32::from(alpha);
        let sum = front + u32::from(back) * u32::from(255 - alpha);
        // 65535/255² = 257/255 = 1 + 2/255.
        u16::try_from(sum + (2 * sum + 127) / 255).unwrap_or(u16::MAX)
    };
    [blend(r, background[0]), blend(g, background[1]), blend(b, background[2])]
}

/// [`over`] for a row: `rgba` interleaved, `rgb` ready for the row functions as [`Samples::U16`](super::Samples::U16).
///
/// # Errors
/// If `rgba` does not hold whole pixels, or `rgb` is shorter than three numbers a pixel; then nothing is written.
pub fn over_row(rgba: &[u8], background: [u8; 3], rgb: &mut [u16]) -> Result<(), RowError> {
    let pixels = super::rows::pixels(rgba.len(), 4)?;
    super::rows::fits(pixels * 3, rgb.len())?;
    for (pixel, out) in rgba.chunks_exact(4).zip(rgb.chunks_exact_mut(3)) {
        if let &[r, g, b, alpha] = pixel {
            out.copy_from_slice(&over([r, g, b, alpha], background));
        }
    }
    Ok(())
}
