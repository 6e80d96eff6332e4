//! The Z curve, which visits the pixels of every square of 2ᵏ×2ᵏ in a row. [`hash::owen_4`](crate::hash::owen_4)
//! shuffles it.

/// The Z curve (Morton 1966): bit k of `x` is bit 2k of the code, bit k of `y` bit 2k+1.
#[inline]
#[must_use]
pub const fn morton(x: u32, y: u32) -> u64 {
    morton_16(x, y) as u64 | (morton_16(x >> 16, y >> 16) as u64) << 32
}

/// The lower half of the code, from the lower 16 bits of both. Both are spread in one word.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "32 bits are left")]
pub const fn morton_16(x: u32, y: u32) -> u32 {
    let mut n = (x & 0xffff) as u64 | ((y & 0xffff) as u64) << 32;
    n = (n | n << 8) & 0x00ff_00ff_00ff_00ff;
    n = (n | n << 4) & 0x0f0f_0f0f_0f0f_0f0f;
    n = (n | n << 2) & 0x3333_3333_3333_3333;
    n = (n | n << 1) & 0x5555_5555_5555_5555;
    (n | n >> 31) as u32
}
