//! Tables as files that engines and tools read.
//!
//! - `.bin`: the numbers as the library has them, little-endian, row by row, channels interleaved. For buffers.
//! - `-16.png`, `.dds` (R16 or R16G16, unsigned normalised): values, 65536·(rank + ½)/S² rounded down. Read as
//!   integers, rank r of a mask of S² pixels is the upper 2·log₂ S bits; read as floats, within 2⁻¹⁶ of the library's
//!   value.
//! - `-8.png`: 256·(rank + ½)/S² rounded down, the *centred* quantisation: each of the 256 levels occurs equally often,
//!   and level q stands for (q + ½)/256. Divide by 256, not by 255, after adding ½: the mean is ½ then, as it should
//!   be.
//!
//! Keys are digits, not values: what is written is they themselves, and never in 8 bits. Frames lie one below the other
//! in a PNG and are layers of a DDS. Two channels are red and green. Other tables are raw only.

use crate::folder::Folder;
use crate::tables::{Kind, Table};
use ddsfile::{AlphaMode, D3D10ResourceDimension, Dds, DxgiFormat, NewDxgiParams};

/// Writes a table in all formats that suit it.
pub fn write(table: &Table, folder: &mut Folder) -> Result<(), String> {
    let stem = format!("textures/{}", table.name);
    let (size, channels) = (format!("{} x {}", table.width, table.rows()), table.channels());
    let (raw, bits) = raw(table);
    let numbers = if channels == 2 { "pairs" } else { "numbers" };
    folder.write(&format!("{stem}.bin"), &format!("{size}, raw, {numbers} of {bits} bits"), &raw)?;
    if table.is_mask() || table.kind == Kind::Keys {
        let kind = if channels == 2 { "RGB, blue is 0" } else { "grey" };
        folder.write(
            &format!("{stem}-16.png"),
            &format!(
                "{size}, 16 bits, {kind}{}",
                if table.is_mask() { ", 65536 (rank + 1/2) / pixels rounded down" } else { "" }
            ),
            &png(table, &values_16(table))?,
        )?;
        let layers = if table.frames() > 1 { format!(", {} layers", table.frames()) } else { String::new() };
        let layers = format!("{} x {}{layers}", table.width, table.rows() / table.frames());
        let format = if channels == 2 { "R16G16_UNORM" } else { "R16_UNORM" };
        folder.write(&format!("{stem}.dds"), &format!("{layers}, {format}"), &dds(table, &values_16(table))?)?;
        if table.is_mask() {
            folder.write(
                &format!("{stem}-8.png"),
                &format!("{size}, 8 bits, {kind}, level q stands for (q + 1/2) / 256"),
                &png(table, &values_8(table))?,
            )?;
        }
    }
    Ok(())
}

/// The numbers as they are, and how many bits each has.
fn raw(table: &Table) -> (Vec<u8>, usize) {
    let bytes = if table.kind == Kind::Directions { 4 } else { 2 };
    (table.numbers.iter().flat_map(|number| number.to_le_bytes()[..bytes].to_vec()).collect(), 8 * bytes)
}

/// Values of 16 bits; of keys the digits.
#[allow(clippy::cast_possible_truncation, reason = "16 bits are left")]
pub fn values_16(table: &Table) -> Vec<u16> {
    let value = |number: &u32| if table.is_mask() { (centre(table, *number) >> 16) as u16 } else { *number as u16 };
    table.numbers.iter().map(value).collect()
}

/// Values of 8 bits, centred.
#[allow(clippy::cast_possible_truncation, reason = "8 bits are left")]
pub fn values_8(table: &Table) -> Vec<u8> {
    table.numbers.iter().map(|&number| (centre(table, number) >> 24) as u8).collect()
}

/// The library's value of a rank, 0.32 fixed point.
fn centre(table: &Table, rank: u32) -> u32 {
    (2 * rank + 1) << (31 - 2 * table.size_log2())
}

/// A sample of a picture.
pub trait Sample: Copy + Default {
    const DEPTH: png::BitDepth;
    fn bytes(self) -> Vec<u8>;
}

impl Sample for u8 {
    const DEPTH: png::BitDepth = png::BitDepth::Eight;
    fn bytes(self) -> Vec<u8> {
        vec![self]
    }
}

impl Sample for u16 {
    const DEPTH: png::BitDepth = png::BitDepth::Sixteen;
    fn bytes(self) -> Vec<u8> {
        self.to_be_bytes().into()
    }
}

pub fn png<T: Sample>(table: &Table, values: &[T]) -> Result<Vec<u8>, String> {
    let (width, height) = (side(table.width), side(table.rows()));
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_depth(T::DEPTH);
    encoder.set_color(if table.channels() == 2 { png::ColorType::Rgb } else { png::ColorType::Grayscale });
    let blue = [T::default()];
    let pixel = |pixel: &[T]| pixel.iter().chain(if pixel.len() == 2 { &blue[..] } else { &[] }).copied().collect();
    let pixels = values.chunks(table.channels()).flat_map::<Vec<T>, _>(pixel);
    let bytes: Vec<u8> = pixels.flat_map(Sample::bytes).collect();
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&bytes)?;
        writer.finish()
    });
    written.map_err(|error| format!("{} is not encoded as PNG ({error}): please report it", table.name))?;
    Ok(file)
}

pub fn dds(table: &Table, values: &[u16]) -> Result<Vec<u8>, String> {
    let parameters = NewDxgiParams {
        height: side(table.rows() / table.frames()),
        width: side(table.width),
        depth: None,
        format: if table.channels() == 2 { DxgiFormat::R16G16_UNorm } else { DxgiFormat::R16_UNorm },
        mipmap_levels: None,
        array_layers: (table.frames() > 1).then(|| side(table.frames())),
        caps2: None,
        is_cubemap: false,
        resource_dimension: D3D10ResourceDimension::Texture2D,
        alpha_mode: AlphaMode::Unknown,
    };
    let mut file = Vec::new();
    let written = Dds::new_dxgi(parameters).and_then(|mut dds| {
        dds.data = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        dds.write(&mut file)
    });
    written.map_err(|error| format!("{} is not encoded as DDS ({error}): please report it", table.name))?;
    Ok(file)
}

#[allow(clippy::cast_possible_truncation, reason = "sides of tables")]
fn side(length: usize) -> u32 {
    length as u32
}
