//! Rows of every format are their pixels; alpha, floats, and lengths that do not fit.

use bluedither::Dither;
use bluedither::dither::{RowError, Samples, alpha};

use super::{bit, kinds};

#[test]
fn rows_are_their_pixels() {
    for (name, dither) in kinds() {
        for width in [0usize, 1, 7, 8, 9, 63, 64, 65, 130, 200] {
            let eight: Vec<u8> = (0..3 * width).map(|i| (i * 37 + i / 5) as u8).collect();
            let wide: Vec<u16> = (0..3 * width).map(|i| (i * 2753 + i / 3) as u16).collect();
            for y in [0, 1, 77, u32::MAX] {
                check_row(name, dither, y, 255, &eight, Samples::U8(&eight));
                check_row(name, dither, y, 1023, &wide, Samples::U10(&wide));
                check_row(name, dither, y, 4095, &wide, Samples::U12(&wide));
                check_row(name, dither, y, 65535, &wide, Samples::U16(&wide));
                check_row("triangular", dither.triangular(), y, 255, &eight, Samples::U8(&eight));
                #[cfg(feature = "gamma")]
                check_row("gamma", dither.gamma(), y, 65535, &wide, Samples::U16(&wide));
                #[cfg(feature = "gamma")]
                check_row("gamma", dither.gamma(), y, 255, &eight, Samples::U8(&eight));
            }
        }
    }
}

