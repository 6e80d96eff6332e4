//! What a viewer or a denoiser does to an error image, as factors on its power at every frequency.

use crate::field::{PIXELS, SIZE};

/// A filter of weight 1 with periodic borders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Filter {
    /// Standard deviation in pixels.
    Gauss(f64),
    /// A square of this odd side in pixels.
    Box(usize),
}

/// All filters that are measured.
pub const FILTERS: [Filter; 9] = [
    Filter::Gauss(1.0),
    Filter::Gauss(1.485),
    Filter::Gauss(2.1),
    Filter::Gauss(0.7),
    Filter::Gauss(4.0),
    Filter::Box(3),
    Filter::Box(5),
    Filter::Gauss(2.0),
    Filter::Gauss(8.0),
];

/// The place of the filter of the main tables.
pub const SIGMA_1: usize = Filter::Gauss(1.0).place();

impl Filter {
    /// Its place in [`FILTERS`].
    pub const fn place(self) -> usize {
        let mut k = 0;
        while k < FILTERS.len() {
            match (self, FILTERS[k]) {
                (Self::Gauss(a), Self::Gauss(b)) if a == b => return k,
                (Self::Box(a), Self::Box(b)) if a == b => return k,
                _ => k += 1,
            }
        }
        panic!("this filter is not measured")
    }

    pub fn name(self) -> String {
        match self {
            Self::Gauss(sigma) => format!("{sigma}"),
            Self::Box(side) => format!("box {side}"),
        }
    }

    /// The weights of one axis on a circle of `SIZE` pixels, summing to 1; entry 0 is the centre.
    fn weights(self) -> Vec<f64> {
        match self {
            Self::Gauss(sigma) => crate::analysis::error::kernel_1d(SIZE, sigma),
            Self::Box(side) => {
                let reach = side / 2;
                (0..SIZE).map(|d| if d <= reach || d >= SIZE - reach { 1.0 / side as f64 } else { 0.0 }).collect()
            }
        }
    }

    /// What it leaves of white noise of variance 1, as a standard deviation.
    pub fn norm(self) -> f64 {
        self.weights().iter().map(|weight| weight * weight).sum()
    }

    /// Its real response at each frequency of one axis.
    fn response(self) -> Vec<f64> {
        let weights = self.weights();
        let turn = std::f64::consts::TAU / SIZE as f64;
        (0..SIZE)
            .map(|k| weights.iter().enumerate().map(|(d, w)| w * (turn * (k * d % SIZE) as f64).cos()).sum())
            .collect()
    }
}

/// The factors of all filters on the power at each frequency, row by row.
pub fn factors() -> Vec<[f32; FILTERS.len()]> {
    let responses = FILTERS.map(Filter::response);
    (0..PIXELS).map(|p| responses.each_ref().map(|h| (h[p % SIZE] * h[p / SIZE]).powi(2) as f32)).collect()
}
