//! The call shape that all samplers share, and the samplers.
//!
//! ```
//! use bluedither::Sampler; // or any other: changing this one word compares two
//!
//! const CAMERA: u32 = 0; // a domain names what its numbers are for, which are blue together:
//! const LIGHT: u32 = 1; // different domains are decorrelated
//!
//! let (seed, spp, frame) = (1, 4, 0);
//! let sampler = Sampler::with_spp(seed, spp);
//! for (x, y) in [(0, 0), (1, 0)] {
//!     let pixel = sampler.pixel(x, y, frame);
//!     for index in 0..spp {
//!         let [u, v, t] = pixel.draw::<3>(CAMERA, index); // f32 in [0, 1); up to eight
//!         let [a, b] = pixel.draw::<2>(LIGHT, index);
//!         assert!(u < 1.0 && v < 1.0 && t < 1.0 && a < 1.0 && b < 1.0);
//!     }
//! }
//! ```

mod dithered;
mod keyed;
mod net;
mod padded;
mod row;
mod shape;
mod white;

pub use dithered::{Dithered, DitheredPixel};
pub use keyed::{Keyed, KeyedPixel};
pub use net::{Sampler, SamplerPixel};
pub use white::{White, WhitePixel};

use padded::{Pair, Single, domain_seed, padded, spread};
use row::{row_by_pixels, row_shape};
use shape::call_shape;

/// The lengths of a draw.
const fn assert_dimensions(count: usize) {
    assert!(count >= 1 && count <= 8, "a domain has 1 to 8 dimensions: draw more from further domains");
}

/// The upper half of a word and the lower one.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "halves of a word")]
const fn halves(word: u64) -> [u32; 2] {
    [(word >> 32) as u32, word as u32]
}
