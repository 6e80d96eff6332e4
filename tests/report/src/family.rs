//! The two families of integrands of every error figure, all of them evaluated at once for a point.
//!
//! They are those of `tests/analysis/integrands.rs`, which a test compares with; here in `f32` and laid out so that a
//! compiler does several at a time.

use crate::analysis::half_plane::HalfPlane;
use crate::analysis::integrands::{DRAWS, Integrand2, smooth_2d};
use crate::analysis::random::{Random, seeds};
use crate::analysis::soft_edge::SoftEdge;

/// Functions without a random part; every draw of the family holds them once.
pub const FIXED: usize = 6;
const EDGES: usize = 4 * DRAWS as usize;
/// Smooth integrands: the fixed ones, then the soft edges of all draws.
pub const SMOOTH: usize = FIXED + EDGES;
/// Half-planes.
pub const LINES: usize = 64;
/// All integrands, the smooth ones first. Even, and so are both parts: spectra are taken in pairs.
pub const ALL: usize = SMOOTH + LINES;

/// One of the two families.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Smooth,
    HalfPlanes,
}

impl Family {
    pub const BOTH: [Self; 2] = [Self::Smooth, Self::HalfPlanes];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Smooth => "smooth",
            Self::HalfPlanes => "half-planes",
        }
    }

    /// Its places in the order of all integrands.
    pub const fn range(self) -> core::ops::Range<usize> {
        match self {
            Self::Smooth => 0..SMOOTH,
            Self::HalfPlanes => SMOOTH..ALL,
        }
    }

    /// How often an integrand counts: the fixed ones are in every draw.
    pub const fn weight(integrand: usize) -> f64 {
        if integrand < FIXED { DRAWS as f64 } else { 1.0 }
    }
}

/// The parameters of all integrands.
#[derive(Debug)]
pub struct Integrands {
    /// Exact values.
    pub exact: [f64; ALL],
    exact_f32: [f32; SMOOTH],
    /// x, y, 1 → position across the edge, 0..1.
    edges: [[f32; EDGES]; 3],
    /// x, y, 1 → signed distance from the line.
    lines: [[f32; LINES]; 3],
}

impl Integrands {
    /// Those of all figures.
    pub fn new() -> Self {
        let mut exact = [0.0; ALL];
        let mut edges = [[0.0; EDGES]; 3];
        for (k, Integrand2 { exact: value, .. }) in smooth_2d(seeds::SMOOTH_2D).iter().take(FIXED).enumerate() {
            exact[k] = *value;
        }
        for draw in 0..DRAWS as usize {
            let mut random = Random::new(seeds::SMOOTH_2D + draw as u64);
            for k in 4 * draw..4 * draw + 4 {
                let edge = SoftEdge::random(&mut random);
                exact[FIXED + k] = edge.integral();
                edges[0][k] = (edge.normal[0] / edge.width) as f32;
                edges[1][k] = (edge.normal[1] / edge.width) as f32;
                edges[2][k] = (0.5 - edge.distance / edge.width) as f32;
            }
        }
        let mut lines = [[0.0; LINES]; 3];
        let mut random = Random::new(seeds::HALF_PLANE_2D);
        for k in 0..LINES {
            let plane = HalfPlane::random(&mut random);
            exact[SMOOTH + k] = plane.area();
            lines[0][k] = plane.normal[0] as f32;
            lines[1][k] = plane.normal[1] as f32;
            lines[2][k] = -plane.distance as f32;
        }
        Self { exact_f32: core::array::from_fn(|k| exact[k] as f32), exact, edges, lines }
    }

    /// Adds to every sum its integrand's value at a point minus the exact value: small sums, small rounding errors. The
    /// half-planes count, exactly; their exact values are left to [`Self::errors`].
    #[inline]
    pub fn add(&self, [x, y]: [f32; 2], sums: &mut [f32; ALL]) {
        let (smooth, lines) = sums.split_at_mut(SMOOTH);
        let (fixed, edges) = smooth.split_at_mut(FIXED);
        let values = [
            x * y,
            (-x * x - y * y).exp(),
            x,
            x * x,
            (core::f32::consts::PI * (x + y)).sin(),
            0.3 + 0.5 * x - 0.8 * y + 0.9 * x * y,
        ];
        for ((sum, value), exact) in fixed.iter_mut().zip(values).zip(&self.exact_f32) {
            *sum += value - exact;
        }
        let [a, b, c] = &self.edges;
        for k in 0..EDGES {
            let t = a[k] * x + b[k] * y + c[k];
            // Not `clamp`: these two are one instruction each.
            let t = if t > 0.0 { t } else { 0.0 };
            let t = if t < 1.0 { t } else { 1.0 };
            edges[k] += t * t * (3.0 - 2.0 * t) - self.exact_f32[FIXED + k];
        }
        let [a, b, c] = &self.lines;
        for k in 0..LINES {
            lines[k] += if a[k] * x + b[k] * y + c[k] < 0.0 { 1.0 } else { 0.0 };
        }
    }

    /// The errors of the means of points that weigh so much together: each 1, if `sums` are plain.
    #[inline]
    pub fn errors(&self, sums: &[f32; ALL], weight: f64) -> [f32; ALL] {
        let scale = 1.0 / weight;
        core::array::from_fn(|k| {
            let mean = f64::from(sums[k]) * scale;
            (if k < SMOOTH { mean } else { mean - self.exact[k] }) as f32
        })
    }
}
