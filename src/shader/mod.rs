//! The same functions for shaders: WGSL text to paste, and the tables' bytes for its bindings.
//!
//! A [`Parts`] names what a shader uses, and gives each text once, with all that it needs. Names begin with `bd_`
//! (constants with `BD_`), then come the Rust module or type and the function: `hash::mix` is `bd_hash_mix`,
//! `sampler.pixel(x, y, frame)` is `bd_sampler_pixel(sampler, x, y, frame)`, and another sampler is another word, as in
//! Rust. `draw::<2>` is `draw2`; `[u32; 2]` is `vec2<u32>`, and so up to four; `[u32; 5]` is `array<u32, 5>`; `u64` is
//! `vec2<u32>`, its lower half first. The bits are the same.
//!
//! A text reads its table by a function that it leaves to you, as its head says. Write it, or take one of a [`Table`],
//! for a storage buffer or a texture:
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
//! let wgsl: String = shader::SAMPLER.texts().chain([shader::NET.storage, mine]).collect();
//! let table: Vec<u32> = shader::net_words().collect(); // for group 0, binding 0
//! # assert!(wgsl.contains("fn bd_net_load") && table.len() == 996);
//! ```
//!
//! Plain WGSL without a preprocessor, in any order: declarations need not come before their use. No text declares an
//! entry point or a binding, but [`SEEDS_PASS`]. What works on rows or lists (`fill`, `fill_row`, `candidate`, the
//! rows of [`dither`](crate::dither)) is left out, since a shader has its pixels side by side; so are
//! [`warp`](crate::warp), whose functions have other bits on every device, and `unit::to_f64`. `Dither::gamma` is
//! `bd_gamma_level` of a pixel's threshold; of several numbers some functions have a form for each count (`to_f32s2`,
//! `global3`).

mod draws;
mod table;
mod words;

pub use table::{
    DIRECTION_NUMBERS, KEYS_TILE, LINEAR_LIGHT, NET, SCALAR_MASK, SEED_SWAPS, SEQUENCE, TIME_MASK, Table, VECTOR_MASK,
};
#[cfg(feature = "gamma")]
pub use words::linear_light_words;
#[cfg(feature = "seed-permutation")]
pub use words::seed_swap_words;
pub use words::{direction_words, keys_words, net_words, scalar_words, sequence_words, time_words, vector_words};

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

