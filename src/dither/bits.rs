//! Grey to 1 bit: a comparison a pixel, packed to bits by whatever the machine is good at.
//!
//! Dead ends, on baseline x86-64: gathering the signs of words of eight pixels by a product, adding up weights of a
//! byte by a product, masks bit by bit in hope of one instruction for sixteen: all slower; transposing two to sixteen
//! matrices at once: no faster.
#![allow(clippy::cast_possible_truncation, reason = "thresholds that are below 255, and single bits")]
#![allow(clippy::needless_range_loop, reason = "fixed arrays side by side: that is what vectorises")]

use super::Dither;
use super::kernel::{RUN, whole};

/// Two levels of one channel of 8 bits: a comparison a pixel, packed to bits.
pub(super) fn row(dither: &Dither<'_>, y: u32, samples: &[u8], dst: &mut [u8]) {
    let (mut thresholds, mut last) = ([0; RUN], [0; RUN]);
    for (run, (samples, dst)) in samples.chunks(RUN).zip(dst.chunks_mut(RUN / 8)).enumerate() {
        if run == 0 || !dither.repeats() {
            thresholds = dither.run((run * RUN) as u32, y, 0, 255).map(|threshold| threshold as u8);
        }
        if let Ok(samples) = whole(samples, &mut last).try_into() {
            let bits = bits(samples, &thresholds);
            match <&mut [u8; RUN / 8]>::try_from(&mut *dst) {
                Ok(dst) => *dst = bits,
                Err(_) => dst.iter_mut().zip(bits).for_each(|(dst, bits)| *dst = bits),
            }
        }
    }
}

/// One bit a sample: whether it is above its threshold. Without vectors: five instructions.
#[cfg(any(target_arch = "arm", target_arch = "riscv32"))]
#[inline]
fn bits(samples: &[u8; RUN], thresholds: &[u8; RUN]) -> [u8; RUN / 8] {
    let mut bytes = [0; RUN / 8];
    let runs = samples.chunks_exact(8).zip(thresholds.chunks_exact(8));
    for (byte, (samples, thresholds)) in bytes.iter_mut().zip(runs) {
        let mut bits = 0;
        for k in 0..8 {
            // The sign of the difference.
            bits = (bits << 1) | (u32::from(thresholds[k]).wrapping_sub(u32::from(samples[k])) >> 31);
        }
        *byte = bits as u8;
    }
    bytes
}

/// One bit a sample: whether it is above its threshold.
///
/// Every place gathers a bit from each block of eight; what comes out is an 8×8 matrix of bits, to be transposed.
#[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
#[inline]
fn bits(samples: &[u8; RUN], thresholds: &[u8; RUN]) -> [u8; RUN / 8] {
    const BLOCK: [u8; RUN] = {
        let mut block = [0; RUN];
        let mut i = 0;
        while i < RUN {
            block[i] = 1 << (i / 8);
            i += 1;
        }
        block
    };
    let mut above = [0; RUN];
    for i in 0..RUN {
        above[i] = if samples[i] > thresholds[i] { BLOCK[i] } else { 0 };
    }
    let mut columns = 0;
    for block in above.chunks_exact(8) {
        let mut eight = [0; 8];
        eight.copy_from_slice(block);
        columns |= u64::from_le_bytes(eight);
    }
    transposed(columns.swap_bytes()).to_le_bytes()
}

/// The transpose of an 8×8 matrix of bits (H. Warren, "Hacker's Delight", 7-3): blocks of 1, 2 and 4 change places.
#[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
#[inline]
const fn transposed(matrix: u64) -> u64 {
    let swapped = (matrix ^ (matrix >> 7)) & 0x00aa_00aa_00aa_00aa;
    let matrix = matrix ^ swapped ^ (swapped << 7);
    let swapped = (matrix ^ (matrix >> 14)) & 0x0000_cccc_0000_cccc;
    let matrix = matrix ^ swapped ^ (swapped << 14);
    let swapped = (matrix ^ (matrix >> 28)) & 0x0000_0000_f0f0_f0f0;
    matrix ^ swapped ^ (swapped << 28)
}
