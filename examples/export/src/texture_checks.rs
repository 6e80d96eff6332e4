//! What decoders read from the textures is what the library looks up.

use crate::tables::{self, Kind, Table};
use crate::textures;
use bluedither::tables as library;

fn table(name: &str) -> Table {
    tables::named(&[name.into()]).expect("this build has it").remove(0)
}

/// Size, channels, bits and samples of a PNG.
fn decoded(file: &[u8]) -> ([u32; 2], png::ColorType, png::BitDepth, Vec<u8>) {
    let mut reader = png::Decoder::new(file).read_info().expect("a header");
    let mut samples = vec![0; reader.output_buffer_size()];
    let info = reader.next_frame(&mut samples).expect("a picture");
    ([info.width, info.height], info.color_type, info.bit_depth, samples)
}

#[test]
fn pngs_of_16_bits_hold_values() {
    let table = table("threshold-64");
    let file = textures::png(&table, &textures::values_16(&table)).expect("a file");
    let (size, color, depth, samples) = decoded(&file);
    assert_eq!((size, color, depth), ([64; 2], png::ColorType::Grayscale, png::BitDepth::Sixteen));
    for (place, sample) in (0u32..).zip(samples.chunks(2)) {
        let value = library::THRESHOLD_64.value_fx(place % 64, place / 64);
        assert_eq!(u32::from(u16::from_be_bytes([sample[0], sample[1]])), value >> 16, "pixel {place}");
    }
}

#[test]
fn two_channels_are_red_and_green() {
    let table = table("offset-2d-64");
    let file = textures::png(&table, &textures::values_8(&table)).expect("a file");
    let (size, color, depth, samples) = decoded(&file);
    assert_eq!((size, color, depth), ([64; 2], png::ColorType::Rgb, png::BitDepth::Eight));
    for (place, sample) in (0u32..).zip(samples.chunks(3)) {
        let value = library::OFFSET_2D_64.value_fx(place % 64, place / 64);
        assert_eq!([sample[0], sample[1], sample[2]].map(u32::from), [value[0] >> 24, value[1] >> 24, 0]);
    }
}

/// Centred: with (q + ½)/256 for level q the mean is ½ exactly, and every level occurs equally often.
#[test]
fn levels_of_8_bits_occur_equally_often() {
    for name in ["threshold-16", "threshold-64", "threshold-256", "offset-1d-64"] {
        let table = table(name);
        let mut counts = [0; 256];
        textures::values_8(&table).iter().for_each(|&level| counts[usize::from(level)] += 1);
        assert_eq!(counts, [table.numbers.len() / 256; 256], "{name}");
    }
}

#[test]
fn dds_holds_layers() {
    let table = table("threshold-over-time-32");
    let file = textures::dds(&table, &textures::values_16(&table)).expect("a file");
    let dds = ddsfile::Dds::read(&file[..]).expect("a DDS");
    assert_eq!((dds.get_width(), dds.get_height(), dds.get_num_array_layers()), (32, 32, 32));
    assert_eq!(dds.get_dxgi_format(), Some(ddsfile::DxgiFormat::R16_UNorm));
    for frame in 0..32 {
        let layer = dds.get_data(frame).expect("a layer");
        for (place, sample) in (0u32..).zip(layer.chunks(2)) {
            let value = library::THRESHOLD_OVER_TIME_32.frame(frame).value_fx(place % 32, place / 32);
            assert_eq!(u32::from(u16::from_le_bytes([sample[0], sample[1]])), value >> 16, "layer {frame}");
        }
    }
}

/// Digits, unchanged: keys have no values.
#[test]
fn keys_are_digits() {
    let table = table("keys-64");
    assert_eq!(table.kind, Kind::Keys);
    for (place, digits) in (0u32..).zip(textures::values_16(&table).chunks(2)) {
        let key = library::KEYS_64.key(place % 64, place / 64);
        assert_eq!([digits[0], digits[1]].map(u32::from), key.map(|key| key >> 16));
    }
}

/// What the manifest says is what the library's own record says.
#[test]
fn digests_are_as_recorded() {
    let recorded = include_str!("../../../tables/digests.txt");
    for table in tables::named(&[]).expect("all tables").iter().filter(|table| table.kind != Kind::Directions) {
        let digest = table.digest().expect("it is baked");
        let line = format!("{} {} {digest:016x}", library::EFFORT.name(), table.identifier());
        assert!(recorded.lines().any(|recorded| recorded == line), "{line}");
    }
}

#[test]
fn unknown_tables_are_refused_with_a_cure() {
    let line = tables::named(&["threshold-65".into()]).expect_err("there is none");
    assert!(line.contains("no table is named threshold-65") && line.contains("threshold-64"), "{line}");
}
