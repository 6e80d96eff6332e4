//! Everything else that takes slices, sizes or floats.

use super::input::Input;
use bluedither::dither::{ordered, quantise};
use bluedither::{
    Dithered, Keyed, Keys, Sampler, ScalarMask, VectorMask, White, candidate, lattice, shift, sobol, strata, torus,
    unit,
};

static VECTOR: VectorMask<2, 2> = VectorMask::new([[[0, 3], [1, 2]], [[2, 1], [3, 0]]]);
static SCALAR: ScalarMask<2> = ScalarMask::new([[0, 3], [1, 2]]);
static KEYS: Keys<2> = Keys::new([[[1, 2], [3, 4]]; 2]);

/// Levels, and counts of strata and lattices.
pub(crate) fn values(input: &mut Input<'_>) {
    let dither = super::rows::dither(input);
    let [value, max, levels] = [input.half(), input.half(), input.half()];
    let [a, b, c] = [input.word(), input.word(), input.word()];
    let highest = levels.saturating_sub(1);
    assert!(dither.level(a, b, c, value, max, levels) <= highest);
    assert!(quantise::level(value, max, levels, a) <= highest);
    assert!(quantise::level_triangular(value, max, levels, a) <= highest);
    assert!(quantise::value(value, max, levels) <= max);
    assert!(ordered::value_fx(a, b, c) > 0);
    #[cfg(feature = "gamma")]
    assert!(bluedither::dither::gamma::level(value, max, levels, a) <= highest);

    let count = b.max(1);
    assert!(strata::permute(a, b, c) < count && strata::turn(a, b, c) < count);
    // Rounded down: the first value of a cell may fall just below it.
    let cell = (u64::from(strata::place_1d(a, b, c)) * u64::from(count)) >> 32;
    assert!((cell..=cell + 1).contains(&u64::from(a % count)));
    _ = (strata::place_2d(a, b, [c, a]), shift::stratified_2d(a, b, [c, a], [b, c]), lattice::fixed(a, b, c));
    let numbers = [a, b, c, a ^ b, a ^ c];
    let shorter = input.length(5, 5);
    _ = (sobol::directions(a, &numbers[..shorter]), sobol::dimension(a, b), sobol::directions(b, &[c; 40]));
    let place = torus::offset(a, b, c, a, c);
    assert!(c >= 32 || place.iter().all(|&place| u64::from(place) < 1 << c), "{place:?} in a tile of 2^{c}");
}

/// Fills of any length by any numbers: they are the single draws.
pub(crate) fn samplers(input: &mut Input<'_>) {
    let [seed, spp, x, y, frame] = core::array::from_fn(|_| input.word());
    let [domain, index] = [input.word(), input.word()];
    let length = input.length(17, 40);
    macro_rules! filled {
        ($sampler:expr) => {{
            let (mut numbers, mut row) = ([[9; 7]; 40], [[9.0; 8]; 40]);
            let sampler = $sampler;
            sampler.pixel(x, y, frame).fill_fx(domain, index, &mut numbers[..length]);
            sampler.fill_row(x, y, frame, domain, index, &mut row[..length]);
            for k in 0..length.min(40) {
                let step = k as u32;
                let number = sampler.pixel(x, y, frame).draw_fx::<7>(domain, index.wrapping_add(step));
                let of_row = sampler.pixel(x.wrapping_add(step), y, frame).draw::<8>(domain, index);
                assert_eq!((numbers[k], row[k]), (number, of_row));
                assert!(row[k].iter().all(|v| (0.0..1.0).contains(v)));
            }
            #[cfg(feature = "pattern")]
            assert_eq!(sampler.pixel(x, y, frame).pattern::<1, 8>(domain, spp).len(), spp.min(8) as usize);
        }};
    }
    match input.byte() % 7 {
        0 => filled!(Sampler::with_spp(seed, spp)),
        1 => filled!(Sampler::new(seed)),
        2 => filled!(Dithered::with_masks(&SCALAR, &VECTOR, seed).stratified(spp)),
        3 => filled!(Dithered::with_masks(&SCALAR, &VECTOR, seed)),
        4 => filled!(Dithered::with_masks(&SCALAR, &VECTOR, seed).on_lattice()),
        5 => filled!(Keyed::with_keys(&KEYS, seed)),
        _ => filled!(White::with_spp(seed, spp)),
    }
}

