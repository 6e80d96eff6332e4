//! How quality is measured: one set of definitions for all tests and reports.
//!
//! An *error image* holds, per pixel, the estimate of an integral minus its exact value. What the eye sees of it is
//! its Gaussian-filtered root mean square, compared with that of the same values in random places (R), or with white
//! noise of the same variance (G). Sigma always is a standard deviation in pixels.
#![allow(dead_code, reason = "every test file and report uses a part of it")]

pub(crate) mod discrepancy;
pub(crate) mod error;
pub(crate) mod half_plane;
pub(crate) mod integrands;
pub(crate) mod net;
pub(crate) mod random;
pub(crate) mod soft_edge;
pub(crate) mod spectrum;

/// The two filter widths of every figure: how far a picture is looked at closely (1.0), or from some steps away (2.1,
/// the constant of Georgiev and Fajardo 2016 taken as a standard deviation). Pixels.
pub(crate) const SIGMAS: [f64; 2] = [1.0, 2.1];
