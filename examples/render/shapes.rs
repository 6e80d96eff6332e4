//! What the scene is made of: spheres that may move, a rectangle of light, a camera with a thin lens.

use bluedither::warp;
use glam::Vec3A;

pub struct Ray {
    pub origin: Vec3A,
    pub direction: Vec3A,
}

pub struct Sphere {
    pub centre: Vec3A,
    pub radius: f32,
    /// The way it goes while the shutter is open.
    pub motion: Vec3A,
    pub albedo: Vec3A,
    /// Reflectance at normal incidence.
    pub gloss: f32,
}

/// Rectangle of light: a corner, two sides, the side that shines, radiance.
pub struct Light {
    corner: Vec3A,
    sides: [Vec3A; 2],
    pub normal: Vec3A,
    pub area: f32,
    pub radiance: Vec3A,
}

pub struct Camera {
    eye: Vec3A,
    right: Vec3A,
    up: Vec3A,
    forward: Vec3A,
    lens_radius: f32,
    focus: f32,
}

impl Sphere {
    #[inline]
    pub fn at(&self, time: f32) -> Vec3A {
        self.centre + (time - 0.5) * self.motion
    }

    #[inline]
    pub fn intersect(&self, ray: &Ray, time: f32) -> Option<f32> {
        let towards = self.at(time) - ray.origin;
        let along = towards.dot(ray.direction);
        let root2 = self.radius * self.radius - (towards - along * ray.direction).length_squared();
        if root2 < 0.0 {
            return None;
        }
        let distance = along - root2.sqrt();
        (distance > 0.0).then_some(distance)
    }

    /// The cosine-weighted share of the hemisphere that the sphere hides: nearly, at the horizon; nothing from afar.
    pub fn occlusion(&self, point: Vec3A, normal: Vec3A, time: f32) -> f32 {
        const AFAR: f32 = 0.02;
        let towards = self.at(time) - point;
        let distance2 = towards.length_squared();
        let share = self.radius * self.radius / distance2 - AFAR;
        let height = normal.dot(towards);
        if share <= 0.0 || height <= 0.0 { 0.0 } else { share.min(1.0) * height / distance2.sqrt() }
    }
}

impl Light {
    pub fn new(centre: Vec3A, side_u: Vec3A, side_v: Vec3A, radiance: f32) -> Self {
        let normal = side_v.cross(side_u);
        let normal = if normal.y > 0.0 { -normal } else { normal };
        Self {
            corner: centre - 0.5 * (side_u + side_v),
            sides: [side_u, side_v],
            normal: normal.normalize(),
            area: normal.length(),
            radiance: radiance * Vec3A::new(1.0, 0.93, 0.82),
        }
    }

    #[inline]
    pub fn point(&self, [u, v]: [f32; 2]) -> Vec3A {
        self.corner + u * self.sides[0] + v * self.sides[1]
    }

    pub fn is_hit(&self, ray: &Ray) -> bool {
        let distance = self.normal.dot(self.corner - ray.origin) / self.normal.dot(ray.direction);
        let at = ray.origin + distance * ray.direction - self.corner;
        // The sides stand at right angles.
        distance > 0.0 && self.sides.iter().all(|side| (0.0..=1.0).contains(&(at.dot(*side) / side.length_squared())))
    }
}

impl Camera {
    /// In focus where it looks at; 32° from top to bottom.
    pub fn look_at(eye: Vec3A, target: Vec3A, lens_radius: f32) -> Self {
        const TAN_HALF_VIEW: f32 = 0.287;
        let forward = (target - eye).normalize();
        let right = forward.cross(Vec3A::Y).normalize();
        let up = right.cross(forward);
        let focus = eye.distance(target);
        Self { eye, right: right * TAN_HALF_VIEW, up: up * TAN_HALF_VIEW, forward, lens_radius, focus }
    }

    /// Through a point of a thin lens to where the ray of its centre meets the plane in focus.
    #[inline]
    pub fn ray(&self, right: f32, up: f32, lens: [f32; 2]) -> Ray {
        let [u, v] = warp::disk(lens).map(|c| c * self.lens_radius / 0.287);
        let moved = u * self.right + v * self.up;
        let target = self.focus * (self.forward + right * self.right + up * self.up);
        Ray { origin: self.eye + moved, direction: (target - moved).normalize() }
    }
}
