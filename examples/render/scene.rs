//! A small scene with one purpose for each kind of sample: a moving sphere (time, 1D), an open lens (2D) and a
//! rectangular light (2D), over a tiled ground.
//!
//! A sample costs one camera ray, one shadow ray and, on glossy spheres, one reflected ray with its shadow. Pixels are
//! points, so that all noise comes from the three domains. Radiance is linear.

use crate::shapes::{Camera, Light, Ray, Sphere};
use glam::{Vec3A, vec3a};

/// The numbers that one sample takes, each in [0, 1).
#[derive(Clone, Copy)]
pub struct Sample {
    pub time: f32,
    pub lens: [f32; 2],
    pub light: [f32; 2],
}

/// Which domains are sampled; the others stay at their centre.
#[derive(Clone, Copy)]
pub struct Dimensions {
    pub time: bool,
    pub lens: bool,
    pub light: bool,
}

impl Sample {
    /// Only the dimensions in use; the others at their centre.
    pub fn only(self, dimensions: Dimensions) -> Self {
        Self {
            time: if dimensions.time { self.time } else { 0.5 },
            lens: if dimensions.lens { self.lens } else { [0.5; 2] },
            light: if dimensions.light { self.light } else { [0.5; 2] },
        }
    }
}

struct Hit {
    point: Vec3A,
    normal: Vec3A,
    albedo: Vec3A,
    gloss: f32,
    /// Its place in the list of spheres; `None` is the ground.
    sphere: Option<usize>,
}

pub struct Scene {
    width: u32,
    height: u32,
    camera: Camera,
    light: Light,
    spheres: Vec<Sphere>,
}

const HAZE: Vec3A = vec3a(0.030, 0.042, 0.068);

impl Scene {
    /// The scene for an image of this size.
    pub fn new(width: u32, height: u32) -> Self {
        let ball = |centre: [f32; 2], radius: f32, albedo: [f32; 3], gloss: f32| Sphere {
            centre: vec3a(centre[0], radius, centre[1]),
            radius,
            motion: Vec3A::ZERO,
            albedo: albedo.into(),
            gloss,
        };
        let mut moving = ball([1.75, 0.9], 0.46, [0.93, 0.62, 0.08], 0.03);
        moving.centre.y = 0.8;
        moving.motion = vec3a(0.85, 0.25, 0.0);
        let spheres = vec![
            ball([-0.35, 0.0], 1.0, [0.66, 0.055, 0.04], 0.05),
            ball([0.62, 2.1], 0.32, [0.88, 0.85, 0.78], 0.04),
            ball([-1.75, 2.7], 0.42, [0.06, 0.42, 0.40], 0.04),
            ball([-2.9, -3.4], 1.15, [0.62, 0.60, 0.56], 0.04),
            ball([1.6, -3.6], 0.9, [0.05, 0.14, 0.45], 0.05),
            ball([4.6, -7.0], 1.3, [0.70, 0.26, 0.06], 0.04),
            ball([-0.9, -8.5], 1.0, [0.16, 0.44, 0.20], 0.04),
            moving,
        ];
        Self {
            width,
            height,
            camera: Camera::look_at(vec3a(0.35, 2.0, 8.2), vec3a(0.05, 0.72, 0.0), 0.17),
            light: Light::new(vec3a(-3.0, 5.2, 2.2), vec3a(2.4, 0.0, 2.4), vec3a(1.3, 1.7, -1.3), 14.0),
            spheres,
        }
    }

    /// Radiance that one sample of pixel (x, y) finds.
    #[inline]
    pub fn radiance(&self, x: u32, y: u32, sample: Sample) -> Vec3A {
        let scale = 2.0 / self.height as f32;
        let right = (x as f32 + 0.5 - 0.5 * self.width as f32) * scale;
        let up = (0.5 * self.height as f32 - y as f32 - 0.5) * scale;
        let ray = self.camera.ray(right, up, sample.lens);
        let Some(hit) = self.nearest(&ray, sample.time) else {
            return sky(ray.direction);
        };
        let mut radiance = self.shade(&hit, sample);
        if hit.gloss > 0.0 {
            let cosine = -hit.normal.dot(ray.direction);
            let fresnel = hit.gloss + (1.0 - hit.gloss) * (1.0 - cosine.max(0.0)).powi(5);
            let direction = ray.direction + 2.0 * cosine * hit.normal;
            let mirrored = Ray { origin: hit.point + 1e-3 * hit.normal, direction };
            radiance = radiance.lerp(self.mirrored(&mirrored, sample), fresnel);
        }
        haze(radiance, ray.origin.distance(hit.point))
    }

