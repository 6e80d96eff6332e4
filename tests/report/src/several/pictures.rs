//! Error images enlarged, every pixel a square of four: a sampler's row shows some families side by side.

use super::family::{FAMILIES, Id};
use super::numbers::Form;
use super::results::{Cell, Results};
use super::tables::slug;
use crate::field::SIZE;
use image::{GrayImage, Luma, imageops};
use std::path::Path;

/// Families that are shown.
const SHOWN: [Id; 6] = [Id::Own, Id::Across, Id::Space5, Id::SmoothPair, Id::Smooth5, Id::Light];
/// Samples per pixel that are shown.
const COUNTS: [u32; 3] = [1, 4, 16];
const ZOOM: u32 = 4;
const GAP: u32 = 8;

/// Writes a picture a sampler, form and number of samples.
pub fn save(results: &Results, folder: &Path) -> Result<(), String> {
    let cannot = |path: &Path, error: &dyn core::fmt::Display| format!("{} cannot be written: {error}", path.display());
    std::fs::create_dir_all(folder).map_err(|error| cannot(folder, &error))?;
    for cell in results.cells.iter().filter(|cell| COUNTS.contains(&cell.count)) {
        let path = folder.join(format!("{}-{}-{:03}spp.png", cell.name, slug(cell.form.name()), cell.count));
        picture(cell).save(&path).map_err(|error| cannot(&path, &error))?;
    }
    Ok(())
}

/// What the pictures show, for the page.
pub fn legend() -> String {
    let names: Vec<&str> = SHOWN.iter().map(|id| FAMILIES[*id as usize].name).collect();
    format!(
        "in folder several, {}, {} samples: {}",
        Form::BOTH.map(Form::name).join(" and "),
        COUNTS.map(|c| c.to_string()).join(", "),
        names.join(" · ")
    )
}

/// Mid grey where there is no error; black and white are three times white noise's root mean square.
fn picture(cell: &Cell) -> GrayImage {
    let side = SIZE as u32 * ZOOM;
    let mut row = GrayImage::from_pixel((side + GAP) * SHOWN.len() as u32 - GAP, side, Luma([0]));
    for (k, id) in (0..).zip(SHOWN) {
        let (errors, scale) = (&cell.images[id as usize], 3.0 * cell.scales[id as usize]);
        let grey = |x: u32, y: u32| {
            let error = errors[y as usize * SIZE + x as usize] / scale;
            Luma([(127.5 + 127.5 * error).clamp(0.0, 255.0) as u8])
        };
        let image = GrayImage::from_fn(SIZE as u32, SIZE as u32, grey);
        let large = imageops::resize(&image, side, side, imageops::FilterType::Nearest);
        imageops::replace(&mut row, &large, i64::from((side + GAP) * k), 0);
    }
    row
}
