//! What was found: the table on the terminal, and every picture in its folder.

use crate::film::Image;
use crate::measure::{self, SIGMAS};
use crate::reference::Reference;
use crate::sheet::{self, Banner, Cell, Crop};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{DynamicImage, ExtendedColorType, ImageEncoder, RgbImage};
use std::fmt::{self, Display, Formatter};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// One picture and its error.
pub struct Found {
    name: &'static str,
    image: Image,
    error: Image,
    time: Duration,
    rms: f32,
    filtered: [f32; 2],
}

impl Found {
    pub fn measure(name: &'static str, image: Image, time: Duration, reference: &Image) -> Self {
        let error = image.minus(reference);
        let filtered = SIGMAS.map(|sigma| measure::rms(&measure::gaussian(&error, sigma)));
        Self { name, image, time, rms: measure::rms(&error), filtered, error }
    }
}

/// All samplers at one number of samples per pixel.
pub struct Row {
    spp: u32,
    found: Vec<Found>,
    white: usize,
}

pub const HEADING: &str = "
                                  |  root mean square error      | over that of white, same spp
sampler               spp      ms |  pixel  sigma 1.0  sigma 2.1 |  pixel  sigma 1.0  sigma 2.1";

impl Row {
    /// `found` holds "white", which the others are measured against.
    pub fn new(spp: u32, found: Vec<Found>) -> Self {
        let white = found.iter().position(|found| found.name == "white");
        Self { spp, found, white: white.expect("white is always rendered") }
    }

    fn white(&self) -> &Found {
        &self.found[self.white]
    }
}

impl Display for Row {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let white = self.white();
        for Found { name, time, rms, filtered: [fine, coarse], .. } in &self.found {
            let ms = time.as_secs_f32() * 1000.0;
            write!(f, "{name:19} {:5} {ms:7.1} | {rms:.4}     {fine:.4}     {coarse:.4} | ", self.spp)?;
            let ratios = [rms / white.rms, fine / white.filtered[0], coarse / white.filtered[1]];
            writeln!(f, "{:6.2} {:10.2} {:10.2}", ratios[0], ratios[1], ratios[2])?;
        }
        Ok(())
    }
}

/// Where the pictures go.
pub struct Folders {
    top: PathBuf,
    image: PathBuf,
    error: PathBuf,
    spectrum: PathBuf,
}

impl Folders {
    pub fn create(top: &Path) -> Result<Self, String> {
        let create = |folder: PathBuf| match fs::create_dir_all(&folder) {
            Ok(()) => Ok(folder),
            Err(error) => Err(format!("the folder {} cannot be made: {error}", folder.display())),
        };
        Ok(Self {
            top: create(top.to_path_buf())?,
            image: create(top.join("image"))?,
            error: create(top.join("error"))?,
            spectrum: create(top.join("spectrum"))?,
        })
    }
}

