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

/// 64 bits of seed from 64: a bijection, and cheaper than two of [`mix`].
///
/// Two rounds of multiply and xor-shift with the multiplier of P. Evensen's `rrmxmx` (2018), odd and without a pattern.
#[inline]
#[must_use]
pub const fn mix_64(value: u64) -> u64 {
    let mut h = value ^ 0x9e37_79b9_7f4a_7c15;
    h = (h ^ (h >> 32)).wrapping_mul(0x9fb2_1c65_1e98_df25);
    h = (h ^ (h >> 29)).wrapping_mul(0x9fb2_1c65_1e98_df25);
    h ^ (h >> 32)
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

/// Another seed from a seed: the upper half of a product, in which every bit has a say. Cheaper than [`mix`], and
/// enough for a hash that goes on.
#[inline]
#[must_use]
pub const fn other(seed: u32) -> u32 {
    ((seed as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as u32
}

/// Base-4 form of [`laine_karras`]: pairs of bits are digits, and every digit goes through a permutation of {0, 1, 2,
/// 3} that a hash of the digits *below* it has chosen.
///
/// All 24 permutations occur: each of the three ways to halve the four values, with chances of 3/8, 3/8 and 2/8, times
/// the eight permutations that keep a half together, with equal chances. Binary scrambling has one way only; the hash
/// of Blender's Cycles, which adds two conditional flips to it, two, and one in the first digit (counted). Below two
/// values of a digit the choices are not quite independent: they agree less often than chance would have it. Hash
/// `seed` first.
#[inline]
#[must_use]
pub const fn laine_karras_4(value_rev: u32, seed: u32) -> u32 {
    const FIRST: u32 = 0x5555_5555;
    // Three bits of choice a digit: two that know the digits below, and one of those below the last.
    let own = other(seed);
    let hash = laine_karras(value_rev, own);
    let choice = (hash << 2) | (own >> 30);
    let third = (hash << 4) | (own >> 26 & 0xf);
    let mut n = value_rev;
    // A digit's first bit f and its second, s: that the new first bit is f, s or f^s decides what goes together.
    n ^= (n & FIRST) << 1;
    n ^= (n >> 1) & choice & FIRST;
    n ^= (n & (choice >> 1) & FIRST) << 1;
    n ^= (n >> 1) & third & FIRST;
    laine_karras(n, seed)
}

/// Nested uniform scramble in base 4 of a 0.32 number: digit k is permuted by a hash of the digits above it.
///
/// A bijection that maps every interval [a·4⁻ᵏ, (a+1)·4⁻ᵏ) onto one of the same size. On a Morton code it visits
/// the quadrants of every square in an order of that square's own.
#[inline]
#[must_use]
pub const fn owen_4(value_fx: u32, seed: u32) -> u32 {
    laine_karras_4(value_fx.reverse_bits(), seed).reverse_bits()
}

/// Shuffles sample numbers so that every set {0, …, 2ᵏ−1} stays the same set, and 0 and 1 stay in place; of an index
/// that is bit-reversed already, and so is the result.
///
/// Two pairs of dimensions that read one sequence in two such orders are decorrelated, and each still sees the first 2ᵏ
/// points after 2ᵏ samples. Products and sums pass on nothing to lower bits, and zeros below stay zeros, so that below
/// its top set bit an index is Owen-scrambled (compare Burley 2020). Three multiplications take a hash of `seed` apart.
/// Hash `seed` first.
#[inline]
#[must_use]
pub const fn shuffle_rev(index_rev: u32, seed: u32) -> u32 {
    let mut n = index_rev;
    n ^= n.wrapping_mul(seed & !1);
    n = n.wrapping_mul((seed >> 20) | 1);
    n ^ n.wrapping_mul((seed >> 10) & !1)
}

/// [`shuffle_rev`] of an index that is not reversed.
#[inline]
#[must_use]
pub const fn shuffle(index: u32, seed: u32) -> u32 {
    shuffle_rev(index.reverse_bits(), seed).reverse_bits()
}
