//! A random base pattern moved by a blue-noise mask: what Georgiev and Fajardo 2016 warn of. Every pixel has the same
//! unstratified points, so that blueness comes from the mask alone.

use super::draws;
use bluedither::tables::OFFSET_2D_64;
use bluedither::{hash, shift, torus, unit};

#[derive(Clone, Copy, Debug)]
pub struct RandomPattern {
    seed: u32,
}

#[derive(Clone, Copy, Debug)]
pub struct RandomPatternPixel {
    seed: u32,
    x: u32,
    y: u32,
}

impl RandomPattern {
    pub const fn new(seed: u32) -> Self {
        Self { seed }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> RandomPatternPixel {
        RandomPatternPixel { seed: hash::combine(self.seed, frame), x, y }
    }
}

impl RandomPatternPixel {
    #[inline]
    fn pair(self, pair: u32, index: u32) -> [f32; 2] {
        let [dx, dy] = torus::offset(self.seed, pair, 0, 0, 6);
        let point = hash::combine(hash::combine(self.seed, pair), index);
        let offset = OFFSET_2D_64.value_fx(self.x.wrapping_add(dx), self.y.wrapping_add(dy));
        unit::to_f32s(shift::global([point, hash::mix(point)], offset))
    }
}

draws!(RandomPatternPixel);
