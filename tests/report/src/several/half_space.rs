//! Half-spaces: the unit cube cut by a plane of random direction, and its volume.

use crate::analysis::random::Random;

/// Where `normal · x < distance`, in some of eight dimensions; the other components are zero.
#[derive(Clone, Copy, Debug)]
pub struct HalfSpace {
    pub normal: [f64; 8],
    pub distance: f64,
}

impl HalfSpace {
    /// A random direction in `dimensions`, through a random point of the inner cube. No component is so small that
    /// [`Self::volume`] would lose its digits.
    pub fn random(random: &mut Random, dimensions: &[usize]) -> Self {
        loop {
            let mut normal = [0.0; 8];
            let mut distance = 0.0;
            for &d in dimensions {
                normal[d] = random.normal();
                distance += normal[d] * random.between(0.2, 0.8);
            }
            if dimensions.iter().all(|&d| normal[d].abs() > 0.15) {
                return Self { normal, distance };
            }
        }
    }

    /// The part of the unit cube inside: inclusion and exclusion of its corners, after mirroring negative axes.
    pub fn volume(&self) -> f64 {
        let normal: Vec<f64> = self.normal.iter().copied().filter(|a| *a != 0.0).collect();
        let count = normal.len();
        let distance = self.distance - normal.iter().map(|a| a.min(0.0)).sum::<f64>();
        let corner = |set: u32| {
            let reach: f64 = (0..count).filter(|k| set >> k & 1 == 1).map(|k| normal[k].abs()).sum();
            let sign = if set.count_ones().is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * (distance - reach).max(0.0).powi(count as i32)
        };
        let factorial: f64 = (1..=count).map(|k| k as f64).product();
        (0..1u32 << count).map(corner).sum::<f64>() / factorial / normal.iter().map(|a| a.abs()).product::<f64>()
    }
}

#[cfg(test)]
mod checks {
    use super::*;

    /// Volumes against plain counting, in one dimension more than a formula could be guessed for.
    #[test]
    fn half_spaces_have_their_volume() {
        let mut random = Random::new(11);
        for _ in 0..8 {
            let space = HalfSpace::random(&mut random, &[0, 2, 5, 7]);
            let (mut inside, count) = (0, 40_000);
            for _ in 0..count {
                inside += u32::from(space.normal.iter().map(|a| a * random.uniform()).sum::<f64>() < space.distance);
            }
            let found = f64::from(inside) / f64::from(count);
            assert!((found - space.volume()).abs() < 0.012, "{space:?}: {found}, {}", space.volume());
        }
        assert!((HalfSpace { normal: [1.0; 8], distance: 4.0 }.volume() - 0.5).abs() < 1e-12);
        assert!((HalfSpace { normal: [-1.0; 8], distance: 0.0 }.volume() - 1.0).abs() < 1e-12);
    }
}
