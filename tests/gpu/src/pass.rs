//! The seed permutation's compute pass, on whole pictures.

use bluedither::frames::seeds;
use bluedither::hash;
use bluedither::shader;
use bluedither::tables::THRESHOLD_64;

use crate::bind;
use crate::device::{Bound, Device, READ, UNIFORM, WRITE, Way};

pub const ENTRIES: [&str; 4] = ["bd_seeds_sort", "bd_seeds_retarget_0", "bd_seeds_retarget_1", "bd_seeds_retarget_2"];

/// Pictures of many sizes, frame after frame. The error tells the first that differs.
pub fn check(device: &Device) -> Result<(), String> {
    for way in [Way::Storage, Way::Texture] {
        for (width, height) in [(1, 1), (7, 3), (64, 64), (65, 9), (130, 75), (1, 40), (257, 2)] {
            for side in [2, 4, 8] {
                check_picture(device, way, width, height, side)?;
            }
        }
    }
    Ok(())
}

/// What the pass takes, and its text.
pub fn shader(way: Way) -> (Vec<Bound>, String) {
    let tables = vec![bind::seed_swaps(), bind::scalar(&THRESHOLD_64)];
    let texts = shader::SEEDS_PASS.texts().map(String::from);
    let text = texts.chain(tables.iter().map(|table| table.text(way))).collect();
    (tables, text)
}

fn check_picture(device: &Device, way: Way, width: u32, height: u32, side: u32) -> Result<(), String> {
    let (tables, text) = shader(way);
    let pixels = width * height;
    let mut rust: Vec<u32> = (0..pixels).map(hash::mix).collect();
    let held = device.buffer(&rust);
    for frame in [0, 1, 2, 3, 77, u32::MAX] {
        // A few pixels at the end have none.
        let estimates: Vec<u32> = (0..pixels - pixels / 9).map(|pixel| estimate(hash::combine(frame, pixel))).collect();
        let floats: Vec<f32> = estimates.iter().map(|&bits| f32::from_bits(bits)).collect();
        match side {
            2 => seeds::permute::<2>(&mut rust, &floats, width, frame),
            4 => seeds::permute::<4>(&mut rust, &floats, width, frame),
            _ => seeds::permute::<8>(&mut rust, &floats, width, frame),
        }
        let picture = device.buffer(&[width, height, frame, side]);
        let estimates = device.buffer(&estimates);
        let buffers = [(12, &picture, UNIFORM), (13, &held, WRITE), (14, &estimates, READ)];
        let groups = [(width + 11) / 8, (height + 11) / 8];
        device.dispatch(&text, &tables, way, &buffers, &ENTRIES, groups);
        let found = device.read(&held);
        let differ = rust.iter().zip(&found).filter(|(rust, found)| rust != found).count();
        if differ > 0 {
            return Err(format!(
                "bd_seeds_sort and bd_seeds_retarget: {differ} of {width}x{height} seeds differ in frame {frame}, blocks \
                 of {side} ({way:?})"
            ));
        }
    }
    Ok(())
}

/// The bits of a float: many alike, and some that are infinite or undefined.
fn estimate(random: u32) -> u32 {
    match random & 7 {
        0 => {
            [0, 1 << 31, 0x7f80_0000, 0xff80_0000, 0x7fff_ffff, 0xffc0_0000, 1, 0x8000_0001][(random >> 3 & 7) as usize]
        }
        1 | 2 => ((random >> 28) as f32).to_bits(),
        3 => random,
        _ => ((random >> 8) as f32 / 16_777_216.0).to_bits(),
    }
}
