//! A small path tracer: a box that is open in front, two spheres, a lamp in the ceiling; all diffuse, light by
//! luminance.
//!
//! Every vertex of a path connects to a point of the lamp. The numbers of a vertex are one domain, those of the camera
//! and of the first vertex together.

use bluedither::warp;
use glam::{Vec3A, vec3a};

/// Luminance and half the sides of the lamp.
const RADIANCE: f32 = 12.0;
const LAMP: [f32; 2] = [0.35, 0.28];
/// What a display shows of it: as it is, its few edge pixels would outweigh the picture.
const SHOWN: f32 = 1.0;
/// What the walls reflect: left, right, floor, ceiling, back.
const WALLS: [f32; 5] = [0.55, 0.35, 0.7, 0.7, 0.65];
/// Centre, radius, what it reflects.
const SPHERES: [(Vec3A, f32, f32); 2] = [(vec3a(-0.4, -0.62, -0.35), 0.38, 0.75), (vec3a(0.42, -0.7, 0.25), 0.3, 0.45)];
const EYE: Vec3A = vec3a(0.0, 0.0, 3.45);
/// The opening fills the picture.
const TAN_HALF_VIEW: f32 = 0.4;

struct Hit {
    point: Vec3A,
    normal: Vec3A,
    albedo: f32,
}

/// What one path finds that starts at a place of the picture, both coordinates within 0 and 1. `numbers(k)` are those
/// of vertex k: a point of the lamp, the next direction. A path of one vertex is direct light.
pub fn luminance(place: [f32; 2], vertices: u32, numbers: impl Fn(u32) -> [[f32; 2]; 2]) -> f32 {
    let [right, up] = [2.0 * place[0] - 1.0, 1.0 - 2.0 * place[1]].map(|c| c * TAN_HALF_VIEW);
    let (mut origin, mut direction) = (EYE, vec3a(right, up, -1.0).normalize());
    let (mut found, mut carried) = (0.0, 1.0);
    for vertex in 0..vertices {
        let Some(hit) = nearest(origin, direction) else { break };
        if vertex == 0 && is_lamp(&hit) {
            return SHOWN;
        }
        let [lamp, next] = numbers(vertex);
        carried *= hit.albedo;
        found += carried * direct(&hit, lamp);
        let [u, v, w] = warp::cosine_hemisphere(next);
        let (tangent, bitangent) = hit.normal.any_orthonormal_pair();
        (origin, direction) = (hit.point + 1e-4 * hit.normal, u * tangent + v * bitangent + w * hit.normal);
    }
    found
}

fn is_lamp(hit: &Hit) -> bool {
    hit.normal.y < -0.5 && hit.point.y > 0.999 && hit.point.x.abs() < LAMP[0] && hit.point.z.abs() < LAMP[1]
}

/// Light that arrives from a point of the lamp, over what a white surface would need to be as bright.
fn direct(hit: &Hit, [u, v]: [f32; 2]) -> f32 {
    let lamp = vec3a((2.0 * u - 1.0) * LAMP[0], 0.9999, (2.0 * v - 1.0) * LAMP[1]);
    let towards = lamp - hit.point;
    let squared = towards.length_squared();
    let direction = towards / squared.sqrt();
    let cosines = hit.normal.dot(direction).max(0.0) * direction.y.max(0.0);
    let area = 4.0 * LAMP[0] * LAMP[1];
    let blocked = || {
        let origin = hit.point + 1e-4 * hit.normal;
        SPHERES.iter().any(|sphere| intersect(sphere, origin, direction).is_some_and(|t| t * t < squared))
    };
    if cosines <= 0.0 || blocked() { 0.0 } else { RADIANCE * area * cosines / squared * core::f32::consts::FRAC_1_PI }
}

fn intersect((centre, radius, _): &(Vec3A, f32, f32), origin: Vec3A, direction: Vec3A) -> Option<f32> {
    let towards = *centre - origin;
    let along = towards.dot(direction);
    let root2 = radius * radius - (towards - along * direction).length_squared();
    let distance = along - root2.max(0.0).sqrt();
    (root2 > 0.0 && distance > 1e-4).then_some(distance)
}

/// A sphere, or out through the first of the walls; nothing through the opening.
fn nearest(origin: Vec3A, direction: Vec3A) -> Option<Hit> {
    let distances = (direction.signum() - origin) / direction;
    let mut distance = distances.min_element();
    let mut sphere = None;
    for candidate in &SPHERES {
        if let Some(t) = intersect(candidate, origin, direction).filter(|t| *t < distance) {
            (distance, sphere) = (t, Some(candidate));
        }
    }
    let point = origin + distance * direction;
    if let Some(&(centre, radius, albedo)) = sphere {
        return Some(Hit { point, normal: (point - centre) / radius, albedo });
    }
    let (normal, albedo) = if distance == distances.x {
        (-direction.signum() * Vec3A::X, WALLS[usize::from(direction.x > 0.0)])
    } else if distance == distances.y {
        (-direction.signum() * Vec3A::Y, WALLS[2 + usize::from(direction.y > 0.0)])
    } else if direction.z < 0.0 {
        (Vec3A::Z, WALLS[4])
    } else {
        return None;
    };
    Some(Hit { point, normal, albedo })
}

#[cfg(test)]
mod checks {
    use super::*;
    use crate::analysis::random::Random;

    /// Below the lamp's middle, where nothing is in the way: the integral over the lamp by a fine grid, and by paths.
    #[test]
    fn direct_light_is_that_of_the_lamp() {
        let hit = nearest(vec3a(0.0, 0.5, 0.95), Vec3A::NEG_Y).expect("the floor");
        assert!((hit.point.y + 1.0).abs() < 1e-6 && hit.normal == Vec3A::Y && hit.albedo == WALLS[2]);
        let mut sum = 0.0;
        for k in 0..10_000 {
            let [u, v] = [k % 100, k / 100].map(|c| (c as f32 + 0.5) / 100.0);
            sum += f64::from(direct(&hit, [u, v]));
        }
        // Small as seen from there: nearly its middle's light.
        let d2: f32 = 4.0 + 0.95 * 0.95;
        let middle = RADIANCE * 4.0 * LAMP[0] * LAMP[1] * (2.0 / d2.sqrt()).powi(2) / d2 / core::f32::consts::PI;
        assert!((sum / 1e4 / f64::from(middle) - 1.0).abs() < 0.03, "{} {middle}", sum / 1e4);
    }

    /// A longer path finds more light, and no path finds none where the lamp itself is seen.
    #[test]
    fn bounces_add_light() {
        let mut random = Random::new(5);
        let mean = |vertices: u32, random: &mut Random| {
            let path = |_| {
                let numbers = core::cell::RefCell::new(&mut *random);
                luminance([0.3, 0.6], vertices, |_| {
                    [[0; 2]; 2].map(|pair| pair.map(|_| numbers.borrow_mut().uniform() as f32))
                })
            };
            (0..4000).map(path).sum::<f32>() / 4000.0
        };
        let [one, two, five] = [1, 2, 5].map(|vertices| mean(vertices, &mut random));
        assert!(0.01 < one && one < two && two < five && five < 4.0 * one, "{one} {two} {five}");
        assert_eq!(luminance([0.5, 0.1375], 1, |_| [[0.5; 2]; 2]), SHOWN);
    }
}
