//! Uses every public function family from a `no_std` program whose panic handler does not link: if the optimised code
//! could panic anywhere, this crate would not build.
//!
//! Build it with `RUSTFLAGS="-Clink-arg=-nostdlib -Clink-arg=-Wl,--no-undefined,--gc-sections"`.
#![no_std]

use bluedither::frames::seeds::{Rows, retarget, sort};
use bluedither::tables::{OFFSET_2D_64, THRESHOLD_64, THRESHOLD_OVER_TIME_32};
use bluedither::dither::{Samples, alpha, ordered, quantise};
use bluedither::keys_2019::Tables2019;
use bluedither::{
    Constant, Dither, Dithered, Keyed, Keys, Rank1, Sampler, White, ZOrder, candidate, hash, lattice, linear, shift, sobol, strata, torus, unit, warp, zorder,
};

unsafe extern "C" {
    /// Defined nowhere.
    fn the_optimised_code_can_panic() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    unsafe { the_optimised_code_can_panic() }
}

/// All samplers and both forms of offsets.
#[unsafe(no_mangle)]
pub extern "C" fn samplers(seed: u32, spp: u32, x: u32, y: u32, frame: u32, domain: u32, index: u32) -> f32 {
    let dithered = Dithered::with_spp(seed, spp);
    let mut sum = 0.0;
    let pixels = [dithered, Dithered::new(seed), dithered.global(), dithered.stratified(spp)];
    for pixel in pixels.map(|sampler| sampler.pixel(x, y, frame)) {
        sum += pixel.draw::<1>(domain, index)[0] + pixel.draw::<3>(domain, index)[2];
        sum += pixel.draw::<2>(domain, index)[1] + pixel.draw::<4>(domain, index)[3];
        sum += pixel.pattern::<2, 16>(domain, spp).iter().map(|point| point[0]).sum::<f32>();
    }
    let mut samples = [[0.0; 3]; 5];
    for pixel in [Sampler::new(seed), Sampler::with_spp(seed, spp)].map(|sampler| sampler.pixel(x, y, frame)) {
        sum += pixel.draw::<1>(domain, index)[0] + pixel.draw::<4>(domain, index)[3];
        pixel.fill(domain, index, &mut samples);
        sum += samples[4][2];
    }
    sum += ZOrder::new(seed).pixel(x, y, frame).draw::<4>(domain, index)[3];
    static KEYS: Keys<4> = Keys::new([[[1, 2], [3, 4], [5, 6], [7, 8]]; 4]);
    sum += Keyed::with_keys(&KEYS, seed).pixel(x, y, frame).draw::<4>(domain, index)[3];
    sum += Rank1::with_mask(&OFFSET_2D_64, seed).pixel(x, y, frame).draw::<4>(domain, index)[3];
    sum += White::new(seed).pixel(x, y, frame).draw::<4>(domain, index)[3];
    sum + Constant::with_spp(seed, spp).pixel(x, y, frame).draw::<4>(domain, index)[3]
}

/// Look-ups and bytes.
#[unsafe(no_mangle)]
pub extern "C" fn masks(x: u32, y: u32) -> f32 {
    let bytes = THRESHOLD_64.bytes().len() + OFFSET_2D_64.bytes().len();
    THRESHOLD_64.value(x, y) + OFFSET_2D_64.value(x, y)[1] + unit::to_f32(bytes as u32)
}

/// Tables of a caller's, of any length.
#[unsafe(no_mangle)]
pub extern "C" fn tables_of_2019(bytes: &[u8; 65_536], tile: &[u8; 131_072], x: u32, y: u32, a: u32, b: u32) -> f32 {
    Tables2019::from_slices(bytes, tile, tile).map_or(0.0, |tables| tables.value_f32(x, y, a, b))
}

/// One threshold: for looking at the machine code.
#[unsafe(no_mangle)]
pub extern "C" fn rank(x: u32, y: u32) -> u16 {
    THRESHOLD_64.rank(x, y)
}

/// Integer parts.
#[unsafe(no_mangle)]
pub extern "C" fn integers(a: u32, b: u32, c: u32) -> u32 {
    let mut sum = hash::combine(a, b) ^ hash::owen(a, b) ^ hash::shuffle(a, b);
    sum ^= sobol::dimension(a, b) ^ sobol::owen_point(a, b)[1] ^ torus::offset(a, b, c, a, b)[1];
    sum ^= strata::permute(a, b, c) ^ strata::turn(a, b, c) ^ strata::jittered_1d(a, b, c) ^ strata::jittered_2d(a, b, c)[1];
    sum ^= strata::regular_1d(a, b) ^ strata::regular_2d(a, b)[0] ^ shift::global([a, b], [b, c])[1];
    sum ^= shift::stratified_1d(a, b, c, c) ^ shift::stratified_2d(a, b, [c, a], [b, c])[0];
    sum ^= lattice::fixed(a, b, c) ^ lattice::extensible(a, b) ^ zorder::first_index(a) ^ hash::shuffle_rev(a, b);
    sum ^= hash::owen_4(a, b) ^ linear::digits(&[a; 10], b, c);
    sum ^ unit::from_f32(unit::to_f32(a)) ^ torus::wrap(a, b)
}