/// A constant for each module, which is a bit of [`Parts`], in the order of the list; needs stand above what needs
/// them. Behind a sampler's own text come its draws, by a template and under its name and title.
macro_rules! modules {
    ($($(#[$doc:meta])* $name:ident $file:literal $(($template:ident $word:literal $title:literal))? [$($need:ident)*])*) => {
        #[allow(clippy::upper_case_acronyms, non_camel_case_types, reason = "names of the constants below")]
        enum Bit { $($name),* }
        $($(#[$doc])* pub const $name: Parts = Parts(1 << Bit::$name as u64 $(| $need.0)*);)*
        /// Everything.
        pub const ALL: Parts = Parts(0 $(| $name.0)*);
        static MODULES: [(&str, &str); ALL.0.count_ones() as usize] =
            [$(($file, modules!(@text include_str!(concat!("../wgsl/", $file, ".wgsl")), $($template $word $title)?))),*];
    };
    (@text $own:expr,) => {
        $own
    };
    (@text $own:expr, $template:ident $word:literal $title:literal) => {{
        const TEXTS: [&str; 3] = [$own, draws::$template, draws::FLOATS];
        const LENGTH: usize = draws::paste::<0>(TEXTS, $word, $title).1;
        static PASTED: [u8; LENGTH] = draws::paste(TEXTS, $word, $title).0;
        draws::text(&PASTED)
    }};
}

modules! {
    /// [`unit`](mod@crate::unit): `bd_unit_…`.
    UNIT "unit" []
    /// Words of 64 bits, which WGSL lacks: `bd_wide_…`.
    WIDE "wide" []
    /// [`hash`](crate::hash): `bd_hash_…`.
    HASH "hash" [WIDE]
    /// [`torus`](crate::torus): `bd_torus_…`.
    TORUS "torus" [HASH]
    /// [`sobol`](crate::sobol): `bd_sobol_…`.
    SOBOL "sobol" [HASH]
    /// [`sobol::Directions`](crate::sobol::Directions): `bd_directions_…`; reads [`DIRECTION_NUMBERS`].
    DIRECTIONS "directions" [HASH]
    /// [`lattice`](crate::lattice): `bd_lattice_…`.
    LATTICE "lattice" [WIDE]
    /// [`sequence`](crate::sequence): `bd_sequence_…`; reads [`SEQUENCE`].
    KEYED_SEQUENCE "sequence" []
    /// [`zorder`](crate::zorder): `bd_zorder_…`.
    ZORDER "zorder" []
    /// [`net`](crate::net): `bd_net_…`; reads [`NET`].
    JOINT_NET "net" []
    /// [`strata`](crate::strata): `bd_strata_…`.
    STRATA "strata" [HASH]
    /// [`shift`](crate::shift): `bd_shift_…`.
    SHIFT "shift" [STRATA]
    /// What masks share: `bd_mask_…`.
    MASK "mask/mod" []
    /// [`ScalarMask`](crate::ScalarMask): `bd_scalar_…`; reads [`SCALAR_MASK`].
    SCALAR "mask/scalar" [MASK UNIT]
    /// [`VectorMask`](crate::VectorMask) of two channels: `bd_vector_…`; reads [`VECTOR_MASK`].
    VECTOR "mask/vector" [MASK UNIT]
    /// [`Keys`](crate::Keys): `bd_keys_…`; reads [`KEYS_TILE`].
    KEYS "keys" []
    /// What samplers share: `bd_domain_…`.
    DOMAIN "sampler/mod" [HASH]
    /// [`Sampler`](crate::Sampler): `bd_sampler_…`; reads [`NET`].
    SAMPLER "sampler/net" (JOINT "sampler" "Sampler") [HASH JOINT_NET ZORDER UNIT]
    /// [`Keyed`](crate::Keyed): `bd_keyed_…`; reads [`SEQUENCE`] and [`KEYS_TILE`].
    KEYED "sampler/keyed" (PADDED "keyed" "Keyed") [DOMAIN KEYS KEYED_SEQUENCE TORUS UNIT]
    /// [`Dithered`](crate::Dithered): `bd_dithered_…`; reads [`SCALAR_MASK`] and [`VECTOR_MASK`].
    DITHERED "sampler/dithered" (PADDED "dithered" "Dithered") [DOMAIN SCALAR VECTOR SHIFT SOBOL TORUS]
    /// [`White`](crate::White): `bd_white_…`.
    WHITE "sampler/white" (PADDED "white" "White") [DOMAIN SOBOL UNIT]
    /// [`dither::quantise`](crate::dither::quantise): `bd_quantise_…`.
    QUANTISE "dither/quantise" [WIDE]
    /// [`dither::ordered`](crate::dither::ordered): `bd_ordered_…`.
    ORDERED "dither/ordered" [ZORDER]
    /// `dither::gamma`: `bd_gamma_…`; reads [`LINEAR_LIGHT`].
    GAMMA "dither/gamma" [QUANTISE]
    /// [`dither::alpha`](crate::dither::alpha): `bd_alpha_…`.
    ALPHA "dither/alpha" []
    /// [`Dither`](crate::Dither): `bd_dither_…`; reads [`SCALAR_MASK`].
    DITHER "dither/mod" [QUANTISE ORDERED SCALAR TORUS]
    /// `frames::masks`: `bd_over_time_…`; reads [`TIME_MASK`].
    OVER_TIME "frames/masks" [MASK UNIT]
    /// `frames::seeds`: `bd_seeds_…`; reads [`SEED_SWAPS`].
    SEEDS "frames/seeds" []
    /// `frames::seeds::permute` as a compute pass, with bindings and entry points of its own; reads [`SEED_SWAPS`] and
    /// [`SCALAR_MASK`].
    SEEDS_PASS "frames/seeds_pass" [SEEDS SCALAR]
}
