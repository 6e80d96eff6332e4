//! The `openqmc-rs` package, a port of OpenQMC (Academy Software Foundation): samplers that are joint in four
//! dimensions, their errors spread as blue noise by tables of 256×256 pixels.

use bluedither::hash;
use core::fmt::Debug;

/// One of the package's samplers.
pub trait Kind: Copy + Debug + Send + Sync {
    fn new(x: i32, y: i32, frame: i32, index: i32) -> Self;
    fn draw(self, domain: i32) -> [f32; 4];
}

macro_rules! kinds {
    ($($kind:ident)*) => {
        $(impl Kind for openqmc::$kind {
            #[inline]
            fn new(x: i32, y: i32, frame: i32, index: i32) -> Self {
                Self::new(x, y, frame, index)
            }

            #[inline]
            fn draw(self, domain: i32) -> [f32; 4] {
                self.new_domain(domain).draw_sample_f32()
            }
        })*
    };
}
kinds! { SobolBnSampler LatticeBnSampler PmjBnSampler }

/// It has no seed but the frame's number, and no domain of more than four dimensions: here one has two of them.
#[derive(Clone, Copy, Debug)]
pub struct OpenQmc<K> {
    seed: u32,
    kind: core::marker::PhantomData<K>,
}

#[derive(Clone, Copy, Debug)]
pub struct OpenQmcPixel<K> {
    at: [i32; 3],
    kind: core::marker::PhantomData<K>,
}

impl<K: Kind> OpenQmc<K> {
    pub const fn new(seed: u32) -> Self {
        Self { seed, kind: core::marker::PhantomData }
    }

    #[inline]
    pub const fn pixel(&self, x: u32, y: u32, frame: u32) -> OpenQmcPixel<K> {
        // Positive, and with room for what the package adds.
        let frame = hash::combine(self.seed, frame) >> 2;
        OpenQmcPixel { at: [x.cast_signed(), y.cast_signed(), frame.cast_signed()], kind: self.kind }
    }
}

impl<K: Kind> OpenQmcPixel<K> {
    /// Up to 65536 samples.
    #[inline]
    pub fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
        let [x, y, frame] = self.at;
        let root = K::new(x, y, frame, (index & 0xffff).cast_signed());
        let mut out = [0.0; D];
        for (part, out) in (2 * domain..).zip(out.chunks_mut(4)) {
            out.copy_from_slice(&root.draw(part.cast_signed())[..out.len()]);
        }
        out
    }

    super::fill!();
}
