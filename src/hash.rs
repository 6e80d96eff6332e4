//! Seeds and scrambles: integer hashes that have no state and use no table.

/// A bijection of `u32` in which every input bit flips every output bit with a chance near one half.
///
/// Two rounds of multiply and xor-shift, constants of `hash-prospector` (C. Wellons; the pair was found by
/// TheIronBorn, bias 0.107). 0 does not stay 0: seeds of 0, 1, 2, … are what users pass.
#[inline]
#[must_use]
pub const fn mix(value: u32) -> u32 {
    let mut h = value ^ 0xe6fe_3beb;
    h ^= h >> 16;
    h = h.wrapping_mul(0x21f0_aaad);
    h ^= h >> 15;
    h = h.wrapping_mul(0xd35a_2d97);
    h ^ (h >> 15)
}

/// A seed that depends on all bits of both arguments and on their order; chain it for more.
///
/// For a fixed `seed` a bijection of `value`, so that no two domains or frames share a stream.
#[inline]
#[must_use]
pub const fn combine(seed: u32, value: u32) -> u32 {
    mix(mix(seed).wrapping_add(value))
}

/// Laine–Karras permutation: every bit is flipped by a hash of the bits *below* it.
///
/// On bit-reversed numbers this is a nested uniform (Owen) scramble. Laine and Karras 2011, Burley 2020; constants and
/// operations of N. Vegdahl's second version (2021), which removes the weak low bits. Hash `seed` first: small
/// consecutive seeds scramble poorly.
#[inline]
#[must_use]
pub const fn laine_karras(value_rev: u32, seed: u32) -> u32 {
    let mut n = value_rev;
    n ^= n.wrapping_mul(0x3d20_adea);
    n = n.wrapping_add(seed);
    n = n.wrapping_mul((seed >> 16) | 1);
    n ^= n.wrapping_mul(0x0552_6c56);
    n ^ n.wrapping_mul(0x53a2_2864)
}

/// Nested uniform (Owen) scramble of a 0.32 number: digit k is flipped by a hash of the digits above it.
///
/// A bijection that maps every elementary interval [a·2⁻ᵏ, (a+1)·2⁻ᵏ) onto one of the same size, so it keeps every
/// net a net. Two bit reversals and six operations.
#[inline]
#[must_use]
pub const fn owen(value_fx: u32, seed: u32) -> u32 {
    laine_karras(value_fx.reverse_bits(), seed).reverse_bits()
}

/// Shuffles sample numbers so that every set {0, …, 2ᵏ−1} stays the same set.
///
/// Two pairs of dimensions that read one sequence in two such orders are decorrelated, and each still sees the first
/// 2ᵏ points after 2ᵏ samples. 0 and 1 stay in place. Below its top set bit an index is Owen-scrambled by a hash that
/// depends on the place of that bit (the prefix-preserving form of Burley's 2020 shuffle).
#[inline]
#[must_use]
pub const fn shuffle(index: u32, seed: u32) -> u32 {
    if index < 2 {
        return index;
    }
    let low_log2 = 31 - index.leading_zeros();
    let low = index ^ (1 << low_log2);
    let scrambled = owen(low << (32 - low_log2), mix(seed ^ low_log2));
    (1 << low_log2) | (scrambled >> (32 - low_log2))
}
