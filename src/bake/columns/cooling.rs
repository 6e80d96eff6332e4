//! Simulated annealing of a small state whose cost is computed anew after every change.

use super::anneal::Random;

/// The least cost found, and its state. A change that costs Δ more is kept with a chance of exp(−Δ/T); T falls from `heat`
/// with the square of the steps that are left. A cost and a change a step.
pub fn cool<T: Copy>(
    mut state: T,
    steps: usize,
    heat: f64,
    random: &mut Random,
    change: impl Fn(&mut T, &mut Random),
    cost: impl Fn(&T) -> f64,
) -> (f64, T) {
    let mut current = cost(&state);
    let mut best = (current, state);
    for step in 0..steps {
        let left = 1.0 - step as f64 / steps as f64;
        let before = state;
        change(&mut state, random);
        let new = cost(&state);
        if new - current < -heat * left * left * libm::log(random.uniform().max(1e-12)) {
            current = new;
            if current < best.0 {
                best = (current, state);
            }
        } else {
            state = before;
        }
    }
    best
}
