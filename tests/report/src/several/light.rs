//! Direct light: a number picks one of two triangles, a pair the point on it; what arrives at a receiver that looks up,
//! with or without a straight edge in the way.

use super::family::Id;
use crate::analysis::random::Random;

/// Receivers, each with its own two triangles.
pub const COUNT: usize = Id::Light.count();

/// One triangle of every receiver, a row a number.
#[derive(Debug, Default)]
struct Triangles {
    corner: [[f32; COUNT]; 3],
    sides: [[[f32; COUNT]; 3]; 2],
    /// Its normal times twice its area (the pick) and its radiance.
    normal: [[f32; COUNT]; 3],
}

/// All receivers.
#[derive(Debug)]
pub struct Light {
    triangles: [Triangles; 2],
    /// Light that comes from `edge · point < 0` is blocked; zeros block nothing.
    edge: [[f32; COUNT]; 3],
}

impl Light {
    pub fn new(random: &mut Random) -> Self {
        let mut all = Self { triangles: Default::default(), edge: [[0.0; COUNT]; 3] };
        for k in 0..COUNT {
            let mut middles = [[0.0; 3]; 2];
            for (triangles, middle) in all.triangles.iter_mut().zip(&mut middles) {
                *middle = [random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(1.2, 2.2)];
                let side = |random: &mut Random| [0; 3].map(|_| random.between(-0.6, 0.6));
                let sides = [side(random), side(random)];
                let [a, b] = sides;
                let radiance = random.between(0.4, 1.6);
                let across = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                for c in 0..3 {
                    triangles.corner[c][k] = (middle[c] - (a[c] + b[c]) / 3.0) as f32;
                    triangles.sides[0][c][k] = a[c] as f32;
                    triangles.sides[1][c][k] = b[c] as f32;
                    triangles.normal[c][k] = (across[c] * radiance) as f32;
                }
            }
            // Every second receiver has an edge, across the middle of one of its triangles.
            let [x, y, z] = middles[k / 2 % 2];
            let along: [f64; 3] = [0; 3].map(|_| random.normal());
            if k % 2 == 1 {
                let edge = [y * along[2] - z * along[1], z * along[0] - x * along[2], x * along[1] - y * along[0]];
                (0..3).for_each(|c| all.edge[c][k] = edge[c] as f32);
            }
        }
        all
    }

    /// What arrives at each receiver from the point of one triangle.
    #[inline(always)]
    pub fn at(&self, pick: f32, point: [f32; 2]) -> [f32; COUNT] {
        let Triangles { corner, sides, normal } = &self.triangles[usize::from(pick >= 0.5)];
        let [u, v, _] = bluedither::warp::triangle(point);
        core::array::from_fn(|k| {
            let [x, y, z]: [f32; 3] = core::array::from_fn(|c| corner[c][k] + u * sides[0][c][k] + v * sides[1][c][k]);
            let squared = x * x + y * y + z * z;
            let facing = (normal[0][k] * x + normal[1][k] * y + normal[2][k] * z).abs();
            let above = if z > 0.0 { z } else { 0.0 };
            let lit = if self.edge[0][k] * x + self.edge[1][k] * y + self.edge[2][k] * z < 0.0 { 0.0 } else { 1.0 };
            lit * above * facing / (squared * squared)
        })
    }
}
