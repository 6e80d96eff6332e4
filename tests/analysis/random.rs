//! Random numbers for tests: SplitMix64 (Steele, Lea and Flood 2014), written out so that its stream never changes.

/// Seeds of the evaluation, each the first of some: used by nothing that optimises, trains or tunes.
pub(crate) mod seeds {
    /// 1D smooth integrands.
    pub(crate) const SMOOTH_1D: u64 = 0x5e51_1000;
    /// 1D thresholds.
    pub(crate) const STEP_1D: u64 = 0x5e51_2000;
    /// The soft edges among the 2D smooth integrands.
    pub(crate) const SMOOTH_2D: u64 = 0x5e51_3000;
    /// 2D half-planes.
    pub(crate) const HALF_PLANE_2D: u64 = 0x5e51_4000;
    /// Shuffles and white noise of the analysis itself.
    pub(crate) const WHITE: u64 = 0x5e51_5000;
    /// Integrands of several dimensions, one a family from there on.
    pub(crate) const SEVERAL: u64 = 0x5e51_8000;
    /// The points that integrate what has no formula.
    pub(crate) const INTEGRATION: u64 = 0x5e51_9000;
}

/// A stream of random numbers.
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    /// The stream of a seed; streams of different seeds have nothing in common.
    pub(crate) fn new(seed: u64) -> Self {
        // Seeds that differ by a multiple of the increment would give one stream, shifted: mix first.
        let mut seeder = Self(seed);
        Self(seeder.bits())
    }

    /// 64 random bits.
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// 32 random bits.
    pub(crate) fn bits_32(&mut self) -> u32 {
        (self.bits() >> 32) as u32
    }

    /// Uniform in [0, 1).
    pub(crate) fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [low, high).
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Normal with mean 0 and variance 1 (Box and Muller 1958; the second number is dropped).
    pub(crate) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * libm::log(1.0 - self.uniform())).sqrt();
        radius * libm::cos(core::f64::consts::TAU * self.uniform())
    }

    /// Uniform in 0..count, by multiplication; the bias of 2⁻³² per value is far below any test here.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        ((u64::from(self.bits_32()) * count as u64) >> 32) as usize
    }

    /// Fisher–Yates: every order equally likely.
    pub(crate) fn shuffle<T>(&mut self, values: &mut [T]) {
        for last in (1..values.len()).rev() {
            let other = self.below(last + 1);
            values.swap(last, other);
        }
    }
}
