//! Plain white noise: the PCG hash of Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020. The floor of cost.

use super::draws;
use bluedither::unit;

/// Independent uniform numbers, without any stratification.
#[derive(Clone, Copy, Debug)]
pub struct Pcg {
    seed: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct PcgPixel {
    state: u32,
}

impl Pcg {
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> PcgPixel {
        PcgPixel { state: hash(x.wrapping_add(hash(y.wrapping_add(hash(frame.wrapping_add(hash(self.seed))))))) }
    }
}

impl PcgPixel {
    #[inline]
    const fn pair(self, pair: u32, index: u32) -> [f32; 2] {
        // Numbers of a pixel are 2²⁰ samples of 2¹¹ pairs.
        let first = self.state.wrapping_add((index << 12).wrapping_add(2 * pair).wrapping_mul(0x9e37_79b1));
        [unit::to_f32(hash(first)), unit::to_f32(hash(first.wrapping_add(0x9e37_79b1)))]
    }
}

draws!(PcgPixel);

#[inline]
const fn hash(input: u32) -> u32 {
    let state = input.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    word >> 22 ^ word
}
