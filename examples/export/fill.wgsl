
struct bd_Fill {
    width: u32,
    height: u32,
    seed: u32,
    spp: u32,
    frame: u32,
    domain: u32,
    index: u32,
}

@group(0) @binding(14) var<uniform> bd_fill: bd_Fill;
@group(0) @binding(15) var<storage, read_write> bd_filled: array<vec4<f32>>;

// Sample `index` for purpose `domain` of every pixel, row by row. A workgroup is 8x8 pixels.
@compute @workgroup_size(8, 8)
fn fill(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= bd_fill.width || id.y >= bd_fill.height {
        return;
    }
    /* draw */
    bd_filled[id.y * bd_fill.width + id.x] = drawn;
}