    /// What a glossy sphere mirrors: the light itself, other things without their own gloss, the sky.
    fn mirrored(&self, ray: &Ray, sample: Sample) -> Vec3A {
        match self.nearest(ray, sample.time) {
            Some(hit) => haze(self.shade(&hit, sample), ray.origin.distance(hit.point)),
            None if self.light.is_hit(ray) => 0.5 * self.light.radiance,
            None => sky(ray.direction),
        }
    }

    /// Diffuse reflection: one point of the light with a shadow ray, and a little ambient light.
    fn shade(&self, hit: &Hit, sample: Sample) -> Vec3A {
        let mut ambient = 0.5 + 0.5 * hit.normal.y;
        for (i, sphere) in self.spheres.iter().enumerate() {
            if hit.sphere != Some(i) {
                ambient *= 1.0 - sphere.occlusion(hit.point, hit.normal, sample.time);
            }
        }
        let mut irradiance = ambient * vec3a(0.20, 0.27, 0.40);

        let towards = self.light.point(sample.light) - hit.point;
        let distance2 = towards.length_squared();
        let direction = towards / distance2.sqrt();
        let cosines = hit.normal.dot(direction).max(0.0) * (-self.light.normal.dot(direction)).max(0.0);
        if cosines > 0.0 {
            let shadow = Ray { origin: hit.point + 1e-3 * hit.normal, direction };
            if !self.spheres.iter().any(|sphere| sphere.intersect(&shadow, sample.time).is_some()) {
                irradiance += cosines * self.light.area / distance2 * self.light.radiance;
            }
        }
        hit.albedo * irradiance * core::f32::consts::FRAC_1_PI
    }

    fn nearest(&self, ray: &Ray, time: f32) -> Option<Hit> {
        let mut nearest = if ray.direction.y < 0.0 { -ray.origin.y / ray.direction.y } else { f32::INFINITY };
        let mut found = None;
        for (i, sphere) in self.spheres.iter().enumerate() {
            if let Some(distance) = sphere.intersect(ray, time).filter(|distance| *distance < nearest) {
                (nearest, found) = (distance, Some(i));
            }
        }
        if nearest > 60.0 {
            return None;
        }
        let point = ray.origin + nearest * ray.direction;
        Some(match found {
            Some(i) => {
                let Sphere { albedo, gloss, radius, .. } = self.spheres[i];
                Hit { point, normal: (point - self.spheres[i].at(time)) / radius, albedo, gloss, sphere: found }
            }
            None => Hit { point, normal: Vec3A::Y, albedo: tiles(point, nearest), gloss: 0.0, sphere: None },
        })
    }
}

/// Two-coloured tiles whose edges soften with the distance, so that points need no filter.
fn tiles(point: Vec3A, distance: f32) -> Vec3A {
    let wave = (point.x * 2.6).sin() * (point.z * 2.6).sin();
    let edge = 0.02 + 0.012 * distance;
    let blend = (0.5 + wave / edge * 0.25).clamp(0.0, 1.0);
    let contrast = 1.0 / (1.0 + (distance / 22.0).powi(4));
    let mean = vec3a(0.45, 0.42, 0.38);
    mean.lerp(vec3a(0.30, 0.29, 0.29).lerp(vec3a(0.60, 0.55, 0.47), blend), contrast)
}

fn sky(direction: Vec3A) -> Vec3A {
    HAZE.lerp(vec3a(0.010, 0.016, 0.032), (direction.y * 3.0).clamp(0.0, 1.0))
}

fn haze(radiance: Vec3A, distance: f32) -> Vec3A {
    HAZE.lerp(radiance, (-(distance / 28.0).powi(2)).exp())
}
