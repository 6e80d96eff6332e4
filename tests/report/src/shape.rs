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
    /// Samples from `first` on, many at once.
    fn fill_1(&self, pixel: Self::Pixel, domain: u32, first: u32, out: &mut [[f32; 1]]);
    fn fill_2(&self, pixel: Self::Pixel, domain: u32, first: u32, out: &mut [[f32; 2]]);
    fn fill_4(&self, pixel: Self::Pixel, domain: u32, first: u32, out: &mut [[f32; 4]]);
}

/// A measurement, done with whichever sampler is chosen by name.
pub trait Task {
    type Output;
    fn run(&self, sampler: &impl Sampler) -> Self::Output;
}

/// A sampler made of its methods: `draws` and `fills` are those of 1, 2 and 4 numbers.
#[derive(Debug)]
pub struct Shape<M, P, Make, Pixel, Draws, Fills> {
    make: Make,
    pixel: Pixel,
    draws: Draws,
    fills: Fills,
    types: PhantomData<fn() -> (M, P)>,
}

#[allow(clippy::too_many_arguments, clippy::type_complexity, reason = "the methods of a shape, written by one macro")]
/// A macro gives the closures in this order; each one's types follow from those before.
pub fn shape<M, P, Make, Pixel, D1, D2, D4, F1, F2, F4>(
    make: Make,
    pixel: Pixel,
    draw_1: D1,
    draw_2: D2,
    draw_4: D4,
    fill_1: F1,
    fill_2: F2,
    fill_4: F4,
) -> Shape<M, P, Make, Pixel, (D1, D2, D4), (F1, F2, F4)>
where
    Make: Fn(u32, u32) -> M + Sync,
    Pixel: Fn(&M, u32, u32, u32) -> P + Sync,
    D1: Fn(P, u32, u32) -> [f32; 1] + Sync,
    D2: Fn(P, u32, u32) -> [f32; 2] + Sync,
    D4: Fn(P, u32, u32) -> [f32; 4] + Sync,
    F1: Fn(P, u32, u32, &mut [[f32; 1]]) + Sync,
    F2: Fn(P, u32, u32, &mut [[f32; 2]]) + Sync,
    F4: Fn(P, u32, u32, &mut [[f32; 4]]) + Sync,
{
    Shape { make, pixel, draws: (draw_1, draw_2, draw_4), fills: (fill_1, fill_2, fill_4), types: PhantomData }
}

impl<M, P, Make, Pixel, D1, D2, D4, F1, F2, F4> Sampler for Shape<M, P, Make, Pixel, (D1, D2, D4), (F1, F2, F4)>
where
    M: Sync,
    P: Copy,
    Make: Fn(u32, u32) -> M + Sync,
    Pixel: Fn(&M, u32, u32, u32) -> P + Sync,
    D1: Fn(P, u32, u32) -> [f32; 1] + Sync,
    D2: Fn(P, u32, u32) -> [f32; 2] + Sync,
    D4: Fn(P, u32, u32) -> [f32; 4] + Sync,
    F1: Fn(P, u32, u32, &mut [[f32; 1]]) + Sync,
    F2: Fn(P, u32, u32, &mut [[f32; 2]]) + Sync,
    F4: Fn(P, u32, u32, &mut [[f32; 4]]) + Sync,
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
        (self.draws.0)(pixel, domain, index)
    }

    #[inline]
    fn draw_2(&self, pixel: P, domain: u32, index: u32) -> [f32; 2] {
        (self.draws.1)(pixel, domain, index)
    }

    #[inline]
    fn draw_4(&self, pixel: P, domain: u32, index: u32) -> [f32; 4] {
        (self.draws.2)(pixel, domain, index)
    }

    #[inline]
    fn fill_1(&self, pixel: P, domain: u32, first: u32, out: &mut [[f32; 1]]) {
        (self.fills.0)(pixel, domain, first, out);
    }

    #[inline]
    fn fill_2(&self, pixel: P, domain: u32, first: u32, out: &mut [[f32; 2]]) {
        (self.fills.1)(pixel, domain, first, out);
    }

    #[inline]
    fn fill_4(&self, pixel: P, domain: u32, first: u32, out: &mut [[f32; 4]]) {
        (self.fills.2)(pixel, domain, first, out);
    }
}
