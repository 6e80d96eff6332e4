//! The one place that embeds what build.rs baked. A table exists where its feature is on.

#[allow(unused_imports, reason = "without a feature of keys there are none")]
use crate::keys::Keys;
#[allow(unused_imports, reason = "without a mask feature there is no mask")]
use crate::mask::{ScalarMask, VectorMask};

#[allow(unused_imports, reason = "without a Sobol feature there are no directions")]
use crate::sobol::Directions;

pub use crate::effort::Effort;

include!(concat!(env!("OUT_DIR"), "/tables.rs"));
