// What samplers share: the numbers of a domain's own.

// The seed of a domain's numbers, one for each of its four pairs.
fn bd_domain_seed(seed: u32, domain: u32, pad: u32) -> u32 {
    return bd_hash_combine(seed, bd_domain_own(domain, pad));
}

// The 64 bits of a domain's own.
fn bd_domain_word(seed: vec2<u32>, domain: u32, pad: u32) -> vec2<u32> {
    return bd_wide_mul(seed, bd_hash_mix_64(vec2<u32>(bd_domain_own(domain, pad), 0u)) | vec2<u32>(1u, 0u));
}

// A number for every pair of every domain.
fn bd_domain_own(domain: u32, pad: u32) -> u32 {
    return domain ^ (pad * 0x5bd1e995u);
}
