//! Domains, frames and components have nothing to do with each other: over the pixels of one sample, and over the
//! samples of one pixel.

use crate::common::{NO_CORRELATION, SIZE, correlation, for_every_sampler, image};
use bluedither::unit;

#[test]
fn domains_frames_and_components_are_decorrelated() {
    // With many samples also one from the middle, whose number has its highest bit set: bits of an order and of a
    // scramble that cancel there would show.
    for (spp, index) in [(1, 0), (4, 0), (8, 4), (16, 8), (64, 32)] {
        for_every_sampler!(2, spp, |name, sampler| {
            // The first samples of two domains of the net may be related over one block of 4² pixels: it takes many of
            // them to see that nothing is left in the mean.
            let size = if name.starts_with("net") { 512 } else { SIZE };
            // The baked masks are blue noise, whose neighbours a few pixels apart are related a little.
            let bound = if name.starts_with("baked") { 2.0 * NO_CORRELATION } else { NO_CORRELATION };
            let at = |domain, frame| image(size, |x, y| sampler.pixel(x, y, frame).draw_fx::<2>(domain, index)[0]);
            let single = |domain, frame| image(size, |x, y| sampler.pixel(x, y, frame).draw_fx::<1>(domain, index)[0]);
            let (pair_here, single_here) = (at(0, 0), single(0, 0));
            for k in 1..=16 {
                for (what, other) in [("domain", (k, 0)), ("frame", (0, k))] {
                    // Its frames complete each other.
                    if what == "frame" && name.starts_with("net") {
                        continue;
                    }
                    let r = correlation(&pair_here, &at(other.0, other.1));
                    assert!(r.abs() < bound, "{name}, pair, {spp} spp, {what} {k}: {r}");
                    let r = correlation(&single_here, &single(other.0, other.1));
                    assert!(r.abs() < bound, "{name}, single, {spp} spp, {what} {k}: {r}");
                }
            }
            let component = |k: usize| image(size, |x, y| sampler.pixel(x, y, 0).draw_fx::<8>(0, index)[k]);
            let components: [_; 8] = core::array::from_fn(component);
            // Those of the net are blue together: less than unrelated in a picture, never alike.
            for a in 1..8 {
                for b in 0..a {
                    let r = correlation(&components[a], &components[b]);
                    assert!(r.abs() < bound, "{name}, {spp} spp, components {a} and {b}: {r}");
                }
            }
        });
    }
}

#[test]
fn samples_of_one_pixel_are_decorrelated() {
    // Over the samples of one pixel, two domains, two frames or two components of a draw must fill their joint square:
    // two Owen scrambles of one sequence in one order would fill two quarters of it, in every pixel alike.
    for spp in [64, 100, 256] {
        for_every_sampler!(2, spp, |name, sampler| {
            assert_no_joint_structure(name, spp, |frame, domain, index| {
                let pixel = sampler.pixel(1, 2, frame);
                (pixel.draw_fx::<1>(domain, index), pixel.draw_fx::<8>(domain, index))
            });
        });
    }
}

/// The mean square correlation of pairs of series is what random orders have, 1/(n−1), or some two of it, which nets
/// have.
fn assert_no_joint_structure(name: &str, spp: u32, draw: impl Fn(u32, u32, u32) -> ([u32; 1], [u32; 8])) {
    let joint = name.starts_with("net");
    let series = |frame, domain| -> [Vec<f64>; 9] {
        let all: Vec<_> = (0..spp).map(|index| draw(frame, domain, index)).collect();
        core::array::from_fn(|k| {
            all.iter().map(|(single, all)| unit::to_f64(if k == 8 { single[0] } else { all[k] })).collect()
        })
    };
    let here = series(0, 0);
    let mut squares = [0.0; 11];
    const OTHERS: u32 = 1600;
    for k in 1..=OTHERS {
        let (domain, frame) = (series(0, k), series(k, 0));
        let pairs = [
            (&here[0], &domain[0]),
            (&here[1], &domain[1]),
            (&here[8], &domain[8]),
            (&here[0], &frame[0]),
            (&here[8], &frame[8]),
            (&domain[0], &domain[2]),
            (&domain[1], &domain[3]),
            (&domain[0], &domain[4]),
            (&domain[2], &domain[6]),
            (&domain[1], &domain[7]),
            (&domain[4], &domain[6]),
        ];
        // Numbers and frames of one net complete each other.
        let pairs = if joint { &pairs[..3] } else { &pairs[..] };
        pairs.iter().zip(&mut squares).for_each(|((a, b), sum)| *sum += correlation(a, b).powi(2) / f64::from(OTHERS));
    }
    let worst = squares.iter().fold(0.0, |worst: f64, &square| worst.max(square)) * f64::from(spp - 1);
    assert!(worst < 3.0, "{name}, {spp} samples: mean square correlations {squares:.3?}");
}

/// Two domains over frames: the error of the mean product is that of independent numbers, or of nets in random orders.
/// An order of samples and one of frames double its square at most, each. Domains that went through their frames in
/// step would keep all of it: 38 times.
#[test]
fn domains_meet_over_frames_as_if_at_random() {
    const FRAMES: u32 = 64;
    const PIXELS: u32 = 2048;
    for spp in [1, 4] {
        for_every_sampler!(3, spp, |name, sampler| {
            let error = |x: u32| {
                let product = |frame, index| {
                    let pixel = sampler.pixel(5 * x, 3 * x, frame);
                    let at = |domain| unit::to_f64(pixel.draw_fx::<2>(domain, index)[0]) - 0.5;
                    at(2 * x) * at(2 * x + 1)
                };
                let all = (0..FRAMES).flat_map(|frame| (0..spp).map(move |index| (frame, index)));
                all.map(|(frame, index)| product(frame, index)).sum::<f64>() / f64::from(FRAMES * spp)
            };
            let mean_square = (0..PIXELS).map(|x| error(x).powi(2)).sum::<f64>() / f64::from(PIXELS);
            let independent = 1.0 / 144.0 / f64::from(FRAMES * spp);
            assert!(mean_square < 4.0 * independent, "{name}, {spp} spp: {}", mean_square / independent);
        });
    }
}
