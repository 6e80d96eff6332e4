//! Runs of 64 pixels: thresholds made ready in fixed arrays, then loops that compilers turn into vector code.
#![allow(clippy::cast_possible_truncation, reason = "places in a run, and levels that are below 256")]
#![allow(clippy::needless_range_loop, reason = "fixed arrays side by side: that is what vectorises")]

use super::{CHANNELS, Dither, Rule, Samples, Thresholds, ordered, quantise};
use crate::{hash, torus};

/// Pixels in a run.
pub(super) const RUN: usize = 64;

/// The levels of a run.
pub(super) type Levels<const C: usize> = [[u8; C]; RUN];

/// What is added before the division, so that a value rises where it exceeds the threshold: `max` − ⌊threshold ·
/// `max`⌋.
type Bias<T, const C: usize> = [[T; C]; RUN];

impl Dither<'_> {
    /// Whether one run of thresholds serves the whole row.
    pub(super) const fn repeats(&self) -> bool {
        match self.thresholds {
            Thresholds::Constant(_) => true,
            Thresholds::Random(_) => false,
            Thresholds::Ordered { size_log2 } | Thresholds::Mask { size_log2, .. } => 1 << size_log2 <= RUN,
        }
    }

    /// ⌊threshold · `max`⌋ for the pixels of a run: [`threshold_fx`](Self::threshold_fx), with everything but x taken
    /// out of the loop. A whole call, so that the loops over pixels are compiled on their own.
    #[inline(never)]
    pub(super) fn run(&self, x: u32, y: u32, channel: usize, max: u32) -> [u16; RUN] {
        let [place_x, place_y] = self.places[channel % CHANNELS];
        let (x, y) = (x.wrapping_add(self.origin[0]), y.wrapping_add(self.origin[1]));
        let (shifted_x, shifted_y) = (x.wrapping_add(place_x), y.wrapping_add(place_y));
        let mut run = [0; RUN];
        match self.thresholds {
            Thresholds::Constant(threshold) => run = [quantise::scaled(threshold, max) as u16; RUN],
            Thresholds::Random(_) => {
                let row = hash::combine(place_x, y);
                for i in 0..RUN {
                    run[i] = quantise::scaled(hash::combine(row, x.wrapping_add(i as u32)), max) as u16;
                }
            }
            Thresholds::Ordered { size_log2 } => {
                for i in 0..RUN {
                    let threshold = ordered::value_fx(shifted_x.wrapping_add(i as u32), shifted_y, size_log2);
                    run[i] = quantise::scaled(threshold, max) as u16;
                }
            }
            Thresholds::Mask { ranks, size_log2 } => {
                let size = 1 << size_log2;
                let start = (torus::wrap(shifted_y, size) as usize) << size_log2;
                let row = ranks.get(start..).unwrap_or_default();
                for i in 0..RUN {
                    let column = torus::wrap(shifted_x.wrapping_add(i as u32), size) as usize;
                    let threshold = crate::mask::value_fx(row.get(column).copied().unwrap_or(0), size_log2);
                    run[i] = quantise::scaled(threshold, max) as u16;
                }
            }
        }
        run
    }
}

/// A row of samples, run by run: its levels, packed into `N` numbers a run. `dst` ends where the row ends.
pub(super) fn row<T: Copy, const C: usize, const N: usize>(
    dither: &Dither<'_>,
    y: u32,
    samples: Samples<'_>,
    levels: [u16; C],
    dst: &mut [T],
    pack: impl Fn(&Levels<C>, &mut [T; N]),
) {
    let runs = dst.chunks_mut(N);
    match (samples, dither.rule) {
        (Samples::U8(samples), Rule::Plain) => row_8(dither, y, samples, levels, runs, pack),
        _ => row_16(dither, y, samples, levels, runs, pack),
    }
}

/// 8 bits: all in 16-bit lanes.
#[inline]
fn row_8<'d, T: Copy + 'd, const C: usize, const N: usize>(
    dither: &Dither<'_>,
    y: u32,
    samples: &[u8],
    levels: [u16; C],
    runs: impl Iterator<Item = &'d mut [T]>,
    pack: impl Fn(&Levels<C>, &mut [T; N]),
) {
    let steps = [levels.map(|levels| levels.saturating_sub(1)); RUN];
    let (mut bias, mut found, mut last) = ([[0; C]; RUN], [[0; C]; RUN], [[0; C]; RUN]);
    for (run, (samples, dst)) in samples.chunks(C * RUN).zip(runs).enumerate() {
        if run == 0 || !dither.repeats() {
            biases(dither, (run * RUN) as u32, y, &mut bias);
        }
        let whole = whole(samples, last.as_flattened_mut());
        quantise_8(whole, bias.as_flattened(), steps.as_flattened(), found.as_flattened_mut());
        put(&found, dst, &pack);
    }
}

/// The samples of a run; if the row has ended within it, in a buffer that goes on in black.
#[inline]
pub(super) fn whole<'s>(samples: &'s [u8], buffer: &'s mut [u8]) -> &'s [u8] {
    if samples.len() == buffer.len() {
        return samples;
    }
    buffer.fill(0);
    buffer.iter_mut().zip(samples).for_each(|(buffer, &sample)| *buffer = sample);
    buffer
}

