// Words of 64 bits as vec2<u32>(low, high), which WGSL lacks, and roots.

// All 64 bits of a product.
fn bd_wide_product(a: u32, b: u32) -> vec2<u32> {
    let a0 = a & 0xffffu;
    let a1 = a >> 16u;
    let b0 = b & 0xffffu;
    let b1 = b >> 16u;
    let middle = a1 * b0 + ((a0 * b0) >> 16u);
    let upper = a0 * b1 + (middle & 0xffffu);
    return vec2<u32>(a * b, a1 * b1 + (middle >> 16u) + (upper >> 16u));
}

// A sum modulo 2^64.
fn bd_wide_add(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let low = a.x + b.x;
    return vec2<u32>(low, a.y + b.y + select(0u, 1u, low < b.x));
}

// A product modulo 2^64.
fn bd_wide_mul(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return bd_wide_product(a.x, b.x) + vec2<u32>(0u, a.x * b.y + a.y * b.x);
}

// Quotient and remainder of a division whose quotient fits 32 bits: a.y < b. Long division in two digits of 16 bits
// (Knuth's algorithm D), after a shift that sets the highest bit of the divisor.
fn bd_wide_divide(a: vec2<u32>, b: u32) -> vec2<u32> {
    let shift = countLeadingZeros(b) & 31u;
    let divisor = b << shift;
    let high = (a.y << shift) | ((a.x >> 1u) >> (31u - shift));
    let low = a.x << shift;
    let first = bd_wide_digit(high, low >> 16u, divisor);
    let second = bd_wide_digit(first.y, low & 0xffffu, divisor);
    return vec2<u32>((first.x << 16u) | second.x, second.y >> shift);
}

// Quotient and remainder of (rest * 2^16 + next) / divisor, rest < divisor: guessed by the upper half of the divisor,
// which is at most 2 too much.
fn bd_wide_digit(rest: u32, next: u32, divisor: u32) -> vec2<u32> {
    let upper = divisor >> 16u;
    let lower = divisor & 0xffffu;
    var digit = rest / upper;
    var left = rest - digit * upper;
    while left < 0x10000u && (digit > 0xffffu || digit * lower > ((left << 16u) | next)) {
        digit -= 1u;
        left += upper;
    }
    return vec2<u32>(digit, ((rest << 16u) | next) - digit * divisor);
}

// The root of a number, rounded down: bit by bit.
fn bd_wide_isqrt(value: vec2<u32>) -> u32 {
    var root = 0u;
    for (var bit = 0x80000000u; bit != 0u; bit >>= 1u) {
        let square = bd_wide_product(root | bit, root | bit);
        if square.y < value.y || (square.y == value.y && square.x <= value.x) {
            root |= bit;
        }
    }
    return root;
}
