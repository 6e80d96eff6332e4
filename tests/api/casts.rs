//! Samples of every type, and patterns of them, cast to bytes for an upload.
#![cfg(feature = "bytemuck")]

use bluedither::White;

#[test]
fn samples_of_every_type_cast_to_bytes_and_back() {
    let pixel = White::new(1).pixel(2, 3, 4);
    let pairs: Vec<[f32; 2]> = (0..5).map(|index| pixel.draw::<2>(0, index)).collect();
    let fixed: Vec<[u32; 3]> = (0..5).map(|index| pixel.draw_fx::<3>(0, index)).collect();
    assert_eq!(bytemuck::cast_slice::<_, u8>(&pairs).len(), 5 * 2 * 4);
    assert_eq!(bytemuck::cast_slice::<u8, [f32; 2]>(bytemuck::cast_slice(&pairs)), pairs);
    assert_eq!(bytemuck::bytes_of(&fixed[1])[..4], fixed[1][0].to_ne_bytes());
    assert_eq!(bytemuck::cast_slice::<u8, [u32; 3]>(bytemuck::cast_slice(&fixed)), fixed);
}

#[cfg(feature = "pattern")]
#[test]
fn a_pattern_casts_as_a_whole() {
    let pixel = White::new(1).pixel(2, 3, 4);
    let pattern = pixel.pattern::<4, 8>(0, 8);
    let bytes: &[u8] = bytemuck::cast_slice(&pattern);
    assert_eq!(bytes.len(), 8 * 4 * 4);
    assert_eq!(bytes[16..20], pixel.draw::<4>(0, 1)[0].to_ne_bytes());
}
