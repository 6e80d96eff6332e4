//! Rows of any format, kind of sample and length, beside what must be true of them.

use super::input::Input;
use bluedither::dither::{RowError, Samples, alpha};
use bluedither::{Dither, ScalarMask};

static MASK: ScalarMask<16> = {
    let mut ranks = [[0; 16]; 16];
    let mut k = 0;
    while k < 256 {
        ranks[k / 16][k % 16] = (k * 37 % 256) as u16;
        k += 1;
    }
    ScalarMask::new(ranks)
};

/// Most samples of a row, and most numbers of a destination.
const MOST: usize = 300;

pub(crate) fn dither(input: &mut Input<'_>) -> Dither<'static> {
    let dither = match input.byte() % 4 {
        0 => Dither::constant(input.word()),
        1 => Dither::random(input.word()),
        2 => Dither::ordered(input.word()),
        _ => Dither::blue(&MASK),
    };
    let dither = dither.frame(input.word()).origin(input.word(), input.word());
    match input.byte() % 3 {
        0 => dither.triangular(),
        #[cfg(feature = "gamma")]
        1 => dither.gamma(),
        _ => dither,
    }
}

pub(crate) fn run(input: &mut Input<'_>) {
    let dither = dither(input);
    let y = input.word();
    let bytes: [u8; MOST] = core::array::from_fn(|k| (k * 91 + 7) as u8);
    let words: [u16; MOST] = core::array::from_fn(|k| (k * 9241 + 7) as u16);
    let near = 3 * usize::from(input.byte() % 90);
    let samples = input.length(near, MOST);
    let source = match input.byte() % 5 {
        0 => Samples::U8(&bytes[..samples]),
        1 => Samples::U10(&words[..samples]),
        2 => Samples::U12(&words[..samples]),
        #[cfg(feature = "float")]
        3 => {
            let floats: Vec<f32> = (0..samples).map(|_| input.float()).collect();
            return formats(input, dither, y, Samples::F32(&floats));
        }
        _ => Samples::U16(&words[..samples]),
    };
    formats(input, dither, y, source);
}

/// What a row of so many samples must return, if pixels have so many channels and the row takes so many numbers.
fn due(samples: usize, channels: usize, needed: usize, given: usize) -> Result<(), RowError> {
    if !samples.is_multiple_of(channels) {
        return Err(RowError::PartOfAPixel { samples, channels });
    }
    if given < needed { Err(RowError::TooShort { needed, given }) } else { Ok(()) }
}

/// Dithers into `given` numbers, and holds the outcome against what is due: nothing is written after an error, nor
/// beyond the row.
fn check<T: Copy + PartialEq + core::fmt::Debug>(
    [samples, channels, needed]: [usize; 3],
    given: usize,
    untouched: T,
    row: impl FnOnce(&mut [T]) -> Result<(), RowError>,
) {
    let mut numbers = [untouched; 3 * MOST];
    let done = row(&mut numbers[..given]);
    assert_eq!(done, due(samples, channels, needed, given));
    let written = if done.is_ok() { needed } else { 0 };
    assert!(numbers[written..].iter().all(|number| *number == untouched), "beyond the row");
    assert!(done.is_ok() || !done.map_or_else(|error| error.to_string(), |()| String::new()).is_empty());
}

fn formats(input: &mut Input<'_>, dither: Dither<'_>, y: u32, source: Samples<'_>) {
    let n = source.len();
    let format = input.byte() % 10;
    let needed = match format {
        0 => n.div_ceil(8),
        1 => n.div_ceil(4),
        2 => n.div_ceil(2),
        3..6 => n / 3,
        6 => n,
        7 => n / 4,
        8 => (n / 4).div_ceil(8),
        _ => n / 4 * 3,
    };
    let given = input.length(needed, 3 * MOST);
    // Where bytes are too few to tell, a pattern that a row hardly ever is.
    let bytes = 0xa5;
    let rgba: Vec<u8> = (0..n).map(|k| (k * 29) as u8).collect();
    let levels = [input.half(), input.half(), input.half(), input.half()];
    let [one, two, three, four] = [[n, 1, needed], [n, 2, n / 2], [n, 3, needed], [n, 4, needed]];
    match format {
        0 => check(one, given, bytes, |dst| dither.gray1_row(y, source, dst)),
        1 => check(one, given, bytes, |dst| dither.gray2_row(y, source, dst)),
        2 => check(one, given, bytes, |dst| dither.gray4_row(y, source, dst)),
        3 => check(three, given, bytes, |dst| dither.rgb332_row(y, source, dst)),
        4 => check(three, given, 0xa5a5, |dst| dither.rgb565_row(y, source, dst)),
        5 => check(three, given, [bytes; 3], |dst| dither.levels_row(y, source, [levels[0], levels[1], 256], dst)),
        6 if n.is_multiple_of(2) => {
            check(two, given, [bytes; 2], |dst| dither.levels_row(y, source, [levels[0], levels[1]], dst));
        }
        6 => check([n, 3, n], given, bytes, |dst| dither.rgb888_row(y, source, dst)),
        7 => check(four, given, [bytes; 4], |dst| dither.levels_row(y, source, levels, dst)),
        8 => check(four, given, bytes, |dst| dither.stencil_row(y, &rgba, dst)),
        _ => check(four, given, 0xa5a5, |dst| alpha::over_row(&rgba, [1, 2, 3], dst)),
    }
}
