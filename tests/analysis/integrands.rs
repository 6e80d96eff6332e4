//! The integrands of the evaluation: four families of known integrals over the unit interval or square.
//!
//! *Smooth* families stand for soft light, *step* families for shadow edges. They are drawn from a seed, so that they
//! can be outside everything that an optimiser has seen; the `evaluation_*` sets are the ones of all figures.

use super::half_plane::HalfPlane;
use super::random::{Random, seeds};
use super::soft_edge::SoftEdge;

/// A function and its exact integral.
pub(crate) struct Integrand<P> {
    /// What it is, for messages.
    pub(crate) name: String,
    value: Box<dyn Fn(P) -> f64 + Send + Sync>,
    /// The exact integral over the unit interval or square.
    pub(crate) exact: f64,
}

/// A function over [0, 1).
pub(crate) type Integrand1 = Integrand<f64>;
/// A function over [0, 1)².
pub(crate) type Integrand2 = Integrand<[f64; 2]>;

impl<P> Integrand<P> {
    /// One of your own.
    pub(crate) fn new(name: String, exact: f64, value: impl Fn(P) -> f64 + Send + Sync + 'static) -> Self {
        Self { name, value: Box::new(value), exact }
    }

    /// The function's value.
    pub(crate) fn at(&self, point: P) -> f64 {
        (self.value)(point)
    }
}

/// 12 of exp(−((x−a)/b)²) + c·√(x+.01): a uniform in [0, 1], b in [.15, .65], c normal.
pub(crate) fn smooth_1d(seed: u64) -> Vec<Integrand1> {
    let mut random = Random::new(seed);
    let smooth = |_| {
        let (a, b, c) = (random.uniform(), random.between(0.15, 0.65), random.normal());
        let bump = 0.5 * b * core::f64::consts::PI.sqrt() * (libm::erf((1.0 - a) / b) + libm::erf(a / b));
        let root = 2.0 / 3.0 * (libm::pow(1.01, 1.5) - libm::pow(0.01, 1.5));
        Integrand::new(format!("bump {a:.3} {b:.3} {c:.3}"), bump + c * root, move |x: f64| {
            let t = (x - a) / b;
            libm::exp(-t * t) + c * (x + 0.01).sqrt()
        })
    };
    (0..12).map(smooth).collect()
}

/// 24 thresholds in [.05, .95], lit below and lit above in turn.
///
/// The same threshold lit on the other side has the same error with the other sign, so each is taken once.
pub(crate) fn step_1d(seed: u64) -> Vec<Integrand1> {
    let mut random = Random::new(seed);
    let step = |k| {
        let t = random.between(0.05, 0.95);
        if k % 2 == 0 {
            Integrand::new(format!("x < {t:.3}"), t, move |x| f64::from(u8::from(x < t)))
        } else {
            Integrand::new(format!("x ≥ {t:.3}"), 1.0 - t, move |x| f64::from(u8::from(x >= t)))
        }
    };
    (0..24).map(step).collect()
}

/// xy, exp(−x²−y²), x, x², sin π(x+y), .3+.5x−.8y+.9xy, and four soft edges.
pub(crate) fn smooth_2d(seed: u64) -> Vec<Integrand2> {
    use core::f64::consts::PI;
    // ∫exp(−x²) over [0, 1].
    let gauss = 0.5 * PI.sqrt() * libm::erf(1.0);
    let mut all = vec![
        Integrand::new("xy".into(), 0.25, |[x, y]: [f64; 2]| x * y),
        Integrand::new("exp(-x²-y²)".into(), gauss * gauss, |[x, y]: [f64; 2]| libm::exp(-x * x - y * y)),
        Integrand::new("x".into(), 0.5, |[x, _]: [f64; 2]| x),
        Integrand::new("x²".into(), 1.0 / 3.0, |[x, _]: [f64; 2]| x * x),
        Integrand::new("sin π(x+y)".into(), 0.0, |[x, y]: [f64; 2]| libm::sin(PI * (x + y))),
        Integrand::new("bilinear".into(), 0.3 + 0.25 - 0.4 + 0.225, |[x, y]: [f64; 2]| {
            0.3 + 0.5 * x - 0.8 * y + 0.9 * x * y
        }),
    ];
    let mut random = Random::new(seed);
    all.extend((0..4).map(|k| {
        let edge = SoftEdge::random(&mut random);
        Integrand::new(format!("soft edge {k}"), edge.integral(), move |p| edge.value(p))
    }));
    all
}

/// 64 lines of random direction through random points of the square.
pub(crate) fn half_plane_2d(seed: u64) -> Vec<Integrand2> {
    let mut random = Random::new(seed);
    let half_plane = |k| {
        let plane = HalfPlane::random(&mut random);
        Integrand::new(format!("half-plane {k}"), plane.area(), move |p| plane.value(p))
    };
    (0..64).map(half_plane).collect()
}

/// How often the small families are drawn for a figure. One draw of them alone moves R by 5 to 15 %: a soft edge near
/// a corner, a bump near a border. The 64 half-planes are enough as they are.
pub(crate) const DRAWS: u64 = 8;

/// The smooth 1D family of all figures.
pub(crate) fn evaluation_smooth_1d() -> Vec<Integrand1> {
    (0..DRAWS).flat_map(|draw| smooth_1d(seeds::SMOOTH_1D + draw)).collect()
}

/// The 1D thresholds of all figures.
pub(crate) fn evaluation_step_1d() -> Vec<Integrand1> {
    (0..DRAWS).flat_map(|draw| step_1d(seeds::STEP_1D + draw)).collect()
}

/// The smooth 2D family of all figures.
pub(crate) fn evaluation_smooth_2d() -> Vec<Integrand2> {
    (0..DRAWS).flat_map(|draw| smooth_2d(seeds::SMOOTH_2D + draw)).collect()
}

/// The half-planes of all figures.
pub(crate) fn evaluation_half_plane_2d() -> Vec<Integrand2> {
    half_plane_2d(seeds::HALF_PLANE_2D)
}
