//! The training integrands: functions of a sum n·x of some numbers. The evaluation uses others, from other seeds.

use crate::random::Random;

/// f(n·x).
#[derive(Clone, Debug)]
pub struct Ridge {
    /// A unit vector.
    pub normal: Vec<f64>,
    profile: Profile,
}

#[derive(Clone, Copy, Debug)]
enum Profile {
    /// A half-space.
    Step {
        at: f64,
    },
    /// The edge of a soft shadow.
    SoftStep {
        at: f64,
        width: f64,
    },
    Wave {
        frequency: f64,
        phase: f64,
    },
}

/// A function of one number by samples at the centres of equal cells.
#[derive(Debug)]
pub struct Table {
    values: Vec<f64>,
}

/// Sums of five numbers times a unit vector lie inside.
const REACH: f64 = 3.0;
const CELLS: usize = 2048;
const CELL: f64 = 2.0 * REACH / CELLS as f64;

impl Table {
    /// Linear between the centres.
    pub fn at(&self, s: f64) -> f64 {
        let t = (s + REACH) / CELL - 0.5;
        let i = (t.max(0.0) as usize).min(CELLS - 2);
        self.values[i] + (t - i as f64) * (self.values[i + 1] - self.values[i])
    }

    /// The mean over x in [0, 1] of the function at s + `step`·x.
    fn averaged(&self, step: f64) -> Self {
        let mut sums = vec![0.0; CELLS + 1];
        for (i, value) in self.values.iter().enumerate() {
            sums[i + 1] = sums[i] + value;
        }
        let integral = |s: f64| {
            let t = ((s + REACH) / CELL).clamp(0.0, CELLS as f64);
            let i = (t as usize).min(CELLS - 1);
            (sums[i] + (t - i as f64) * self.values[i]) * CELL
        };
        let mean = |i: usize| {
            let s = -REACH + (i as f64 + 0.5) * CELL;
            let (from, to) = (s.min(s + step).max(-REACH), s.max(s + step).min(REACH));
            if to - from < CELL { self.values[i] } else { (integral(to) - integral(from)) / (to - from) }
        };
        Self { values: (0..CELLS).map(mean).collect() }
    }
}

impl Ridge {
    /// A half-space through a random point, or something smooth.
    pub fn random(random: &mut Random, dimensions: usize, smooth: bool) -> Self {
        let normal: Vec<f64> = (0..dimensions).map(|_| random.normal()).collect();
        let length = libm::sqrt(normal.iter().map(|a| a * a).sum());
        let normal: Vec<f64> = normal.iter().map(|a| a / length).collect();
        let at = normal.iter().map(|a| a * random.uniform()).sum();
        let profile = if !smooth {
            Profile::Step { at }
        } else if random.below(2) == 0 {
            let width = (0.3 + 0.3 * random.uniform()) * libm::sqrt(dimensions as f64 / 2.0);
            Profile::SoftStep { at, width }
        } else {
            let phase = core::f64::consts::TAU * random.uniform();
            Profile::Wave { frequency: 1.5 + 2.5 * random.uniform(), phase }
        };
        Self { normal, profile }
    }

    /// At a sum.
    pub fn of_sum(&self, s: f64) -> f64 {
        match self.profile {
            Profile::Step { at } => f64::from(u8::from(s < at)),
            Profile::SoftStep { at, width } => {
                let t = ((s - at) / width + 0.5).clamp(0.0, 1.0);
                t * t * (3.0 - 2.0 * t)
            }
            Profile::Wave { frequency, phase } => libm::sin(frequency * s + phase),
        }
    }

    /// The mean over all but the first `kept` numbers, as a function of the sum over those.
    pub fn projected(&self, kept: usize) -> Table {
        let all = Table { values: (0..CELLS).map(|i| self.of_sum(-REACH + (i as f64 + 0.5) * CELL)).collect() };
        self.normal[kept..].iter().fold(all, |table, &step| table.averaged(step))
    }
}
