// Numbers in [0, 1): 0.32 fixed point in a u32, and the only place where it becomes a float. As `bluedither::unit`.

// The float at or just below a fixed-point number: its upper 24 bits, exactly, so never 1.0.
fn bd_unit_to_f32(value_fx: u32) -> f32 {
    return f32(value_fx >> 8u) * 0x1p-24f;
}

fn bd_unit_to_f32s2(values_fx: vec2<u32>) -> vec2<f32> {
    return vec2<f32>(values_fx >> vec2<u32>(8u)) * 0x1p-24f;
}

fn bd_unit_to_f32s3(values_fx: vec3<u32>) -> vec3<f32> {
    return vec3<f32>(values_fx >> vec3<u32>(8u)) * 0x1p-24f;
}

fn bd_unit_to_f32s4(values_fx: vec4<u32>) -> vec4<f32> {
    return vec4<f32>(values_fx >> vec4<u32>(8u)) * 0x1p-24f;
}

// The fixed-point number of a float: clamped to [0, 1), NaN to 0, rounded down. By its bits, since what a conversion
// makes of a float that is out of range differs between languages.
fn bd_unit_from_f32(value: f32) -> u32 {
    let bits = bitcast<u32>(value);
    if bits > 0x7f800000u {
        return 0u; // negative or undefined
    }
    if bits >= 0x3f800000u {
        return 0xffffffffu; // 1 and above
    }
    let exponent = bits >> 23u;
    let mantissa = (bits & 0x7fffffu) | 0x800000u;
    if exponent >= 118u {
        return mantissa << (exponent - 118u);
    }
    if exponent > 94u {
        return mantissa >> (118u - exponent);
    }
    return 0u;
}
