//! Arguments made of bytes, the ends of every range more often than others.

/// What is left of the bytes.
pub(crate) struct Input<'b> {
    bytes: &'b [u8],
}

impl<'b> Input<'b> {
    pub(crate) const fn new(bytes: &'b [u8]) -> Self {
        Self { bytes }
    }

    /// The next byte; after the last zeros.
    pub(crate) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.bytes.split_first() else { return 0 };
        self.bytes = rest;
        first
    }

    fn bits(&mut self) -> u32 {
        u32::from_le_bytes([self.byte(), self.byte(), self.byte(), self.byte()])
    }

    /// Any number.
    pub(crate) fn word(&mut self) -> u32 {
        match self.byte() % 8 {
            0 => 0,
            1 => u32::MAX,
            2 => 1 << 31,
            3 => i32::MAX as u32,
            4 => 1 << (self.byte() % 32),
            5 => u32::from(self.byte()),
            _ => self.bits(),
        }
    }

    pub(crate) fn half(&mut self) -> u16 {
        let word = self.word();
        (word ^ (word >> 16)) as u16
    }

    /// Any float: NaN, infinite, denormal, negative ones too.
    pub(crate) fn float(&mut self) -> f32 {
        const ODD: [f32; 8] =
            [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, 1.0, f32::MAX, f32::MIN_POSITIVE, 1.0 - f32::EPSILON];
        match self.byte() {
            k @ 0..64 => ODD[usize::from(k) % 8],
            64..128 => self.bits() as f32 / u32::MAX as f32,
            _ => f32::from_bits(self.bits()),
        }
    }

    /// A length up to `most`, often 0, near to a run's end or `fit` and one more or less.
    pub(crate) fn length(&mut self, fit: usize, most: usize) -> usize {
        let length = match self.byte() % 8 {
            0 => 0,
            1 => fit.saturating_sub(1),
            2 => fit + 1,
            3..6 => fit,
            6 => 62 + usize::from(self.byte()) % 5,
            _ => usize::from(self.byte()),
        };
        length.min(most)
    }
}
