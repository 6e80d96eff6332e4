//! A hard shadow: the unit square cut by a straight line, its lit area by polygon clipping.

use super::random::Random;

/// The points whose distance along the normal is below that of the line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfPlane {
    /// Unit normal, pointing out of the lit side.
    pub(crate) normal: [f64; 2],
    /// Distance of the line from the origin, along the normal.
    pub(crate) distance: f64,
}

impl HalfPlane {
    /// A line of random direction through a random point of the square.
    pub(crate) fn random(random: &mut Random) -> Self {
        let angle = random.between(0.0, core::f64::consts::TAU);
        let normal = [libm::cos(angle), libm::sin(angle)];
        let point = [random.uniform(), random.uniform()];
        Self { normal, distance: normal[0] * point[0] + normal[1] * point[1] }
    }

    /// 1 on the lit side, else 0.
    pub(crate) fn value(&self, point: [f64; 2]) -> f64 {
        if self.height(point) < 0.0 { 1.0 } else { 0.0 }
    }

    /// The lit area of the unit square: clip it (Sutherland and Hodgman 1974), then sum the trapezoids.
    pub(crate) fn area(&self) -> f64 {
        const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let mut clipped = Vec::with_capacity(6);
        for (k, &from) in SQUARE.iter().enumerate() {
            let to = SQUARE[(k + 1) % 4];
            let (h_from, h_to) = (self.height(from), self.height(to));
            if h_from < 0.0 {
                clipped.push(from);
            }
            if (h_from < 0.0) != (h_to < 0.0) {
                let t = h_from / (h_from - h_to);
                clipped.push([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
            }
        }
        let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - q[0] * p[1];
        (0..clipped.len()).map(|k| 0.5 * cross(clipped[k], clipped[(k + 1) % clipped.len()])).sum()
    }

    /// Signed distance from the line; negative on the lit side.
    fn height(&self, [x, y]: [f64; 2]) -> f64 {
        self.normal[0] * x + self.normal[1] * y - self.distance
    }
}
