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

fn bd_unit_to_f32s5(values_fx: array<u32, 5>) -> array<f32, 5> {
    let a = bd_unit_to_f32s4(vec4<u32>(values_fx[0], values_fx[1], values_fx[2], values_fx[3]));
    return array<f32, 5>(a.x, a.y, a.z, a.w, bd_unit_to_f32(values_fx[4]));
}

fn bd_unit_to_f32s6(values_fx: array<u32, 6>) -> array<f32, 6> {
    let a = bd_unit_to_f32s4(vec4<u32>(values_fx[0], values_fx[1], values_fx[2], values_fx[3]));
    let b = bd_unit_to_f32s2(vec2<u32>(values_fx[4], values_fx[5]));
    return array<f32, 6>(a.x, a.y, a.z, a.w, b.x, b.y);
}

fn bd_unit_to_f32s7(values_fx: array<u32, 7>) -> array<f32, 7> {
    let a = bd_unit_to_f32s4(vec4<u32>(values_fx[0], values_fx[1], values_fx[2], values_fx[3]));
    let b = bd_unit_to_f32s3(vec3<u32>(values_fx[4], values_fx[5], values_fx[6]));
    return array<f32, 7>(a.x, a.y, a.z, a.w, b.x, b.y, b.z);
}

fn bd_unit_to_f32s8(values_fx: array<u32, 8>) -> array<f32, 8> {
    let a = bd_unit_to_f32s4(vec4<u32>(values_fx[0], values_fx[1], values_fx[2], values_fx[3]));
    let b = bd_unit_to_f32s4(vec4<u32>(values_fx[4], values_fx[5], values_fx[6], values_fx[7]));
    return array<f32, 8>(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w);
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
