//! Digests: one short number that tells whether a table is still what was recorded.

/// FNV-1a, 64 bits (Fowler, Noll and Vo), of numbers as eight little-endian bytes each: the same on every machine.
pub fn digest(numbers: impl IntoIterator<Item = i64>) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325u64;
    for number in numbers {
        for byte in number.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    hash
}

/// The digest of a table of ranks.
pub fn of_ranks(ranks: &[u16]) -> u64 {
    digest(ranks.iter().map(|&rank| i64::from(rank)))
}
