//! What a row is made of.

/// The samples of one row, channels interleaved: grey, or red, green, blue.
///
/// A slice of `u8` or `u16` converts by itself; 10 and 12 bits lie in the lower bits of a `u16`, and larger numbers
/// count as white.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Samples<'a> {
    /// 0..=255.
    U8(&'a [u8]),
    /// 0..=1023.
    U10(&'a [u16]),
    /// 0..=4095.
    U12(&'a [u16]),
    /// 0..=65535.
    U16(&'a [u16]),
    /// 0 to 1, taken to the nearest of 65,536 values; what lies outside is black or white, and NaN is black.
    #[cfg(feature = "float")]
    F32(&'a [f32]),
}

impl Samples<'_> {
    /// How many samples, not pixels.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self {
            Self::U8(samples) => samples.len(),
            Self::U10(samples) | Self::U12(samples) | Self::U16(samples) => samples.len(),
            #[cfg(feature = "float")]
            Self::F32(samples) => samples.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Bits of a sample once it is read.
    pub(super) const fn bits(&self) -> u32 {
        match self {
            Self::U8(_) => 8,
            Self::U10(_) => 10,
            Self::U12(_) => 12,
            Self::U16(_) => 16,
            #[cfg(feature = "float")]
            Self::F32(_) => 16,
        }
    }

    /// The samples from `start` on, black where the row has ended.
    #[inline]
    pub(super) fn read(&self, start: usize, into: &mut [u16]) {
        match self {
            Self::U8(samples) => copy(samples, start, into, u16::from),
            Self::U10(samples) | Self::U12(samples) | Self::U16(samples) => copy(samples, start, into, |sample| sample),
            #[cfg(feature = "float")]
            Self::F32(samples) => copy(samples, start, into, from_f32),
        }
    }
}

impl<'a> From<&'a [u8]> for Samples<'a> {
    fn from(samples: &'a [u8]) -> Self {
        Self::U8(samples)
    }
}

impl<'a, const N: usize> From<&'a [u8; N]> for Samples<'a> {
    fn from(samples: &'a [u8; N]) -> Self {
        Self::U8(samples)
    }
}

impl<'a> From<&'a [u16]> for Samples<'a> {
    fn from(samples: &'a [u16]) -> Self {
        Self::U16(samples)
    }
}

impl<'a, const N: usize> From<&'a [u16; N]> for Samples<'a> {
    fn from(samples: &'a [u16; N]) -> Self {
        Self::U16(samples)
    }
}

#[cfg(feature = "float")]
impl<'a> From<&'a [f32]> for Samples<'a> {
    fn from(samples: &'a [f32]) -> Self {
        Self::F32(samples)
    }
}

#[cfg(feature = "float")]
impl<'a, const N: usize> From<&'a [f32; N]> for Samples<'a> {
    fn from(samples: &'a [f32; N]) -> Self {
        Self::F32(samples)
    }
}

#[inline]
fn copy<T: Copy>(samples: &[T], start: usize, into: &mut [u16], convert: impl Fn(T) -> u16) {
    let samples = samples.get(start..).unwrap_or_default();
    let (head, tail) = into.split_at_mut(into.len().min(samples.len()));
    head.iter_mut().zip(samples).for_each(|(into, &sample)| *into = convert(sample));
    tail.fill(0);
}

/// To the nearest; `as` saturates, and takes NaN to 0.
#[cfg(feature = "float")]
#[inline]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturation is the clamp")]
fn from_f32(sample: f32) -> u16 {
    (sample * 65535.0 + 0.5) as u16
}
