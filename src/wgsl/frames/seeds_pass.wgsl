// Seed permutation as a compute pass: `bluedither::frames::seeds::permute`. Dispatch (width + 11) / 8 by (height + 11)
// / 8 workgroups of bd_seeds_sort, then of bd_seeds_retarget_0, _1 and _2. The scalar mask that is bound is
// `tables::THRESHOLD_64`.

struct bd_SeedsPicture {
    width: u32,
    height: u32,
    frame: u32,
    // Of a block: 2, 4 or 8 pixels.
    side: u32,
}

@group(0) @binding(12) var<uniform> bd_seeds_picture: bd_SeedsPicture;
@group(0) @binding(13) var<storage, read_write> bd_seeds_held: array<u32>;
// Floats, by their bits: what each pixel found. Those without one count as brightest.
@group(0) @binding(14) var<storage, read> bd_seeds_estimates: array<u32>;

// Of the workgroup's 8x8 pixels: estimate and rank, whether it is in the picture, and the sorted seeds.
var<workgroup> bd_seeds_found: array<i32, 64>;
var<workgroup> bd_seeds_wanted: array<u32, 64>;
var<workgroup> bd_seeds_inside: array<u32, 64>;
var<workgroup> bd_seeds_sorted: array<u32, 64>;

// Sorts the seeds of every block by estimate, into the order of the mask.
@compute @workgroup_size(8, 8)
fn bd_seeds_sort(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_id) local: vec3<u32>,
    @builtin(local_invocation_index) own: u32,
) {
    let picture = bd_seeds_picture;
    // Coordinates before the corner wrap, and are not in the picture either.
    let pixel = id.xy - bd_seeds_origin(picture.side, picture.frame);
    let inside = pixel.x < picture.width && pixel.y < picture.height;
    let place = pixel.y * picture.width + pixel.x;
    var seed = 0u;
    bd_seeds_found[own] = 0x7fffffff;
    if inside {
        seed = bd_seeds_held[place];
        if place < arrayLength(&bd_seeds_estimates) {
            bd_seeds_found[own] = bd_seeds_ordered(bd_seeds_estimates[place]);
        }
    }
    let tile = bd_seeds_place(picture.frame) + pixel;
    bd_seeds_wanted[own] = bd_scalar_rank(tile.x, tile.y);
    bd_seeds_inside[own] = select(0u, 1u, inside);
    workgroupBarrier();

    // Places in both orders, by counting; of equal estimates the first comes first.
    let first = local.xy & vec2<u32>(~(picture.side - 1u));
    var from_ = 0u;
    var to_ = 0u;
    for (var y = 0u; y < picture.side; y++) {
        for (var x = 0u; x < picture.side; x++) {
            let other = (first.y + y) * 8u + first.x + x;
            if bd_seeds_inside[other] == 0u {
                continue;
            }
            let found = bd_seeds_found[other];
            if found < bd_seeds_found[own] || (found == bd_seeds_found[own] && other < own) {
                from_ += 1u;
            }
            if bd_seeds_wanted[other] < bd_seeds_wanted[own] {
                to_ += 1u;
            }
        }
    }
    let block = (first.y / picture.side * (8u / picture.side) + first.x / picture.side) * picture.side * picture.side;
    if inside {
        bd_seeds_sorted[block + from_] = seed;
    }
    workgroupBarrier();
    if inside {
        bd_seeds_held[place] = bd_seeds_sorted[block + to_];
    }
}

// Swaps seeds between neighbours, so that the order of this frame fits the next: three rounds.
@compute @workgroup_size(8, 8)
fn bd_seeds_retarget_0(@builtin(global_invocation_id) id: vec3<u32>) {
    bd_seeds_swap(0u, id.xy);
}

@compute @workgroup_size(8, 8)
fn bd_seeds_retarget_1(@builtin(global_invocation_id) id: vec3<u32>) {
    bd_seeds_swap(1u, id.xy);
}

@compute @workgroup_size(8, 8)
fn bd_seeds_retarget_2(@builtin(global_invocation_id) id: vec3<u32>) {
    bd_seeds_swap(2u, id.xy);
}

// Pairs are disjoint, and only one of a pair finds the other.
fn bd_seeds_swap(round_: u32, pixel: vec2<u32>) {
    let picture = bd_seeds_picture;
    let tile = bd_seeds_place(picture.frame) + pixel;
    let step_ = bd_seeds_partner(round_, tile.x, tile.y);
    let partner = pixel + bitcast<vec2<u32>>(step_);
    let here = pixel.x < picture.width && pixel.y < picture.height;
    let there = partner.x < picture.width && partner.y < picture.height;
    if here && there && any(step_ != vec2<i32>(0)) {
        let p = pixel.y * picture.width + pixel.x;
        let q = partner.y * picture.width + partner.x;
        let seed = bd_seeds_held[p];
        bd_seeds_held[p] = bd_seeds_held[q];
        bd_seeds_held[q] = seed;
    }
}
