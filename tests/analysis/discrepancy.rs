//! How evenly a point set fills the unit square.

/// L2-star discrepancy: the root mean square, over boxes [0, a)×[0, b), of the share of points inside minus the area.
///
/// Closed form of Warnock 1972: D² = 1/9 − (1/2n)·Σ(1−x²)(1−y²) + (1/n²)·ΣΣ(1−max x)(1−max y). O(n²).
pub(crate) fn l2_star(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let single: f64 = points.iter().map(|[x, y]| (1.0 - x * x) * (1.0 - y * y)).sum();
    let double: f64 = points
        .iter()
        .map(|[x, y]| points.iter().map(|[u, v]| (1.0 - x.max(*u)) * (1.0 - y.max(*v))).sum::<f64>())
        .sum();
    // Rounding may leave a perfect set just below zero.
    (1.0 / 9.0 - single / (2.0 * n) + double / (n * n)).max(0.0).sqrt()
}
