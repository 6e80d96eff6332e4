//! The same functions for shaders: WGSL text to paste, and the tables' bytes for its bindings.
//!
//! A [`Parts`] names what a shader uses, and gives each text once, with all that it needs. Names begin with `bd_`, then come
//! the Rust module or type and the function: `hash::mix` is `bd_hash_mix`, `sampler.pixel(x, y, frame)` is
//! `bd_sampler_pixel(sampler, x, y, frame)`, and another sampler is another word, as in Rust. `draw::<2>` is `draw2`;
//! `[u32; 2]` is `vec2<u32>`; `u64` is `vec2<u32>`, its lower half first. The bits are the same.
//!
//! A text reads its table by a function that it leaves to you, as its head says. Write it, or take one of a [`Table`], for
//! a storage buffer or a texture:
//!
//! ```
//! use bluedither::shader;
//!
//! let mine = "
//!     @fragment
//!     fn main(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
//!         let blue = bd_sampler_with_spp(1u, 4u); // seed, samples per pixel
//!         let pixel = bd_sampler_pixel(blue, u32(position.x), u32(position.y), 0u);
//!         var mean = 0.0;
//!         for (var index = 0u; index < 4u; index++) {
//!             let lens = bd_sampler_draw2(pixel, 0u, index); // vec2<f32>, each in [0, 1)
//!             mean += lens.x * lens.y;
//!         }
//!         return vec4<f32>(mean / 4.0);
//!     }
//! ";
//! let wgsl: String = shader::SAMPLER.texts().chain([shader::LINEAR_ORDER.storage, mine]).collect();
//! let table: Vec<u32> = shader::linear_order_words().collect(); // for group 0, binding 0
//! # assert!(wgsl.contains("fn bd_linear_order_load") && table.len() == 912);
//! ```
//!
//! Plain WGSL without a preprocessor, in any order: declarations need not come before their use. No text declares an entry
//! point or a binding, but [`SEEDS_PASS`]. What works on rows or lists (`fill`, `fill_row`, `candidate`, the rows of
//! [`dither`](crate::dither)) is left out, since a shader has its pixels side by side; so is [`warp`](crate::warp), whose
//! functions have other bits on every device.

mod table;
mod words;

pub use table::{LINEAR_ORDER, SCALAR_MASK, Table, VECTOR_MASK};
pub use words::{linear_order_words, scalar_words, vector_words};

/// Texts that go together: a set of modules that holds all that each of them needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts(u64);

impl Parts {
    /// These and others, each once.
    #[inline]
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// What to paste.
    pub fn texts(self) -> impl Iterator<Item = &'static str> + Clone {
        self.modules().map(|(_, text)| text)
    }

    /// The modules' names: those of their files and, but for helpers, of their Rust modules and types.
    pub fn names(self) -> impl Iterator<Item = &'static str> + Clone {
        self.modules().map(|(name, _)| name)
    }

    fn modules(self) -> impl Iterator<Item = (&'static str, &'static str)> + Clone {
        MODULES.iter().enumerate().filter(move |(bit, _)| self.0 >> bit & 1 == 1).map(|(_, &module)| module)
    }
}

/// A constant for each module, which is a bit of [`Parts`], in the order of the list; needs stand above what needs them.
macro_rules! modules {
    ($($(#[$doc:meta])* $name:ident $file:literal [$($need:ident)*])*) => {
        #[allow(clippy::upper_case_acronyms, non_camel_case_types, reason = "names of the constants below")]
        enum Bit { $($name),* }
        $($(#[$doc])* pub const $name: Parts = Parts(1 << Bit::$name as u64 $(| $need.0)*);)*
        /// Everything.
        pub const ALL: Parts = Parts(0 $(| $name.0)*);
        static MODULES: [(&str, &str); ALL.0.count_ones() as usize] =
            [$(($file, include_str!(concat!("../wgsl/", $file, ".wgsl")))),*];
    };
}

modules! {
    /// [`unit`](mod@crate::unit): `bd_unit_…`.
    UNIT "unit" []
    /// 64-bit words, which WGSL lacks: `bd_wide_…`.
    WIDE "wide" []
    /// [`hash`](crate::hash): `bd_hash_…`.
    HASH "hash" [WIDE]
    /// [`torus`](crate::torus): `bd_torus_…`.
    TORUS "torus" [HASH]
    /// [`linear`](crate::linear): `bd_linear_…`; reads [`LINEAR_ORDER`].
    LINEAR "linear" []
    /// What masks share: `bd_mask_…`.
    MASK "mask/mod" []
    /// [`ScalarMask`](crate::ScalarMask): `bd_scalar_…`; reads [`SCALAR_MASK`].
    SCALAR "mask/scalar" [MASK UNIT]
    /// [`VectorMask`](crate::VectorMask) of two channels: `bd_vector_…`; reads [`VECTOR_MASK`].
    VECTOR "mask/vector" [MASK UNIT]
    /// What samplers share: `bd_domain_…`.
    DOMAIN "sampler/mod" [HASH WIDE]
    /// [`Sampler`](crate::Sampler): `bd_sampler_…`; reads [`LINEAR_ORDER`].
    SAMPLER "sampler/linear" [DOMAIN LINEAR UNIT]
}
