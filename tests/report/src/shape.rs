//! The call shape as traits of this program's own, so that one measurement serves every sampler.
//!
//! The samplers share their methods' names and not a trait; `shapes!` says for which types they do.

/// One pixel of a sampler.
pub trait Pixel: Copy {
    fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D];
    /// Samples from `first` on, many at once.
    fn fill<const D: usize>(self, domain: u32, first: u32, out: &mut [[f32; D]]);
}

/// What a measurement asks of a sampler.
pub trait Sampler: Sync {
    type Pixel: Pixel;
    fn pixel(&self, x: u32, y: u32, frame: u32) -> Self::Pixel;
    /// Sample `index` of a row of pixels, from (x, y) on.
    #[inline]
    fn row<const D: usize>(&self, [x, y]: [u32; 2], domain: u32, index: u32, out: &mut [[f32; D]]) {
        for (x, out) in (x..).zip(out) {
            *out = self.pixel(x, y, 0).draw(domain, index);
        }
    }
}

/// A measurement, done with whichever sampler is chosen by name: `make(seed, spp)` is the sampler of one image.
pub trait Task {
    type Output;
    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> Self::Output;
}

/// Samplers and their pixels, each by the methods of its own; with `rows`, those for rows as well.
macro_rules! shapes {
    ($($sampler:ty, $pixel:ty $(, $rows:ident)?;)*) => {
        $(impl $crate::shape::Sampler for $sampler {
            type Pixel = $pixel;
            #[inline(always)]
            fn pixel(&self, x: u32, y: u32, frame: u32) -> $pixel {
                self.pixel(x, y, frame)
            }
            $(#[inline(always)]
            fn row<const D: usize>(&self, [x, y]: [u32; 2], domain: u32, index: u32, out: &mut [[f32; D]]) {
                let $rows = self;
                $rows.fill_row(x, y, 0, domain, index, out);
            })?
        })*
    };
}
pub(crate) use shapes;

/// Pixels, once each: several samplers may share one.
macro_rules! pixels {
    ($($pixel:ty;)*) => {
        $(impl $crate::shape::Pixel for $pixel {
            #[inline(always)]
            fn draw<const D: usize>(self, domain: u32, index: u32) -> [f32; D] {
                self.draw(domain, index)
            }
            #[inline(always)]
            fn fill<const D: usize>(self, domain: u32, first: u32, out: &mut [[f32; D]]) {
                self.fill(domain, first, out);
            }
        })*
    };
}
pub(crate) use pixels;
