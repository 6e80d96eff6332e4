//! What the tests of samplers share: every sampler of the crate in one list, and masks that need no table.
use std::sync::LazyLock;

use bluedither::{Keys, ScalarMask, VectorMask, sobol, unit};

use crate::analysis::random::Random;

/// Side of the masks and of the images below.
pub(crate) const SIZE: usize = 64;

/// The ends of the range of every argument.
pub(crate) const EXTREMES: [u32; 5] = [0, 1, 0x7fff_ffff, 0x8000_0000, u32::MAX];

/// Correlations over 64² pixels of independent numbers scatter by 1/64; five times that never happens.
pub(crate) const NO_CORRELATION: f64 = 0.08;

static SCALAR: LazyLock<ScalarMask<SIZE>> = LazyLock::new(|| {
    let mut ranks: Vec<u16> = (0..4096).collect();
    Random::new(11).shuffle(&mut ranks);
    ScalarMask::new(core::array::from_fn(|y| core::array::from_fn(|x| ranks[y * SIZE + x])))
});

static VECTOR: LazyLock<VectorMask<2, SIZE>> = LazyLock::new(|| {
    let mut pairs: Vec<[u16; 2]> = (0..4096).map(|i| sobol::point(i).map(|v| (v >> 20) as u16)).collect();
    Random::new(12).shuffle(&mut pairs);
    VectorMask::new(core::array::from_fn(|y| core::array::from_fn(|x| pairs[y * SIZE + x])))
});

static KEYS: LazyLock<Keys<SIZE>> = LazyLock::new(|| {
    let mut random = Random::new(13);
    let digits: Vec<[u16; 2]> = (0..SIZE * SIZE).map(|_| [random.bits_32() as u16, random.bits_32() as u16]).collect();
    Keys::from_slice(&digits).expect("one for every pixel")
});

/// Random keys.
pub(crate) fn keys() -> &'static Keys<SIZE> {
    &KEYS
}

/// A random permutation of the ranks.
pub(crate) fn scalar_mask() -> &'static ScalarMask<SIZE> {
    &SCALAR
}

/// The first 4096 Sobol points in random places.
pub(crate) fn vector_mask() -> &'static VectorMask<2, SIZE> {
    &VECTOR
}

/// Calls `$body` with `$sampler` bound to each sampler of this crate, made from a seed and a number of samples per
/// pixel; `$name` is its name. A new sampler is a line here; then every promise of the call shape is tested of it.
macro_rules! for_every_sampler {
    ($seed:expr, $spp:expr, |$name:ident, $sampler:ident| $body:block) => {{
        let (seed, spp): (u32, u32) = ($seed, $spp);
        let dithered = bluedither::Dithered::with_masks(crate::common::scalar_mask(), crate::common::vector_mask(), seed);
        for_every_sampler! { @each |$name, $sampler| $body
            "white" => bluedither::White::with_spp(seed, spp),
            "net, progressive" => bluedither::Sampler::new(seed),
            "net" => bluedither::Sampler::with_spp(seed, spp),
            "global" => dithered,
            "lattice" => dithered.on_lattice(),
            "single strata" => dithered.stratified_1d(spp),
            "strata" => dithered.stratified(spp),
            "keys" => bluedither::Keyed::with_keys(crate::common::keys(), seed),
            #[cfg(feature = "lattice-64")]
            "baked lattice" => bluedither::Dithered::lattice(seed),
            #[cfg(feature = "keys-64")]
            "baked keys" => bluedither::Keyed::with_spp(seed, spp),
            #[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
            "baked" => bluedither::Dithered::new(seed),
            #[cfg(all(feature = "threshold-64", feature = "offset-2d-64"))]
            "baked, strata" => bluedither::Dithered::with_spp(seed, spp),
        }
    }};
    (@each |$name:ident, $sampler:ident| $body:block $($(#[$condition:meta])* $text:literal => $made:expr,)*) => {
        $(
            $(#[$condition])*
            {
                let ($name, $sampler) = ($text, $made);
                $body
            }
        )*
    };
}
pub(crate) use for_every_sampler;

/// Calls `$body` with the constant `$D`, the numbers of a draw, at 1, 2, …, 8.
macro_rules! for_every_length {
    (|$D:ident| $body:block) => {
        for_every_length! { @each |$D| $body 1 2 3 4 5 6 7 8 }
    };
    (@each |$D:ident| $body:block $($length:literal)*) => {
        $({
            const $D: usize = $length;
            $body
        })*
    };
}
pub(crate) use for_every_length;

/// Pearson's correlation.
pub(crate) fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let product: f64 = a.iter().zip(b).map(|(x, y)| (x - ma) * (y - mb)).sum();
    let square = |v: &[f64], m: f64| v.iter().map(|x| (x - m) * (x - m)).sum::<f64>();
    product / (square(a, ma) * square(b, mb)).sqrt()
}

/// One number of every pixel of a square image.
pub(crate) fn image(size: usize, value: impl Fn(u32, u32) -> u32) -> Vec<f64> {
    let size = size as u32;
    (0..size * size).map(|p| unit::to_f64(value(p % size, p / size))).collect()
}
