//! What is drawn through the dithering target, as ASCII pictures of `embedded-graphics`' mock display.

use bluedither::Dither;
use bluedither::dither::target::DitherTarget;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{PrimitiveStyle, Rectangle};

const BAYER_4: Dither<'static> = Dither::ordered(2);

/// A quarter, a half and three quarters of grey, by Bayer's matrix 0 8 2 10 / 12 4 14 6 / 3 11 1 9 / 15 7 13 5.
#[test]
fn greys_become_patterns() {
    let mut display = MockDisplay::<BinaryColor>::new();
    let mut screen = DitherTarget::new(&mut display, BAYER_4);
    for (k, luma) in [64, 128, 191].into_iter().enumerate() {
        let area = Rectangle::new(Point::new(4 * k as i32, 0), Size::new(4, 4));
        area.into_styled(PrimitiveStyle::with_fill(Gray8::new(luma))).draw(&mut screen).expect("infallible");
    }
    display.assert_pattern(&[
        "#.#.#.#.####", //
        ".....#.#.#.#",
        "#.#.#.#.####",
        ".....#.#.#.#",
    ]);
}

/// Three levels between black and white: values that are levels are not dithered.
#[test]
fn levels_stay() {
    let mut display = MockDisplay::<Gray2>::new();
    let mut screen = DitherTarget::new(&mut display, BAYER_4);
    let colors = [0, 85, 170, 255].map(Gray8::new);
    screen.fill_contiguous(&Rectangle::new(Point::zero(), Size::new(4, 1)), colors).expect("infallible");
    display.assert_pattern(&["0123"]);
}

/// The target draws pixel by pixel, runs of colours and solid areas alike.
#[test]
fn every_way_to_draw_gives_the_same() {
    let color = Rgb888::new(120, 33, 201);
    let area = Rectangle::new(Point::new(3, 5), Size::new(20, 17));
    let draw = |way: usize| {
        let mut display = MockDisplay::<Rgb565>::new();
        let mut screen = DitherTarget::new(&mut display, BAYER_4.frame(1));
        match way {
            0 => screen.draw_iter(area.points().map(|at| Pixel(at, color))),
            1 => screen.fill_contiguous(&area, area.points().map(|_| color)),
            _ => screen.fill_solid(&area, color),
        }
        .expect("infallible");
        display
    };
    draw(1).assert_eq(&draw(0));
    draw(2).assert_eq(&draw(0));
    let display = draw(0);
    for at in area.points() {
        let found = display.get_pixel(at).expect("drawn");
        let level = |channel, value, levels| {
            BAYER_4.frame(1).level(at.x as u32, at.y as u32, channel, value, 255, levels) as u8
        };
        assert_eq!(found, Rgb565::new(level(0, 120, 32), level(1, 33, 64), level(2, 201, 32)));
    }
}

/// What primaries weigh on a display of greys, ITU-R BT.709: .2126, .7152 and .0722 of 15, by a threshold of one half.
#[test]
fn greys_of_primaries() {
    let mut display = MockDisplay::<Gray4>::new();
    let mut screen = DitherTarget::new(&mut display, Dither::constant(1 << 31));
    let colors = [Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE, Rgb888::YELLOW];
    screen.fill_contiguous(&Rectangle::new(Point::zero(), Size::new(4, 1)), colors).expect("infallible");
    display.assert_pattern(&["3B1E"]);
}

/// A grey on a display of colours is what the RGB of that grey is.
#[test]
fn greys_on_displays_of_colours() {
    let area = Rectangle::new(Point::new(1, 2), Size::new(9, 9));
    let (mut gray, mut rgb) = (MockDisplay::<Rgb565>::new(), MockDisplay::<Rgb565>::new());
    let colors = (0..81).map(|k| 3 * k);
    let mut screen = DitherTarget::new(&mut gray, BAYER_4);
    screen.fill_contiguous(&area, colors.clone().map(Gray8::new)).expect("infallible");
    let mut screen = DitherTarget::new(&mut rgb, BAYER_4);
    screen.fill_contiguous(&area, colors.map(|k| Rgb888::new(k, k, k))).expect("infallible");
    gray.assert_eq(&rgb);
}

#[test]
fn black_white_and_what_lies_outside() {
    let mut display = MockDisplay::<BinaryColor>::new();
    display.set_allow_out_of_bounds_drawing(true);
    display.set_allow_overdraw(true);
    let mut screen = DitherTarget::new(&mut display, Dither::random(3));
    assert_eq!(screen.bounding_box().size, Size::new(64, 64));
    let all = Rectangle::new(Point::new(-1000, -1000), Size::new(1 << 20, 1 << 20));
    screen.fill_solid(&all, Rgb888::WHITE).expect("infallible");
    screen.fill_solid(&Rectangle::new(Point::zero(), Size::zero()), Rgb888::BLACK).expect("infallible");
    screen.draw_iter([Pixel(Point::new(-5, i32::MIN), Rgb888::WHITE)]).expect("infallible");
    assert!((0..64 * 64).all(|p| display.get_pixel(Point::new(p % 64, p / 64)) == Some(BinaryColor::On)));
    let mut screen = DitherTarget::new(&mut display, Dither::random(3));
    // Beyond the largest coordinate, to which only the display's last rows and columns belong.
    let huge = Rectangle::new(Point::new(32, 32), Size::new(u32::MAX, u32::MAX));
    screen.fill_solid(&huge, Rgb888::BLACK).expect("infallible");
    let at = |p: i32| Point::new(p % 64, p / 64);
    let lit = |p| BinaryColor::from(at(p).x < 32 || at(p).y < 32);
    assert!((0..64 * 64).all(|p| display.get_pixel(at(p)) == Some(lit(p))));
    let mut screen = DitherTarget::new(&mut display, Dither::random(3));
    screen.clear(Rgb888::BLACK).expect("infallible");
    assert!((0..64 * 64).all(|p| display.get_pixel(Point::new(p % 64, p / 64)) == Some(BinaryColor::Off)));
}