/// Tables of any length and content: taken if they fit, and refused else.
pub(crate) fn tables(input: &mut Input<'_>) {
    let length = input.length(16, 40);
    let ranks: Vec<u16> = (0..length).map(|_| u16::from(input.byte() % 17)).collect();
    let fits = ranks.len() == 16 && ranks.iter().all(|&rank| rank < 16);
    assert_eq!(ScalarMask::<4>::from_slice(&ranks).is_some(), fits);
    let pairs: Vec<[u16; 2]> = ranks.iter().map(|&rank| [rank, rank]).collect();
    assert_eq!(VectorMask::<2, 4>::from_slice(&pairs).is_some(), fits);
    let keys = Keys::<4>::from_slice(&pairs);
    assert_eq!(keys.is_some(), pairs.len() == 16);
    _ = keys.map(|keys| keys.key(input.word(), input.word()));
}

/// Rows of best candidates beside rows that are shorter: no panic, and the same row whatever stood there.
pub(crate) fn candidates(input: &mut Input<'_>) {
    let (above, mut row) = ([[[input.word(); 2]; 12]; 2], [[7; 2]; 12]);
    let [far, near, length] = [(); 3].map(|()| input.length(9, 12));
    let (seed, y, mut again) = (input.word(), input.word(), [[8; 2]; 12]);
    candidate::fill_row(seed, y, [&above[0][..far], &above[1][..near]], &mut row[..length]);
    candidate::fill_row(seed, y, [&above[0][..far], &above[1][..near]], &mut again[..length]);
    assert_eq!(row[..length], again[..length]);
}

/// Seeds of pictures of any size: none is lost.
#[cfg(feature = "seed-permutation")]
pub(crate) fn seeds(input: &mut Input<'_>) {
    use bluedither::frames::seeds::{Rows, permute, retarget, sort};
    let (length, frame) = (input.length(100, 200), input.word());
    let all: Vec<u32> = (0..200).collect();
    let mut seeds = all.clone();
    let of_estimates = input.length(length, 200);
    let estimates: Vec<f32> = (0..of_estimates).map(|_| input.float()).collect();
    let width = if input.byte() < 128 { u32::from(input.byte() % 32) } else { input.word() };
    let rows = Rows { width, first: input.word() };
    match input.byte() % 5 {
        0 => sort::<2>(&mut seeds[..length], &estimates, rows, frame),
        1 => sort::<4>(&mut seeds[..length], &estimates, rows, frame),
        2 => sort::<8>(&mut seeds[..length], &estimates, rows, frame),
        3 => retarget(&mut seeds[..length], rows, frame),
        _ => permute::<8>(&mut seeds[..length], &estimates, width, frame),
    }
    seeds.sort_unstable();
    assert_eq!(seeds, all, "a seed is lost");
}

#[cfg(not(feature = "seed-permutation"))]
pub(crate) fn seeds(_: &mut Input<'_>) {}

/// Floats of any kind, and rectangles anywhere.
pub(crate) fn floats(input: &mut Input<'_>) {
    let u = [input.float(), input.float()];
    assert!(unit::to_f32(unit::from_f32(u[0])) < 1.0);
    #[cfg(feature = "warp")]
    {
        use bluedither::warp;
        let close = |vector: &[f32]| vector.iter().map(|c| c * c).sum::<f32>();
        assert!(close(&warp::disk(u)) < 1.00001);
        for direction in [warp::sphere(u), warp::cosine_hemisphere(u), warp::uniform_hemisphere(u)] {
            assert!((close(&direction) - 1.0).abs() < 1e-4, "{direction:?} of {u:?}");
        }
        assert!(warp::triangle(u).iter().all(|part| (0.0..=1.0).contains(part)));
        assert!(warp::gaussian(u).iter().all(|number| number.abs() < 6.8));
    }
    #[cfg(feature = "embedded-graphics")]
    {
        use bluedither::dither::target::DitherTarget;
        use embedded_graphics::mock_display::MockDisplay;
        use embedded_graphics::pixelcolor::{BinaryColor, Rgb888};
        use embedded_graphics::prelude::*;
        use embedded_graphics::primitives::Rectangle;
        let mut display = MockDisplay::<BinaryColor>::new();
        display.set_allow_out_of_bounds_drawing(true);
        display.set_allow_overdraw(true);
        let dither = super::rows::dither(input);
        let at = Point::new(input.word() as i32, input.word() as i32);
        let area = Rectangle::new(at, Size::new(input.word(), input.word()));
        let mut screen = DitherTarget::new(&mut display, dither);
        let color = Rgb888::new(input.byte(), input.byte(), input.byte());
        screen.fill_solid(&area, color).expect("infallible");
        screen.draw_iter([Pixel(at, color)]).expect("infallible");
        // As many colours as are given, which may be fewer than the area has pixels.
        screen.fill_contiguous(&area, [color; 5]).expect("infallible");
    }
}