/// (v·steps + bias − 1)/255, as (u + ⌊u/256⌋)/256 with u = v·steps + bias ≤ 255·256.
#[inline]
fn quantise_8(samples: &[u8], bias: &[u16], steps: &[u16], found: &mut [u8]) {
    for (((found, &bias), &steps), &sample) in found.iter_mut().zip(bias).zip(steps).zip(samples) {
        let sum = u16::from(sample).wrapping_mul(steps).wrapping_add(bias);
        *found = ((u32::from(sum) * 257) >> 16) as u8;
    }
}

/// 8 bits to 5, 6 and 5 in one number.
pub(super) fn row_565(dither: &Dither<'_>, y: u32, samples: &[u8], dst: &mut [u16]) {
    let (mut bias, mut parts, mut last) = ([[0u16; 3]; RUN], [[0u16; 3]; RUN], [0; 3 * RUN]);
    for (run, (samples, dst)) in samples.chunks(3 * RUN).zip(dst.chunks_mut(RUN)).enumerate() {
        if run == 0 || !dither.repeats() {
            biases(dither, (run * RUN) as u32, y, &mut bias);
        }
        let Ok(samples) = <&[u8; 3 * RUN]>::try_from(whole(samples, &mut last)) else { continue };
        weigh(samples, bias.as_flattened(), parts.as_flattened_mut());
        for (dst, &[r, g, b]) in dst.iter_mut().zip(&parts) {
            *dst = r | g | b;
        }
    }
}

/// As [`quantise_8`], moved to its place in the number.
#[inline]
fn weigh(samples: &[u8; 3 * RUN], bias: &[u16], parts: &mut [u16]) {
    const STEPS: [[u16; 3]; RUN] = [[31, 63, 31]; RUN];
    const PLACES: [[u16; 3]; RUN] = [[1 << 11, 1 << 5, 1]; RUN];
    let lanes = STEPS.as_flattened().iter().zip(PLACES.as_flattened()).zip(bias).zip(samples);
    for (part, (((&steps, &place), &bias), &sample)) in parts.iter_mut().zip(lanes) {
        let sum = u16::from(sample).wrapping_mul(steps).wrapping_add(bias);
        *part = (((u32::from(sum) * 257) >> 16) as u16).wrapping_mul(place);
    }
}

fn biases<const C: usize>(dither: &Dither<'_>, x: u32, y: u32, bias: &mut Bias<u16, C>) {
    for channel in 0..C {
        let thresholds = dither.run(x, y, channel, 255);
        for i in 0..RUN {
            bias[i][channel] = 255 - thresholds[i];
        }
    }
}

/// More bits, and everything that is not plain.
#[inline]
fn row_16<'d, T: Copy + 'd, const C: usize, const N: usize>(
    dither: &Dither<'_>,
    y: u32,
    samples: Samples<'_>,
    levels: [u16; C],
    runs: impl Iterator<Item = &'d mut [T]>,
    pack: impl Fn(&Levels<C>, &mut [T; N]),
) {
    let bits = samples.bits();
    let max = u16::MAX >> (16 - bits);
    let steps = levels.map(|levels| u32::from(levels.saturating_sub(1)));
    let plain = matches!(dither.rule, Rule::Plain);
    let (mut bias, mut found, mut read) = ([[0; C]; RUN], [[0; C]; RUN], [[0; C]; RUN]);
    for (run, dst) in runs.enumerate() {
        let x = (run * RUN) as u32;
        samples.read(run * C * RUN, read.as_flattened_mut());
        if plain && (run == 0 || !dither.repeats()) {
            for channel in 0..C {
                let thresholds = dither.run(x, y, channel, u32::from(max));
                for i in 0..RUN {
                    bias[i][channel] = u32::from(max - thresholds[i]);
                }
            }
        }
        if plain {
            quantise_16(&read, &bias, &steps, bits, &mut found);
        } else {
            for i in 0..RUN {
                for c in 0..C {
                    let x = x.wrapping_add(i as u32);
                    found[i][c] = dither.level(x, y, c as u32, read[i][c], max, levels[c]) as u8;
                }
            }
        }
        put(&found, dst, &pack);
    }
}

/// (v·steps + bias − 1)/max as in [`quantise_8`], `max` = 2^`bits` − 1.
#[inline]
fn quantise_16<const C: usize>(
    samples: &[[u16; C]; RUN],
    bias: &Bias<u32, C>,
    steps: &[u32; C],
    bits: u32,
    found: &mut Levels<C>,
) {
    let max = u16::MAX >> (16 - bits);
    for ((found, bias), samples) in found.iter_mut().zip(bias).zip(samples) {
        for c in 0..C {
            let sum = u32::from(samples[c].min(max)) * steps[c] + bias[c];
            found[c] = ((sum + (sum >> bits)) >> bits) as u8;
        }
    }
}

/// Packs a run; the last one of a row may be short.
#[inline]
fn put<T: Copy, const C: usize, const N: usize>(
    found: &Levels<C>,
    dst: &mut [T],
    pack: impl Fn(&Levels<C>, &mut [T; N]),
) {
    if let Ok(dst) = dst.try_into() {
        pack(found, dst);
    } else if let Some(&first) = dst.first() {
        let mut all = [first; N];
        pack(found, &mut all);
        dst.iter_mut().zip(all).for_each(|(dst, one)| *dst = one);
    }
}
