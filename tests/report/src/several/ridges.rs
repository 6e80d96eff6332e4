//! Linear forms of eight numbers, many at once: whatever is cut or bent along a direction starts with one.

/// `weights · x + offset`, K times; laid out so that a compiler does several at a time.
#[derive(Debug)]
pub struct Ridges<const K: usize> {
    weights: [[f32; K]; 8],
    offsets: [f32; K],
}

impl<const K: usize> Ridges<K> {
    /// Each form by what `make(k)` returns: weights and offset.
    pub fn new(mut make: impl FnMut(usize) -> ([f64; 8], f64)) -> Self {
        let mut all = Self { weights: [[0.0; K]; 8], offsets: [0.0; K] };
        for k in 0..K {
            let (weights, offset) = make(k);
            for (to, weight) in all.weights.iter_mut().zip(weights) {
                to[k] = weight as f32;
            }
            all.offsets[k] = offset as f32;
        }
        all
    }

    #[inline(always)]
    pub fn at(&self, x: &[f32; 8]) -> [f32; K] {
        let mut out = self.offsets;
        for (weights, x) in self.weights.iter().zip(x) {
            for (out, weight) in out.iter_mut().zip(weights) {
                *out += weight * x;
            }
        }
        out
    }
}

/// A normal of two numbers, put where dimensions `at` are.
pub fn spread(normal: [f64; 2], at: [usize; 2]) -> [f64; 8] {
    let mut weights = [0.0; 8];
    weights[at[0]] = normal[0];
    weights[at[1]] = normal[1];
    weights
}
