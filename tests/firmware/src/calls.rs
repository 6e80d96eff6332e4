//! The calls whose cost the README states: code and constants that a program links for one of them alone, and the stack
//! that it takes.

use bluedither::frames::seeds;
use bluedither::tables::{THRESHOLD_32, THRESHOLD_64};
use bluedither::{Dither, Dithered, Keyed, Sampler, candidate, warp};

/// What calls read and write.
#[derive(Debug)]
pub struct Room {
    source: [u8; 192],
    wide: [u16; 192],
    bytes: [u8; 64],
    words: [u16; 64],
    numbers: [[u32; 2]; 8],
    floats: [[f32; 2]; 8],
    rows: [[[u32; 2]; 8]; 2],
    seeds: [u32; 64],
    estimates: [f32; 64],
}

impl Room {
    /// Something to read.
    #[must_use]
    pub fn new() -> Self {
        Self {
            source: core::array::from_fn(|k| k as u8),
            wide: core::array::from_fn(|k| k as u16 * 300),
            bytes: [0; 64],
            words: [0; 64],
            numbers: [[0; 2]; 8],
            floats: [[0.5; 2]; 8],
            rows: [[[9; 2]; 8]; 2],
            seeds: core::array::from_fn(|k| k as u32),
            estimates: core::array::from_fn(|k| 1.0 / (k + 1) as f32),
        }
    }
}

/// A call.
#[derive(Clone, Copy, Debug)]
pub struct Call {
    /// What the README calls it.
    pub name: &'static str,
    /// A word for it.
    pub key: &'static str,
    /// Whether it may link floating point.
    pub floats: bool,
    /// The call itself, for row or pixel `n`.
    pub work: fn(&mut Room, u32),
}

/// The call of that key: for programs of a single one.
#[must_use]
pub const fn named(key: &str) -> Call {
    let mut at = 0;
    while at < CALLS.len() {
        let (ours, wanted) = (CALLS[at].key.as_bytes(), key.as_bytes());
        let mut same = 0;
        while same < ours.len() && same < wanted.len() && ours[same] == wanted[same] {
            same += 1;
        }
        if same == ours.len() && same == wanted.len() {
            return CALLS[at];
        }
        at += 1;
    }
    panic!("no call has that key")
}

macro_rules! calls {
    ($($key:ident $kind:ident $name:literal |$room:ident, $n:ident| $work:expr;)*) => {
        $(
            fn $key($room: &mut Room, $n: u32) {
                $work;
            }
        )*

        /// All calls, the smallest displays first.
        pub const CALLS: &[Call] = &[$(
            Call { name: $name, key: stringify!($key), floats: calls!($kind), work: $key },
        )*];
    };
    (integer) => { false };
    (float) => { true };
}

calls! {
    rank integer "`ScalarMask::rank`, 32²" |room, n| room.words[0] = THRESHOLD_32.rank(n, 7);
    bayer integer "`gray1_row`, Bayer" |room, n|
        _ = Dither::ordered(3).gray1_row(n, &room.source, &mut room.bytes);
    gray1 integer "`gray1_row`, mask of 32²" |room, n|
        _ = Dither::blue(&THRESHOLD_32).gray1_row(n, &room.source, &mut room.bytes);
    gray4 integer "`gray4_row`, mask of 32²" |room, n|
        _ = Dither::blue(&THRESHOLD_32).gray4_row(n, &room.source[..128], &mut room.bytes);
    rgb565 integer "`rgb565_row`, mask of 32²" |room, n|
        _ = Dither::blue(&THRESHOLD_32).rgb565_row(n, &room.source, &mut room.words);
    rgb565_16 integer "the same, from 16 bits" |room, n|
        _ = Dither::blue(&THRESHOLD_32).rgb565_row(n, &room.wide, &mut room.words);
    rgb565_gamma integer "the same, from 8 bits in linear light" |room, n|
        _ = Dither::blue(&THRESHOLD_32).gamma().rgb565_row(n, &room.source, &mut room.words);
    level integer "`level`, one value, mask of 64²" |room, n|
        room.words[0] = Dither::blue(&THRESHOLD_64).level(n, 7, 0, room.wide[1], 1023, 4);
    sampler integer "`Sampler`, `draw_fx::<2>`" |room, n|
        room.numbers[0] = Sampler::with_spp(1, 4).pixel(n, 7, 0).draw_fx(0, n);
    sampler_fill integer "`Sampler`, `fill_fx::<2>`" |room, n|
        Sampler::with_spp(1, 4).pixel(n, 7, 0).fill_fx(0, 0, &mut room.numbers);
    keyed integer "`Keyed`, `draw_fx::<2>`" |room, n|
        room.numbers[0] = Keyed::new(1).pixel(n, 7, 0).draw_fx(0, n);
    dithered integer "`Dithered`, `draw_fx::<2>`" |room, n|
        room.numbers[0] = Dithered::new(1).pixel(n, 7, 0).draw_fx(0, n);
    candidate integer "`candidate::fill_row`" |room, n|
        candidate::fill_row(1, n, [&room.rows[0], &room.rows[1]], &mut room.numbers);
    seeds integer "`frames::seeds::permute::<8>`" |room, n|
        seeds::permute::<8>(&mut room.seeds, &room.estimates, 8, n);
    draw float "`Sampler`, `draw::<2>`: floats" |room, n|
        room.floats[0] = Sampler::with_spp(1, 4).pixel(n, 7, 0).draw(0, n);
    disk float "`warp::disk`: floats of `libm`" |room, _n| room.floats[0] = warp::disk(room.floats[1]);
}
