// A small ray tracer: spheres on a floor under a rectangular light, seen through a thin lens. SAMPLER in its names is
// replaced by a sampler's word, for each shader: that is all that differs.

struct View {
    size: vec2<u32>,
    seed: u32,
    spp: u32,
    frame: u32,
    // The first sample, and how many.
    first: u32,
    count: u32,
    // Bit 0: the lens is sampled; bit 1: the light. What is not is a point.
    sampled: u32,
    // Keep what is there and add to it.
    add: u32,
}

const LENS = 0u;
const LIGHT = 1u;

@group(0) @binding(13) var<storage> balls: array<Ball>;
@group(0) @binding(14) var<uniform> view: View;
// Sums of radiance, and in w the number of samples.
@group(0) @binding(15) var<storage, read_write> image: array<vec4<f32>>;

struct Ball {
    centre: vec3<f32>,
    radius: f32,
    albedo: vec3<f32>,
    gloss: f32,
}

struct Ray {
    origin: vec3<f32>,
    way: vec3<f32>,
}

struct Hit {
    distance: f32,
    normal: vec3<f32>,
    albedo: vec3<f32>,
    gloss: f32,
}

const FAR = 1e9;
const LAMP = vec3<f32>(-2.2, 5.2, 2.6);
const LAMP_X = vec3<f32>(2.0, 0.0, 1.2);
const LAMP_Y = vec3<f32>(-0.7, 0.9, 1.6);

@compute @workgroup_size(8, 8)
fn render(@builtin(global_invocation_id) id: vec3<u32>) {
    if any(id.xy >= view.size) {
        return;
    }
    let sampler_ = bd_SAMPLER_with_spp(view.seed, view.spp);
    let pixel = bd_SAMPLER_pixel(sampler_, id.x, id.y, view.frame);
    var sum = vec3<f32>(0.0);
    for (var index = view.first; index < view.first + view.count; index++) {
        let lens = select(vec2<f32>(0.5), bd_SAMPLER_draw2(pixel, LENS, index), (view.sampled & 1u) != 0u);
        let light = select(vec2<f32>(0.5), bd_SAMPLER_draw2(pixel, LIGHT, index), (view.sampled & 2u) != 0u);
        sum += radiance(camera(vec2<f32>(id.xy) + 0.5, lens), light);
    }
    let place = id.y * view.size.x + id.x;
    let before = select(vec4<f32>(0.0), image[place], view.add != 0u);
    image[place] = before + vec4<f32>(sum, f32(view.count));
}

// Through a point of the lens, and through the point that the pixel sees in the plane of focus.
fn camera(pixel: vec2<f32>, lens: vec2<f32>) -> Ray {
    let eye = vec3<f32>(0.0, 1.55, 6.2);
    let ahead = normalize(vec3<f32>(0.0, 0.62, 0.0) - eye);
    let right = normalize(cross(ahead, vec3<f32>(0.0, 1.0, 0.0)));
    let up = cross(right, ahead);
    let size = vec2<f32>(view.size);
    let plane = (2.0 * pixel - size) / size.y * 0.36;
    let focus = eye + 5.4 * (ahead + plane.x * right - plane.y * up);
    let on_disk = disk(lens) * 0.16;
    let origin = eye + on_disk.x * right + on_disk.y * up;
    return Ray(origin, normalize(focus - origin));
}

// From the square to the disk, areas kept (Shirley and Chiu 1997).
fn disk(point: vec2<f32>) -> vec2<f32> {
    let p = 2.0 * point - 1.0;
    if p.x == 0.0 && p.y == 0.0 {
        return p;
    }
    if abs(p.x) > abs(p.y) {
        let angle = 0.7853981634 * p.y / p.x;
        return p.x * vec2<f32>(cos(angle), sin(angle));
    }
    let angle = 1.5707963268 - 0.7853981634 * p.x / p.y;
    return p.y * vec2<f32>(cos(angle), sin(angle));
}

