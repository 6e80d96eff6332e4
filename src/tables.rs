//! The one place that embeds what build.rs baked. A table exists where its feature is on.

use crate::mask::{ScalarMask, VectorMask};

include!(concat!(env!("OUT_DIR"), "/tables.rs"));
