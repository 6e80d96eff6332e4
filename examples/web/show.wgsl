// Shows an image: as it is, through a Gaussian of one pixel (about what an eye keeps), or its error.

struct Show {
    size: vec2<u32>,
    // 0: the picture; 1: blurred; 2: the error, times 3, around grey; 3: the error, blurred and times 6.
    mode: u32,
}

@group(0) @binding(0) var<uniform> show: Show;
@group(0) @binding(1) var<storage, read> image: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> reference: array<vec4<f32>>;

// One triangle over the whole canvas.
@vertex
fn corners(@builtin(vertex_index) k: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(k & 1u) * 4.0 - 1.0, f32(k >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn color(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<i32>(position.xy);
    let blurred = (show.mode & 1u) == 1u;
    var sum = vec3<f32>(0.0);
    var weights = 0.0;
    let reach = select(0, 3, blurred);
    for (var y = -reach; y <= reach; y++) {
        for (var x = -reach; x <= reach; x++) {
            let weight = exp(-0.5 * f32(x * x + y * y));
            sum += weight * value(pixel + vec2<i32>(x, y));
            weights += weight;
        }
    }
    let mean = sum / weights;
    if show.mode >= 2u {
        return vec4<f32>(0.5 + select(3.0, 6.0, blurred) * mean, 1.0);
    }
    return vec4<f32>(encoded(mean), 1.0);
}

fn value(at: vec2<i32>) -> vec3<f32> {
    let inside = vec2<u32>(clamp(at, vec2<i32>(0), vec2<i32>(show.size) - 1));
    let place = inside.y * show.size.x + inside.x;
    let seen = image[place].rgb / max(image[place].w, 1.0);
    if show.mode < 2u {
        return seen;
    }
    return seen - reference[place].rgb / max(reference[place].w, 1.0);
}

// sRGB.
fn encoded(light: vec3<f32>) -> vec3<f32> {
    let value = clamp(light, vec3<f32>(0.0), vec3<f32>(1.0));
    return select(1.055 * pow(value, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * value, value <= vec3<f32>(0.0031308));
}
