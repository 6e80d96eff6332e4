//! A closed room under a wide lamp, by paths of ten bounces: twenty dimensions a sample.
//!
//! Every bounce is diffuse and none connects to the lamp: what a path is worth shows when it happens to get there.

use bluedither::warp;
use glam::{Vec3A, vec3a};

/// Diffuse bounces of a path.
pub const BOUNCES: u32 = 10;

/// Half the sides of the room.
const HALF: Vec3A = vec3a(1.3, 1.0, 1.6);

/// Where a path meets something, how much that reflects, how much it emits.
struct Hit {
    point: Vec3A,
    normal: Vec3A,
    albedo: f32,
    emitted: f32,
}

/// Luminance that one path through the centre of pixel (x, y) finds. `pan` moves the camera sideways, in pixels;
/// `pair(k)` are two numbers for bounce k.
pub fn luminance([x, y]: [u32; 2], size: [u32; 2], pan: f32, pair: impl Fn(u32) -> [f32; 2]) -> f32 {
    let scale = 0.62 * 2.0 / size[1] as f32;
    let right = (x as f32 + 0.5 - 0.5 * size[0] as f32 + pan) * scale;
    let up = (0.5 * size[1] as f32 - y as f32 - 0.5) * scale;
    let mut hit = nearest(vec3a(0.0, -0.1, 1.55), vec3a(right, up, -1.0).normalize());
    let (mut found, mut carried) = (hit.emitted, 1.0);
    for bounce in 0..BOUNCES {
        carried *= hit.albedo;
        let direction = around(hit.normal, warp::cosine_hemisphere(pair(bounce)));
        hit = nearest(hit.point + 1e-4 * hit.normal, direction);
        found += carried * hit.emitted;
    }
    found
}

/// A direction given in a frame that turns slowly with the normal (Duff and others 2017).
fn around(n: Vec3A, [u, v, w]: [f32; 3]) -> Vec3A {
    let sign = 1f32.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    let tangent = vec3a(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
    let bitangent = vec3a(b, sign + n.y * n.y * a, -n.y);
    u * tangent + v * bitangent + w * n
}

fn nearest(origin: Vec3A, direction: Vec3A) -> Hit {
    // Out through the first of three walls.
    let walls = (HALF * direction.signum() - origin) / direction;
    let distance = walls.min_element();
    let through = Vec3A::select(walls.cmpeq(Vec3A::splat(distance)), -direction.signum(), Vec3A::ZERO);
    let (point, normal) = (origin + distance * direction, through.normalize());
    let off = vec3a(point.x, 0.0, point.z + 0.2).length_squared();
    let emitted = if normal.y < -0.5 { 2.0 * (-off / 1.5).exp() } else { 0.0 };
    Hit { point, normal, albedo: if normal.x > 0.5 { 0.36 } else { 0.6 }, emitted }
}
