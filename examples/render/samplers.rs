//! The samplers that are compared, one line each, and the pixel loop that all of them run through.
//!
//! All samplers share one call shape without a trait, so the loop is a macro's: compiled once for each sampler.

use crate::arguments::Arguments;
use crate::candidates::Candidates;
use crate::film::Image;
use crate::masks::Masks;
use crate::scene::{Dimensions, Sample, Scene};
use bluedither::sampler::WhitePixel;
use bluedither::{Dithered, Sampler, White};

/// What the numbers are for: a domain has up to eight, which go together; lens, light and time here.
const CAMERA: u32 = 0;

/// One picture to render.
pub struct Job<'a> {
    pub scene: &'a Scene,
    pub masks: &'a Masks,
    pub dimensions: Dimensions,
    pub size: [u32; 2],
    pub spp: u32,
    pub arguments: &'a Arguments,
}

/// The fully correlated control: the same samples in every pixel, no noise and all bias, seen as banding.
struct Constant(White);

impl Constant {
    fn pixel(&self, _: u32, _: u32, frame: u32) -> WhitePixel {
        self.0.pixel(0, 0, frame)
    }
}

macro_rules! samplers {
    (|$masks:ident, $seed:ident, $spp:ident, $size:ident| $($(#[$condition:meta])* $name:literal => $sampler:expr,)*) => {
        /// All samplers, in the order of the sheets. A name that begins with a spectrum needs that annealed mask.
        pub const NAMES: &[&str] = &[$($(#[$condition])* $name),*];

        /// Renders the job with the sampler of that name.
        pub fn render(name: &str, job: &Job) -> Image {
            let ($masks, $seed, $spp, $size) = (job.masks, job.arguments.seed, job.spp, job.size);
            match name {
                $($(#[$condition])* $name => {
                    let sampler = $sampler;
                    Image::render(job.size, |x, y| {
                        let pixel = sampler.pixel(x, y, job.arguments.frame);
                        let mut sum = glam::Vec3A::ZERO;
                        for index in 0..job.spp {
                            let [u, v, a, b, time] = pixel.draw::<5>(CAMERA, index);
                            let sample = Sample { time, lens: [u, v], light: [a, b] };
                            sum += job.scene.radiance(x, y, sample.only(job.dimensions));
                        }
                        sum / job.spp as f32
                    })
                })*
                _ => unreachable!("names are checked when arguments are read"),
            }
        }
    };
}

samplers! { |masks, seed, spp, size|
    "constant" => Constant(White::with_spp(seed, spp)),
    "white" => White::with_spp(seed, spp),
    "best-candidate" => Candidates::new(seed, size, spp),
    "low-global" => masks.low().dithered(seed).global(),
    "low-stratified" => masks.low().dithered(seed).stratified(spp),
    "all-global" => masks.all().dithered(seed).global(),
    "all-stratified" => masks.all().dithered(seed).stratified(spp),
    "high-global" => masks.high().dithered(seed).global(),
    "high-stratified" => masks.high().dithered(seed).stratified(spp),
    #[cfg(feature = "lattice-64")]
    "lattice" => Dithered::lattice(seed),
    #[cfg(feature = "keys-64")]
    "keys" => bluedither::Keyed::with_spp(seed, spp),
    "dithered" => Dithered::with_spp(seed, spp),
    "sampler-progressive" => Sampler::new(seed),
    "sampler" => Sampler::with_spp(seed, spp),
}
