//! How a shader reads tables: for each a function for a storage buffer and one for a texture.

/// Text that declares a table's binding, in group 0, and reads it. For another place edit the numbers, or write your own
/// function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Table {
    /// For a storage buffer that holds the table's words, 32 bits each.
    pub storage: &'static str,
    /// For a texture of `format`: the same words in the same order, row by row.
    pub texture: &'static str,
    /// The texture's format, as WebGPU spells it.
    pub format: &'static str,
    /// Its number in group 0.
    pub binding: u32,
    sizes: [&'static str; 9],
}

impl Table {
    /// The constant that says of how many pixels a side, 1 to 256, a mask is; to be pasted beside the rest. Other numbers count as the power of
    /// two below, or the end of the range. Tables of one size only have none, and then it is empty.
    #[must_use]
    pub const fn size(&self, side: usize) -> &'static str {
        let log2 = match side.checked_ilog2() {
            Some(log2) if log2 < 8 => log2,
            Some(_) => 8,
            None => 0,
        };
        self.sizes[log2 as usize]
    }
}

macro_rules! table {
    ($binding:literal, $name:literal, $format:literal, $sizes:expr, $storage:literal, $texture:literal) => {
        Table {
            storage: concat!(
                "@group(0) @binding(",
                $binding,
                ") var<storage, read> ",
                $name,
                ": array<u32>;\n",
                $storage,
                "\n"
            ),
            texture: concat!("@group(0) @binding(", $binding, ") var ", $name, ": texture_2d<u32>;\n", $texture, "\n"),
            format: $format,
            binding: $binding,
            sizes: $sizes,
        }
    };
}

/// `const NAME = log₂;` for every side of a mask.
macro_rules! sizes {
    ($name:literal) => { sizes!(@each $name; 0 1 2 3 4 5 6 7 8) };
    (@each $name:literal; $($log2:literal)*) => { [$(concat!("const ", $name, " = ", $log2, "u;\n")),*] };
}

/// The constants of [`Sampler`](crate::Sampler), [`linear_order_words`](super::linear_order_words): a texture of 16×57.
pub const LINEAR_ORDER: Table = table!(
    0,
    "bd_linear_order",
    "r32uint",
    [""; 9],
    "fn bd_linear_order_load(i: u32) -> u32 { return bd_linear_order[i]; }",
    "fn bd_linear_order_load(i: u32) -> u32 {
    return textureLoad(bd_linear_order, vec2<u32>(i & 15u, i >> 4u), 0).r;
}"
);

/// A mask of one channel, [`scalar_words`](super::scalar_words): a texture of the mask's own size.
pub const SCALAR_MASK: Table = table!(
    1,
    "bd_scalar",
    "r16uint",
    sizes!("BD_SCALAR_LOG2"),
    "fn bd_scalar_load(x: u32, y: u32) -> u32 {
    let i = (y << BD_SCALAR_LOG2) | x;
    return (bd_scalar[i >> 1u] >> ((i & 1u) * 16u)) & 0xffffu;
}",
    "fn bd_scalar_load(x: u32, y: u32) -> u32 { return textureLoad(bd_scalar, vec2<u32>(x, y), 0).r; }"
);

/// A mask of two channels, [`vector_words`](super::vector_words): a texture of the mask's own size.
pub const VECTOR_MASK: Table = table!(
    2,
    "bd_vector",
    "rg16uint",
    sizes!("BD_VECTOR_LOG2"),
    "fn bd_vector_load(x: u32, y: u32) -> vec2<u32> {
    let ranks = bd_vector[(y << BD_VECTOR_LOG2) | x];
    return vec2<u32>(ranks & 0xffffu, ranks >> 16u);
}",
    "fn bd_vector_load(x: u32, y: u32) -> vec2<u32> { return textureLoad(bd_vector, vec2<u32>(x, y), 0).rg; }"
);
