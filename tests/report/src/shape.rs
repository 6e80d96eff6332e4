//! The call shape as a trait of this program's own, so that one measurement serves every sampler.
//!
//! The samplers share their methods' names and not a trait, so `Shape` takes the methods as closures, which the list in
//! `samplers.rs` writes out.

use std::marker::PhantomData;

/// What a measurement asks of a sampler.
pub trait Sampler: Sync {
    /// The sampler of one image.
    type Made: Sync;
    /// One pixel of it.
    type Pixel: Copy;
    fn make(&self, seed: u32, spp: u32) -> Self::Made;
    fn pixel(&self, made: &Self::Made, x: u32, y: u32, frame: u32) -> Self::Pixel;
    fn draw_1(&self, pixel: Self::Pixel, domain: u32, index: u32) -> [f32; 1];
    fn draw_2(&self, pixel: Self::Pixel, domain: u32, index: u32) -> [f32; 2];
    fn draw_4(&self, pixel: Self::Pixel, domain: u32, index: u32) -> [f32; 4];
}

/// A measurement, done with whichever sampler is chosen by name.
pub trait Task {
    type Output;
    fn run(&self, sampler: &impl Sampler) -> Self::Output;
}

/// A sampler made of its methods.
#[derive(Debug)]
pub struct Shape<M, P, Make, Pixel, One, Two, Four> {
    make: Make,
    pixel: Pixel,
    one: One,
    two: Two,
    four: Four,
    types: PhantomData<fn() -> (M, P)>,
}

/// A macro gives the closures in this order; each one's types follow from those before.
pub fn shape<M, P, Make, Pixel, One, Two, Four>(
    make: Make,
    pixel: Pixel,
    one: One,
    two: Two,
    four: Four,
) -> Shape<M, P, Make, Pixel, One, Two, Four>
where
    Make: Fn(u32, u32) -> M + Sync,
    Pixel: Fn(&M, u32, u32, u32) -> P + Sync,
    One: Fn(P, u32, u32) -> [f32; 1] + Sync,
    Two: Fn(P, u32, u32) -> [f32; 2] + Sync,
    Four: Fn(P, u32, u32) -> [f32; 4] + Sync,
{
    Shape { make, pixel, one, two, four, types: PhantomData }
}

impl<M, P, Make, Pixel, One, Two, Four> Sampler for Shape<M, P, Make, Pixel, One, Two, Four>
where
    M: Sync,
    P: Copy,
    Make: Fn(u32, u32) -> M + Sync,
    Pixel: Fn(&M, u32, u32, u32) -> P + Sync,
    One: Fn(P, u32, u32) -> [f32; 1] + Sync,
    Two: Fn(P, u32, u32) -> [f32; 2] + Sync,
    Four: Fn(P, u32, u32) -> [f32; 4] + Sync,
{
    type Made = M;
    type Pixel = P;

    #[inline]
    fn make(&self, seed: u32, spp: u32) -> M {
        (self.make)(seed, spp)
    }

    #[inline]
    fn pixel(&self, made: &M, x: u32, y: u32, frame: u32) -> P {
        (self.pixel)(made, x, y, frame)
    }

    #[inline]
    fn draw_1(&self, pixel: P, domain: u32, index: u32) -> [f32; 1] {
        (self.one)(pixel, domain, index)
    }

    #[inline]
    fn draw_2(&self, pixel: P, domain: u32, index: u32) -> [f32; 2] {
        (self.two)(pixel, domain, index)
    }

    #[inline]
    fn draw_4(&self, pixel: P, domain: u32, index: u32) -> [f32; 4] {
        (self.four)(pixel, domain, index)
    }
}
