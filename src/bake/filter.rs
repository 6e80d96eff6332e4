//! The filter that a renderer or a display puts behind the mask, as part of the recipe (Donnelly et al. 2024, "FAST").
//!
//! A filter f leaves of an error image e the power Σ (f ⋆ f)(p − q)·e_p·e_q: what two pixels do to each other is the
//! autocorrelation of the filter. So that is the kernel by which void-and-cluster orders them.
//!
//! ```text
//! box of n pixels       (n − |d|)/n along each axis
//! binomial, n taps      C(2n − 2, n − 1 − d), over that of d = 0
//! Gaussian, sigma       exp(−d²/4σ²)
//! moving average, part  (1 − part)^|t| in time
//! ```
//! A space and a time filter multiply: what is far in both matters little.

use super::inputs;
use super::recipe::OWN;
use super::void_and_cluster::Window;

/// Of space, of time, or both: what is not named is as in the default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filter {
    /// Over the pixels of a frame.
    pub space: Space,
    /// Thousandths of every new frame that an exponential moving average takes.
    pub ema: u32,
}

/// A filter over pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Standard deviation in thousandths of a pixel.
    Gaussian(u32),
    /// Pixels on a side.
    Box(u32),
    /// Taps along an axis.
    Binomial(u32),
}

impl Default for Filter {
    /// The commonest of their kinds: a blur of 3×3 pixels, and temporal anti-aliasing that takes a tenth.
    fn default() -> Self {
        Self { space: Space::Box(3), ema: 100 }
    }
}

/// What can be written, for the line that refuses what cannot.
pub const CURE: &str = "set it to gaussian:SIGMA (0.5 to 4), box:SIDE (2 to 15), binomial:TAPS (2 to 15), ema:PART \
                        (0.02 to 1), or one over pixels and ema joined by +, or unset it";

impl Filter {
    /// As in `gaussian:1.5`, `ema:0.1` or `box:5+ema:0.2`.
    pub fn parse(text: &str) -> Option<Self> {
        let mut filter = Self::default();
        let (mut spaces, mut times) = (0, 0);
        for word in text.split('+') {
            let (kind, number) = word.split_once(':')?;
            match kind {
                "ema" => {
                    filter.ema = thousandths(number, 20, 1000)?;
                    times += 1;
                }
                _ => {
                    filter.space = match kind {
                        "gaussian" => Space::Gaussian(thousandths(number, 500, 4000)?),
                        "box" => Space::Box(whole(number)?),
                        "binomial" => Space::Binomial(whole(number)?),
                        _ => return None,
                    };
                    spaces += 1;
                }
            }
        }
        (spaces < 2 && times < 2).then_some(filter)
    }

    /// In one way only, whatever way it was written.
    pub fn name(self) -> String {
        let space = match self.space {
            Space::Gaussian(sigma) => format!("gaussian:{}", f64::from(sigma) / 1000.0),
            Space::Box(side) => format!("box:{side}"),
            Space::Binomial(taps) => format!("binomial:{taps}"),
        };
        format!("{space}+ema:{}", f64::from(self.ema) / 1000.0)
    }

    /// The kernel of still masks.
    pub fn still(self) -> Window {
        let (radius, scale) = (self.space.radius(), scale(self.space.total()));
        Window::new(radius, |dx, dy| libm::round(scale * self.space.kernel(dx, dy)) as i32)
    }

    /// The kernels of masks for 2^`frames_log2` frames, by distance in time.
    ///
    /// By the product alone a single frame would have a third more error, and without the space filter the moving
    /// average would be white; so what a still mask and a pixel's own sequence need is added.
    pub fn over_time(self, frames_log2: u32) -> Vec<Window> {
        let (frames, radius) = (1usize << frames_log2, self.space.radius());
        let time: Vec<f64> = (0..=frames / 2).map(|t| self.repeated(t, frames)).collect();
        let scale = scale(self.space.total() * (1.0 + 2.0 * time.iter().sum::<f64>()) + 2.0 * time.iter().sum::<f64>());
        let window = |t: usize| {
            Window::new(radius, move |dx, dy| {
                let space = self.space.kernel(dx, dy);
                let own = match (t, dx + dy) {
                    (0, _) => space,
                    (_, 0) => OWN * self.repeated(t, frames),
                    _ => 0.0,
                };
                // Half of the frames away, forwards and backwards are the same.
                let part = if 2 * t == frames { 0.5 } else { 1.0 };
                libm::round(scale * part * (space * self.repeated(t, frames) + own)) as i32
            })
        };
        (0..=frames / 2).map(window).collect()
    }

    /// The autocorrelation of the moving average at t frames' distance when they come again after `frames`, over that
    /// at 0.
    fn repeated(self, t: usize, frames: usize) -> f64 {
        let kept = 1.0 - f64::from(self.ema) / 1000.0;
        let power = |t: usize| (0..t).fold(1.0, |power, _| power * kept);
        (power(t) + power(frames - t)) / (1.0 + power(frames))
    }
}

impl Space {
    /// Where the kernel ends.
    fn radius(self) -> usize {
        match self {
            // What is left out is below a part in 200.
            Self::Gaussian(sigma) => (sigma as usize * 46).div_ceil(10_000).max(6),
            Self::Box(side) => side as usize - 1,
            Self::Binomial(taps) => (taps as usize - 1).max(6),
        }
    }

    /// The weight of two pixels.
    ///
    /// Gaussians let hardly anything of the highest frequencies through and say nothing of neighbours: a part of a
    /// narrow one is added. Without it smooth integrands have two and a half times the error after a Gaussian of 2
    /// pixels; boxes, which do let it through, lose a tenth by it.
    fn kernel(self, dx: usize, dy: usize) -> f64 {
        let both = self.along(dx) * self.along(dy);
        let narrow = || libm::exp(-((dx * dx + dy * dy) as f64) / inputs::NARROW);
        if matches!(self, Self::Box(_)) { both } else { both + narrow() }
    }

    /// The autocorrelation along an axis, over that at 0.
    pub fn along(self, d: usize) -> f64 {
        let d = d as f64;
        match self {
            Self::Gaussian(sigma) => libm::exp(-d * d / (4e-6 * f64::from(sigma) * f64::from(sigma))),
            Self::Box(side) => (1.0 - d / f64::from(side)).max(0.0),
            Self::Binomial(taps) => {
                let half = f64::from(taps) - 1.0;
                let mut weight = 1.0;
                let mut step = 0.0;
                while step < d {
                    weight *= (half - step) / (half + step + 1.0);
                    step += 1.0;
                }
                weight
            }
        }
    }

    /// Of all weights.
    fn total(self) -> f64 {
        let distances = || (0..=2 * self.radius()).map(|i| i.abs_diff(self.radius()));
        distances().flat_map(|dy| distances().map(move |dx| self.kernel(dx, dy))).sum()
    }
}

/// Weights up to 2²⁰, as far as their sum stays below 2²⁸.
fn scale(total: f64) -> f64 {
    (268_435_456.0 / total).min(1_048_576.0)
}

fn thousandths(text: &str, least: u32, most: u32) -> Option<u32> {
    let number: f64 = text.parse().ok()?;
    let inside = number >= f64::from(least) / 1000.0 && number <= f64::from(most) / 1000.0;
    inside.then(|| libm::round(1000.0 * number) as u32)
}

fn whole(text: &str) -> Option<u32> {
    text.parse().ok().filter(|number| (2..=15).contains(number))
}