fn radiance(ray: Ray, light: vec2<f32>) -> vec3<f32> {
    let hit = nearest(ray);
    if hit.distance == FAR {
        return sky(ray.way);
    }
    let point = ray.origin + hit.distance * ray.way;
    var seen = lit(point, hit, light);
    let haze = 1.0 - exp(-0.00035 * pow(hit.distance, 2.5));
    if hit.gloss > 0.0 {
        // One mirror, stronger at grazing angles.
        let mirrored = Ray(point + 1e-3 * hit.normal, reflect(ray.way, hit.normal));
        let facing = 1.0 - max(dot(hit.normal, -ray.way), 0.0);
        let share = hit.gloss + (1.0 - hit.gloss) * pow(facing, 5.0);
        let other = nearest(mirrored);
        var reflected = sky(mirrored.way);
        if other.distance < FAR {
            reflected = lit(mirrored.origin + other.distance * mirrored.way, other, light);
        }
        seen = mix(seen, reflected, share);
    }
    return mix(seen, sky(ray.way), haze);
}

// Light from a point of the lamp, if nothing is between, and a little from the sky.
fn lit(point: vec3<f32>, hit: Hit, light: vec2<f32>) -> vec3<f32> {
    let on_lamp = LAMP + (2.0 * light.x - 1.0) * LAMP_X + (2.0 * light.y - 1.0) * LAMP_Y;
    let to_lamp = on_lamp - point;
    let way = normalize(to_lamp);
    let lamp_normal = normalize(cross(LAMP_Y, LAMP_X));
    let cosines = max(dot(hit.normal, way), 0.0) * abs(dot(lamp_normal, way));
    var direct = 22.0 * cosines / dot(to_lamp, to_lamp);
    if direct > 0.0 && hidden(Ray(point + 1e-3 * hit.normal, to_lamp)) {
        direct = 0.0;
    }
    let ambient = mix(0.18, 0.34, 0.5 + 0.5 * hit.normal.y);
    return hit.albedo * (vec3<f32>(1.0, 0.95, 0.88) * direct + vec3<f32>(0.75, 0.88, 1.0) * ambient);
}

fn sky(way: vec3<f32>) -> vec3<f32> {
    let height = smoothstep(-0.05, 0.5, way.y);
    return mix(vec3<f32>(0.66, 0.68, 0.70), vec3<f32>(0.22, 0.34, 0.52), height);
}

fn nearest(ray: Ray) -> Hit {
    var hit = Hit(FAR, vec3<f32>(0.0), vec3<f32>(0.0), 0.0);
    if ray.way.y < 0.0 {
        let distance = -ray.origin.y / ray.way.y;
        let point = ray.origin + distance * ray.way;
        if dot(point.xz, point.xz) < 1600.0 {
            let tiles = floor(point.xz * 0.6);
            let odd = abs(tiles.x + tiles.y) % 2.0;
            let albedo = mix(vec3<f32>(0.46, 0.45, 0.43), vec3<f32>(0.60, 0.58, 0.55), odd);
            hit = Hit(distance, vec3<f32>(0.0, 1.0, 0.0), albedo, 0.0);
        }
    }
    for (var k = 0u; k < arrayLength(&balls); k++) {
        let distance = meets(ray, balls[k]);
        if distance > 0.0 && distance < hit.distance {
            let normal = (ray.origin + distance * ray.way - balls[k].centre) / balls[k].radius;
            hit = Hit(distance, normal, balls[k].albedo, balls[k].gloss);
        }
    }
    return hit;
}

// Whether a ball is on the way, which ends at 1.
fn hidden(ray: Ray) -> bool {
    for (var k = 0u; k < arrayLength(&balls); k++) {
        let distance = meets(ray, balls[k]);
        if distance > 0.0 && distance < 1.0 {
            return true;
        }
    }
    return false;
}

// How far a ball is, in lengths of the ray's way; 0 if it is not met.
fn meets(ray: Ray, ball: Ball) -> f32 {
    let to_ball = ball.centre - ray.origin;
    let length_2 = dot(ray.way, ray.way);
    let middle = dot(to_ball, ray.way) / length_2;
    let miss = to_ball - middle * ray.way;
    let half_2 = ball.radius * ball.radius - dot(miss, miss);
    if half_2 <= 0.0 {
        return 0.0;
    }
    let half_chord = sqrt(half_2 / length_2);
    return select(middle - half_chord, 0.0, middle - half_chord < 1e-4);
}