/// Writes the single pictures, the three contact sheets and the hero.
pub fn save(rows: &[Row], reference: &Reference, folders: &Folders) -> Result<(), String> {
    let converged = reference.image.develop();
    let [width, height] = reference.image.size;
    let crop =
        Crop { corner: [(width * 56 / 100).min(width - 64), (height * 46 / 100).min(height - 64)], size: [64, 64] };
    let mut sheets: [Vec<(String, Vec<Cell>)>; 3] = Default::default();
    for row in rows {
        let white = row.white();
        let scale = 3.0 * white.rms.max(1e-6);
        let white_power = measure::mean_power(&measure::spectrum(&white.error)).max(1e-20);
        sheets.iter_mut().for_each(|sheet| sheet.push((format!("{} spp", row.spp), Vec::new())));
        for Found { name, image, error, rms, filtered, .. } in &row.found {
            let file = format!("{name}-{:04}spp.png", row.spp);
            let picture = image.develop();
            let signed = error.develop_signed(scale);
            let power = measure::develop_spectrum(&measure::spectrum(error), white_power);
            let power = DynamicImage::ImageLuma8(power).into_rgb8();
            write(&picture, &folders.image.join(&file))?;
            write(&signed, &folders.error.join(&file))?;
            write(&power, &folders.spectrum.join(&file))?;

            let caption = format!("rmse {rms:.3}  filtered x{:.2}", filtered[0] / white.filtered[0]);
            for (sheet, picture) in sheets.iter_mut().zip([crop.of(&picture), crop.of(&signed), power]) {
                if let Some((_, cells)) = sheet.last_mut() {
                    cells.push(Cell { picture, caption: caption.clone() });
                }
            }
        }
    }
    write(&converged, &folders.top.join("reference.png"))?;

    let columns: Vec<&str> =
        rows.first().map(|row| row.found.iter().map(|found| found.name).collect()).unwrap_or_default();
    let legends = [
        ("sheet-image.png", "Blue-noise dithered sampling: the pictures", "Each cell magnifies the marked part."),
        (
            "sheet-error.png",
            "Signed errors around mid grey",
            "Black and white: 3 times white noise's rmse at that spp.",
        ),
        (
            "sheet-spectrum.png",
            "Power of the errors over frequency",
            "Logarithmic, 3 decades up to 10 times white noise's mean; DC in the centre.",
        ),
    ];
    for ((file, title, what), cells) in legends.into_iter().zip(&sheets) {
        let lines = [
            what.to_string(),
            String::new(),
            format!("Left: the reference, {} spp.", reference.spp),
            "Rows: samples per pixel. Columns: samplers.".to_string(),
            "rmse: root mean square error of a pixel, linear.".to_string(),
            "filtered: the rmse left by a Gaussian of 1 pixel, over white's.".to_string(),
        ];
        let crop = (file != "sheet-spectrum.png").then_some(crop);
        let banner = Banner { title, lines: &lines, picture: &converged, crop };
        write(&sheet::contact_sheet(&banner, &columns, cells, 3), &folders.top.join(file))?;
    }
    hero(rows, crop, folders)
}

/// White noise over the library's default at the smallest number of samples per pixel.
fn hero(rows: &[Row], crop: Crop, folders: &Folders) -> Result<(), String> {
    let Some(row) = rows.iter().min_by_key(|row| row.spp) else { return Ok(()) };
    let scale = 3.0 * row.white().rms.max(1e-6);
    let chosen = ["white", "sampler"].into_iter().filter_map(|name| row.found.iter().find(|found| found.name == name));
    let rows: Vec<(String, RgbImage, RgbImage)> = chosen
        .map(|found| {
            let name = if found.name == "white" { "white noise" } else { "bluedither" };
            (format!("{name}, {} spp", row.spp), found.image.develop(), found.error.develop_signed(scale))
        })
        .collect();
    if rows.len() < 2 { Ok(()) } else { write_small(&sheet::hero(&rows, crop, 4), &folders.top.join("hero.png")) }
}

fn write(picture: &RgbImage, path: &Path) -> Result<(), String> {
    picture.save(path).map_err(|error| format!("{} cannot be written: {error}", path.display()))
}

/// Six bits a channel and the hardest compression: noise packs badly, and a README's picture must be small.
fn write_small(picture: &RgbImage, path: &Path) -> Result<(), String> {
    let mut packed = Vec::new();
    let levels: Vec<u8> = picture.iter().map(|level| level & 0xfc | level >> 6).collect();
    PngEncoder::new_with_quality(&mut packed, CompressionType::Best, FilterType::NoFilter)
        .write_image(&levels, picture.width(), picture.height(), ExtendedColorType::Rgb8)
        .map_err(|error| error.to_string())
        .and_then(|()| fs::write(path, packed).map_err(|error| error.to_string()))
        .map_err(|error| format!("{} cannot be written: {error}", path.display()))
}
