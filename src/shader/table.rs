//! How a shader reads tables: for each a function for a storage buffer and one for a texture.

/// Text that declares a table's binding, in group 0, and reads it. For another place edit the numbers, or write your
/// own function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Table {
    /// For a storage buffer that holds the table's words, 32 bits each.
    pub storage: &'static str,
    /// For a texture of `format`: the same bytes, row by row.
    pub texture: &'static str,
    /// The texture's format, as WebGPU spells it.
    pub format: &'static str,
    /// Its number in group 0.
    pub binding: u32,
    sizes: &'static [&'static str],
}

impl Table {
    /// The constant to be pasted beside the rest, for a mask of so many pixels a side or a table of so many
    /// dimensions: a power of two up to 256 or 1024. Other numbers count as the power of two below, or as the end of
    /// the range. Empty for tables that have one size only.
    #[must_use]
    pub const fn size_text(&self, side: usize) -> &'static str {
        let log2 = match side.checked_ilog2() {
            Some(log2) => log2 as usize,
            None => 0,
        };
        match self.sizes.len() {
            0 => "",
            count if log2 < count => self.sizes[log2],
            count => self.sizes[count - 1],
        }
    }
}

/// A table whose function, its arguments and result given, returns one expression or the other.
macro_rules! table {
    ($binding:literal $name:literal $format:literal, $($rest:tt)*) => {
        table!($binding $name "u32" $format, $($rest)*)
    };
    ($binding:literal $name:literal $word:literal $format:literal, $sizes:expr, $signature:literal, $storage:expr, $texture:expr) => {
        Table {
            storage: concat!(
                "@group(0) @binding(",
                $binding,
                ") var<storage, read> ",
                $name,
                ": array<",
                $word,
                ">;\n",
                "fn ",
                $name,
                "_load",
                $signature,
                " {\n    return ",
                $storage,
                ";\n}\n",
            ),
            texture: concat!(
                "@group(0) @binding(",
                $binding,
                ") var ",
                $name,
                ": texture_2d<u32>;\n",
                "fn ",
                $name,
                "_load",
                $signature,
                " {\n    return ",
                $texture,
                ";\n}\n",
            ),
            format: $format,
            binding: $binding,
            sizes: $sizes,
        }
    };
}

/// A mask of one channel, two ranks a word.
macro_rules! ranks {
    ($binding:literal $name:literal $log2:literal, $sizes:expr) => {
        table!(
            $binding $name "r16uint", $sizes, "(x: u32, y: u32) -> u32",
            concat!("(", $name, "[((y << ", $log2, ") | x) >> 1u] >> ((x & 1u) * 16u)) & 0xffffu"),
            concat!("textureLoad(", $name, ", vec2<u32>(x, y), 0).r")
        )
    };
}

/// A mask of two channels, a pixel a word.
macro_rules! pairs {
    ($binding:literal $name:literal $log2:literal) => {
        table!(
            $binding $name "rg16uint", sizes!($log2), "(x: u32, y: u32) -> vec2<u32>",
            concat!("(vec2<u32>(", $name, "[(y << ", $log2, ") | x]) >> vec2<u32>(0u, 16u)) & vec2<u32>(0xffffu)"),
            concat!("textureLoad(", $name, ", vec2<u32>(x, y), 0).rg")
        )
    };
}

/// `const NAME = number;` for every size.
macro_rules! sizes {
    ($name:literal) => { sizes!($name: 0 1 2 3 4 5 6 7 8) };
    ($name:literal: $($number:literal)*) => { &[$(concat!("const ", $name, " = ", $number, "u;\n")),*] };
}

/// The constants of [`Sampler`](crate::Sampler), [`net_words`](super::net_words): a texture of
/// 249×1, a storage buffer of `vec4<u32>`.
pub const NET: Table = table!(
    0 "bd_net" "vec4<u32>" "rgba32uint", &[], "(i: u32) -> vec4<u32>",
    "bd_net[i]",
    "textureLoad(bd_net, vec2<u32>(i, 0u), 0)"
);

/// The sequence of [`Keyed`](crate::Keyed), [`sequence_words`](super::sequence_words): a texture of 16×7.
pub const SEQUENCE: Table = table!(
    3 "bd_sequence" "r32uint", &[], "(i: u32) -> u32",
    "bd_sequence[i]",
    "textureLoad(bd_sequence, vec2<u32>(i & 15u, i >> 4u), 0).r"
);

/// A mask of one channel, [`scalar_words`](super::scalar_words): a texture of the mask's size.
pub const SCALAR_MASK: Table = ranks!(1 "bd_scalar" "BD_SCALAR_LOG2", sizes!("BD_SCALAR_LOG2"));

/// A mask of two channels, [`vector_words`](super::vector_words): a texture of the mask's size.
pub const VECTOR_MASK: Table = pairs!(2 "bd_vector" "BD_VECTOR_LOG2");

/// Scrambling keys, [`keys_words`](super::keys_words): a texture of the tile's size.
pub const KEYS_TILE: Table = table!(
    4 "bd_keys" "r32uint", sizes!("BD_KEYS_LOG2"), "(x: u32, y: u32) -> u32",
    "bd_keys[(y << BD_KEYS_LOG2) | x]",
    "textureLoad(bd_keys, vec2<u32>(x, y), 0).r"
);

/// Direction numbers, [`direction_words`](super::direction_words): a texture of 32 times the number of dimensions.
pub const DIRECTION_NUMBERS: Table = table!(
    5 "bd_directions" "r32uint", sizes!("BD_DIRECTIONS_COUNT": 1 2 4 8 16 32 64 128 256 512 1024),
    "(dimension: u32, bit: u32) -> u32",
    "bd_directions[32u * dimension + bit]",
    "textureLoad(bd_directions, vec2<u32>(bit, dimension), 0).r"
);

/// Masks over time, [`time_words`](super::time_words): a texture of the masks one below the other. Besides the size it
/// takes their number: `const BD_OVER_TIME_FRAMES = 32u;`, 16 for both tables of 64² pixels, 64 for
/// `THRESHOLD_OVER_TIME_128`. Of a `VectorTimeMask` bind the mask of a frame as [`VECTOR_MASK`].
pub const TIME_MASK: Table = ranks!(6 "bd_over_time" "BD_OVER_TIME_LOG2", sizes!("BD_OVER_TIME_LOG2"));

/// Light of the 256 sRGB values of 8 bits, `linear_light_words`: a texture of 256×1.
pub const LINEAR_LIGHT: Table = table!(
    7 "bd_gamma" "r16uint", &[], "(i: u32) -> u32",
    "(bd_gamma[i >> 1u] >> ((i & 1u) * 16u)) & 0xffffu",
    "textureLoad(bd_gamma, vec2<u32>(i, 0u), 0).r"
);

/// Swaps of seeds, `seed_swap_words`: a texture of 64×64.
pub const SEED_SWAPS: Table = ranks!(8 "bd_seeds" "6u", &[]);