/// Rows of every format, with lengths that only the caller knows.
#[unsafe(no_mangle)]
pub extern "C" fn halftones(seed: u32, y: u32, samples: usize, room: usize, bytes: &mut [u8; 256]) -> u32 {
    let (source, mut words, mut levels) = (*bytes, [0; 99], [[0; 3]; 99]);
    let Some(source) = source.get(..samples) else { return 0 };
    let Some(dst) = bytes.get_mut(..room) else { return 0 };
    let mut errors = 0;
    for dither in [
        Dither::blue(&THRESHOLD_64).frame(seed).origin(seed, y),
        Dither::constant(seed),
        Dither::random(seed),
        Dither::ordered(seed).triangular(),
    ] {
        errors += dither.gray1_row(y, source, dst).is_err() as u32 + dither.gray2_row(y, source, dst).is_err() as u32;
        errors += dither.gray4_row(y, source, dst).is_err() as u32 + dither.rgb332_row(y, source, dst).is_err() as u32;
        errors += dither.rgb565_row(y, source, &mut words).is_err() as u32;
        errors += dither.rgb888_row(y, Samples::U10(&words), dst).is_err() as u32;
        errors += dither.levels_row(y, source, [seed as u16; 3], &mut levels).is_err() as u32;
        errors += dither.stencil_row(y, source, dst).is_err() as u32;
        errors += alpha::over_row(source, [1, 2, 3], &mut words).is_err() as u32;
        errors += u32::from(dither.level(y, seed, seed, seed as u16, y as u16, samples as u16));
    }
    errors + u32::from(quantise::value(seed as u16, y as u16, samples as u16)) + ordered::value_fx(seed, y, seed)
}

/// Warps.
#[unsafe(no_mangle)]
pub extern "C" fn warps(u: f32, v: f32) -> f32 {
    let u = [u, v];
    let flat = warp::disk(u)[0] + warp::triangle(u)[2] + warp::gaussian(u)[1];
    flat + warp::cosine_hemisphere(u)[2] + warp::uniform_hemisphere(u)[2] + warp::sphere(u)[2]
}

/// Rows of pixels, and fills of unknown length.
#[unsafe(no_mangle)]
pub extern "C" fn rows(seed: u32, spp: u32, x: u32, y: u32, domain: u32, index: u32, out: &mut [[f32; 4]; 9], n: usize) {
    static KEYS: Keys<4> = Keys::new([[[1, 2], [3, 4], [5, 6], [7, 8]]; 4]);
    let Some(out) = out.get_mut(..n) else { return };
    Sampler::with_spp(seed, spp).fill_row(x, y, 0, domain, index, out);
    ZOrder::new(seed).fill_row(x, y, 0, domain, index, out);
    White::new(seed).fill_row(x, y, 0, domain, index, out);
    Keyed::with_keys(&KEYS, seed).fill_row(x, y, 0, domain, index, out);
    Keyed::with_keys(&KEYS, seed).pixel(x, y, 0).fill(domain, index, out);
    Rank1::with_mask(&OFFSET_2D_64, seed).fill_row(x, y, 0, domain, index, out);
    Dithered::with_spp(seed, spp).stratified(spp).fill_row(x, y, 0, domain, index, out);
}

/// Over time, and best candidates.
#[unsafe(no_mangle)]
pub extern "C" fn frames(seeds: &mut [u32; 99], n: usize, estimates: &[f32; 99], width: u32, first: u32, frame: u32) -> u32 {
    let (Some(seeds), Some(estimates)) = (seeds.get_mut(..n), estimates.get(..n)) else { return 0 };
    let rows = Rows { width, first };
    sort::<2>(seeds, estimates, rows, frame);
    sort::<4>(seeds, estimates, rows, frame);
    sort::<8>(seeds, estimates, rows, frame);
    retarget(seeds, rows, frame);
    let (samples, _) = seeds.as_chunks_mut::<2>();
    candidate::fill_row(frame, first, [&[[1, 2]], &[]], samples);
    THRESHOLD_OVER_TIME_32.frame(frame).value_fx(width, first)
}
