//! A soft shadow: a smooth step across a straight edge of random direction, integrated over the unit square exactly.

use super::random::Random;

/// 3t² − 2t³ of the distance to a line, from 0 to 1 over `width`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SoftEdge {
    /// Unit normal.
    pub(crate) normal: [f64; 2],
    /// Distance of the middle of the edge from the origin, along the normal.
    pub(crate) distance: f64,
    /// From all dark to all light.
    pub(crate) width: f64,
}

impl SoftEdge {
    /// A random direction, a point of the square on the middle of the edge, a width of .3 to .6.
    pub(crate) fn random(random: &mut Random) -> Self {
        let angle = random.between(0.0, core::f64::consts::TAU);
        let normal = [libm::cos(angle), libm::sin(angle)];
        let point = [random.uniform(), random.uniform()];
        Self { normal, distance: normal[0] * point[0] + normal[1] * point[1], width: random.between(0.3, 0.6) }
    }

    /// The light at a point.
    pub(crate) fn value(&self, [x, y]: [f64; 2]) -> f64 {
        self.profile(self.normal[0] * x + self.normal[1] * y)
    }

    /// The integral over the unit square.
    ///
    /// The distance along the normal of a uniform point is a sum of two uniform numbers: its density is a trapezoid.
    /// Profile times trapezoid is a polynomial of degree 4 between breaks, which three Gauss points integrate exactly.
    pub(crate) fn integral(&self) -> f64 {
        let [a, b] = self.normal;
        let low = a.min(0.0) + b.min(0.0);
        let (narrow, wide) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
        let density = |t: f64| {
            let t = t - low;
            let ramp = if narrow > 0.0 { t.min(narrow + wide - t) / narrow } else { 1.0 };
            ramp.clamp(0.0, 1.0) / wide
        };
        let mut breaks = [
            low,
            low + narrow,
            low + wide,
            low + narrow + wide,
            (self.distance - 0.5 * self.width).clamp(low, low + narrow + wide),
            (self.distance + 0.5 * self.width).clamp(low, low + narrow + wide),
        ];
        breaks.sort_by(f64::total_cmp);
        breaks.windows(2).map(|ends| gauss_3(ends[0], ends[1], |t| density(t) * self.profile(t))).sum()
    }

    fn profile(&self, t: f64) -> f64 {
        let t = ((t - self.distance) / self.width + 0.5).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }
}

/// Three-point Gauss–Legendre quadrature: exact up to degree 5.
fn gauss_3(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let reach = half * 0.6f64.sqrt();
    half / 9.0 * (5.0 * f(middle - reach) + 8.0 * f(middle) + 5.0 * f(middle + reach))
}
