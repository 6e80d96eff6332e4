//! From recipes to tables. Used by build.rs, tests and examples; the library sees only what it wrote.
//!
//! Data flows one way: inputs (`tables/`) and a recipe → ranks → digest, quality, text. Integers only where a rank
//! depends on it.

pub mod anneal;
pub mod digest;
pub mod directions;
pub mod embed;
pub mod features;
pub mod filter;
pub mod inputs;
pub mod keys;
pub mod net;
pub mod quality;
pub mod recipe;
pub mod record;
pub mod retarget;
pub mod sequence;
pub mod void_and_cluster;
