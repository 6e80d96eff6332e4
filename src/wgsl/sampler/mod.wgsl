// What samplers share: the numbers of a domain's own.

// The seed of a domain's numbers, one for each of its four pairs.
fn bd_domain_seed(seed: u32, domain: u32, pad: u32) -> u32 {
    return bd_hash_combine(seed, bd_domain_own(domain, pad));
}

// A number for every pair of every domain.
fn bd_domain_own(domain: u32, pad: u32) -> u32 {
    return domain ^ (pad * 0x5bd1e995u);
}