/// All formats of one row against single pixels. The destinations are longer than needed: what is beyond must stay.
fn check_row<T: Copy + Into<u16>>(name: &str, dither: Dither<'_>, y: u32, max: u16, all: &[T], samples: Samples<'_>) {
    let width = all.len() / 3;
    let at = |p: usize, channel: u32, levels| dither.level(p as u32, y, channel, all[p].into(), max, levels);
    let rgb = |x: usize, levels: [u16; 3]| -> [u16; 3] {
        core::array::from_fn(|c| dither.level(x as u32, y, c as u32, all[3 * x + c].into(), max, levels[c]))
    };
    let mut bytes = vec![0xa5u8; 3 * width + 4];
    let gray = all.len();

    type Row<'a> = &'a dyn Fn(&mut [u8]) -> Result<(), RowError>;
    let rows: [(usize, Row<'_>); 3] = [
        (1, &|dst| dither.gray1_row(y, samples, dst)),
        (2, &|dst| dither.gray2_row(y, samples, dst)),
        (4, &|dst| dither.gray4_row(y, samples, dst)),
    ];
    for (bits, row) in rows {
        bytes.fill(0xa5);
        row(&mut bytes).expect("long enough");
        let used = (gray * bits).div_ceil(8);
        let mut naive = vec![0u8; used];
        for x in 0..gray {
            naive[x * bits / 8] |= (at(x, 0, 1 << bits) as u8) << (8 - bits - x * bits % 8);
        }
        assert_eq!(bytes[..used], naive, "{name}, row {y}: {gray} pixels of {bits} bits, source of {max}");
        assert!(bytes[used..].iter().all(|&byte| byte == 0xa5), "written beyond the row");
        if used > 0 {
            assert_eq!(row(&mut bytes[..used - 1]), Err(RowError::TooShort { needed: used, given: used - 1 }));
        }
    }
    bytes.fill(0xa5);
    dither.rgb332_row(y, samples, &mut bytes).expect("long enough");
    let mut words = vec![0xa5a5u16; width + 2];
    dither.rgb565_row(y, samples, &mut words).expect("long enough");
    let mut triples = vec![[9u8; 3]; width + 1];
    dither.levels_row(y, samples, [3, 17, 256], &mut triples).expect("long enough");
    for x in 0..width {
        let [r, g, b] = rgb(x, [8, 8, 4]);
        assert_eq!(u16::from(bytes[x]), r << 5 | g << 2 | b, "{name} 332 at {x}, {y} of {width}");
        let [r, g, b] = rgb(x, [32, 64, 32]);
        assert_eq!(words[x], r << 11 | g << 5 | b, "{name} 565 at {x}, {y} of {width}");
        assert_eq!(triples[x].map(u16::from), rgb(x, [3, 17, 256]), "{name} levels at {x}, {y} of {width}");
    }
    assert!(bytes[width] == 0xa5 && words[width] == 0xa5a5 && triples[width] == [9; 3], "written beyond the row");
    dither.rgb888_row(y, samples, &mut bytes).expect("long enough");
    for x in 0..width {
        assert_eq!([0, 1, 2].map(|c| u16::from(bytes[3 * x + c])), rgb(x, [256; 3]), "{name} 888 at {x}, {y}");
    }
}

#[test]
fn wrong_lengths_are_errors_and_write_nothing() {
    let dither = Dither::ordered(2);
    let mut words = [7; 3];
    assert_eq!(dither.rgb565_row(0, &[1u8; 10], &mut words), Err(RowError::PartOfAPixel { samples: 10, channels: 3 }));
    assert_eq!(dither.rgb565_row(0, &[1u8; 12], &mut words), Err(RowError::TooShort { needed: 4, given: 3 }));
    assert_eq!(dither.rgb565_row(0, &[1u16; 12], &mut words), Err(RowError::TooShort { needed: 4, given: 3 }));
    let rgba = [255; 7];
    assert_eq!(dither.stencil_row(0, &rgba, &mut [0]), Err(RowError::PartOfAPixel { samples: 7, channels: 4 }));
    assert_eq!(alpha::over_row(&rgba, [0; 3], &mut words), Err(RowError::PartOfAPixel { samples: 7, channels: 4 }));
    assert_eq!(alpha::over_row(&[9; 8], [0; 3], &mut words), Err(RowError::TooShort { needed: 6, given: 3 }));
    assert_eq!(words, [7; 3]);
    assert_eq!(dither.gray1_row(0, &[0u8; 0], &mut []), Ok(()), "an empty row");
    let line = RowError::TooShort { needed: 4, given: 3 }.to_string();
    assert_eq!(line, "the destination holds 3 numbers, and the row takes 4");
}

#[test]
fn alpha_blends_exactly_and_stencils() {
    for alpha in 0..=255u8 {
        for (front, back) in [(0, 255), (255, 0), (17, 200), (255, 255), (1, 0)] {
            let exact = (f64::from(front) * f64::from(alpha) + f64::from(back) * (255.0 - f64::from(alpha))) / 65025.0;
            let found = alpha::over([front, back, front, alpha], [back, back, front])[0];
            assert!((f64::from(found) - exact * 65535.0).abs() <= 0.5, "{front} over {back} by {alpha}");
        }
    }
    assert_eq!(alpha::over([255, 0, 9, 255], [1, 2, 3]), [65535, 0, 9 * 257]);
    assert_eq!(alpha::over([255, 0, 9, 0], [255, 2, 0]), [65535, 2 * 257, 0]);
    let (opaque, clear) = ([1, 2, 3, 255].repeat(20), [200, 200, 200, 0].repeat(20));
    for (_, dither) in kinds() {
        let mut bits = [0; 3];
        dither.stencil_row(5, &opaque, &mut bits).expect("long enough");
        assert_eq!(bits, [0xff, 0xff, 0xf0]);
        dither.stencil_row(5, &clear, &mut bits).expect("long enough");
        assert_eq!(bits, [0; 3]);
        let half = [0, 0, 0, 128].repeat(20);
        dither.stencil_row(5, &half, &mut bits).expect("long enough");
        assert!((0..20).all(|x| u16::from(bit(&bits, x)) == dither.level(x as u32, 5, 3, 128, 255, 2)));
        #[cfg(feature = "gamma")]
        {
            let mut in_light = [0; 3];
            dither.gamma().stencil_row(5, &half, &mut in_light).expect("long enough");
            assert_eq!(in_light, bits, "alpha is no light");
        }
    }
}

#[cfg(feature = "float")]
#[test]
fn floats_are_clamped_and_rounded() {
    let src = [f32::NAN, f32::NEG_INFINITY, -1.0, 0.0, -0.0, 1.0, 2.0, f32::INFINITY];
    for (_, dither) in kinds() {
        let mut bits = [0];
        dither.gray1_row(3, &src, &mut bits).expect("long enough");
        assert_eq!(bits, [0b0000_0111]);
    }
    let floats: Vec<f32> = (0..=65535u16).map(|v| f32::from(v) / 65535.0).collect();
    let ints: Vec<u16> = (0..=65535).collect();
    let (mut a, mut b) = (vec![0; 8192], vec![0; 8192]);
    let dither = Dither::ordered(6);
    dither.gray1_row(1, &floats[..], &mut a).expect("long enough");
    dither.gray1_row(1, &ints[..], &mut b).expect("long enough");
    assert_eq!(a, b);
}
