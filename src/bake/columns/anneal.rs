//! Simulated annealing of the digits that pixels flip.
//!
//! ```text
//! E = (Σ over lanes of (weightₗ·Jₗ)ᵖ)^(1/p), Jₗ the mean over the sets; plus what the mean spectra exceed a limit by
//! repeat: change the word of one digit of one set; keep it if E grows by less than −T ln(random)
//! ```
//! A lane is a family of integrands at a number of samples; p = 1 for one number, and large where the worst of all
//! numbers counts. T falls geometrically.

use super::net::{Duals, ROWS};
use super::power::{DIGITS, SIDE};
use super::response::{BLOCK, FREQUENCIES, FUNCTIONS, Responses};
use super::{COUNTS, FAMILIES};
use crate::linear::BLOCK_LOG2;

/// For each number and digit, the bits of the coordinates that flip it: x below, y above. A Walsh function of the block.
pub type Map = [[u16; ROWS]; 2];

const LANES: usize = 20;
type Lanes = [f32; LANES];

/// The last temperature, in parts of the first.
const LAST: f64 = 0.004;

/// SplitMix64 (Steele, Lea and Flood 2014), written out so that its stream never changes.
pub struct Random(u64);

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0xd1b5_4a32_d192_ed03))
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In 0..count.
    pub fn below(&mut self, count: usize) -> usize {
        (((self.bits() >> 32) * count as u64) >> 32) as usize
    }
}

/// A map without any merit.
pub fn random_map(seed: u64) -> Map {
    let mut random = Random::new(seed);
    [[0; ROWS]; 2].map(|row: [u16; ROWS]| row.map(|_| random.below(FUNCTIONS) as u16))
}

/// The XOR of the words of every set of digits.
pub fn sums(words: &[u16; ROWS]) -> [u16; SIDE] {
    let mut sums = [0; SIDE];
    let mut set = 1;
    while set < SIDE {
        sums[set] = sums[set & (set - 1)] ^ words[set.trailing_zeros() as usize];
        set += 1;
    }
    sums
}

/// How a character counts in spectra: its power, the largest number of samples that leaves it over, and whether it
/// belongs to lines along an axis.
struct Loudness {
    power: f32,
    depth: usize,
    along_axis: bool,
}

/// Power on every Walsh function of the block, by depth; then that of lines along an axis.
type Histogram = Vec<Vec<f32>>;

/// One search.
pub struct Anneal<'a> {
    responses: &'a Responses,
    characters: Vec<[u16; 2]>,
    /// What each adds to the lanes, times its response.
    shares: Vec<Lanes>,
    rest: Lanes,
    loudness: Vec<Loudness>,
    power: i32,
    penalty: f64,
    /// Times the mean of a spectrum, where it begins to be a spike: for all characters together, and for those of lines
    /// along an axis, which are few.
    limits: [f32; 2],
}

impl<'a> Anneal<'a> {
    /// Of the characters of `duals`, m = 0, 1, …, the quietest `1 − keep` of which count as white. `lane(m, family)` says
    /// where a family is summed, and its weight.
    pub fn new(
        duals: &[Duals],
        responses: &'a Responses,
        lane: impl Fn(usize, usize) -> Option<(usize, f64)>,
        keep: f32,
        power: i32,
    ) -> Self {
        let mut rest = [0.0; LANES];
        let mut all = std::collections::BTreeMap::<[u16; 2], (Lanes, Loudness)>::new();
        for (m, dual) in duals.iter().enumerate() {
            for family in 0..FAMILIES {
                let Some((lane, weight)) = lane(m, family) else { continue };
                rest[lane] = (dual.rest[family] * weight) as f32;
                for (c, power) in dual.characters.iter().zip(&dual.power) {
                    let along_axis = c[0] == 0 || c[1] == 0;
                    let new = || ([0.0; LANES], Loudness { power: power[0], depth: m, along_axis });
                    let entry = all.entry(*c).or_insert_with(new);
                    entry.0[lane] = power[family] * weight as f32;
                    entry.1.depth = m;
                }
            }
        }
        let total = |lanes: &Lanes| lanes.iter().sum::<f32>();
        let mut sorted: Vec<_> = all.into_iter().collect();
        sorted.sort_by(|(a, (x, _)), (b, (y, _))| total(y).total_cmp(&total(x)).then(a.cmp(b)));
        let whole: f32 = sorted.iter().map(|(_, (lanes, _))| total(lanes)).sum();
        let (mut count, mut kept) = (0, 0.0);
        while count < sorted.len() && kept < keep * whole {
            kept += total(&sorted[count].1.0);
            count += 1;
        }
        for (_, (lanes, _)) in sorted.drain(count..) {
            rest.iter_mut().zip(lanes).for_each(|(rest, share)| *rest += share);
        }
        let mut search = Self {
            responses,
            characters: Vec::new(),
            shares: Vec::new(),
            rest,
            loudness: Vec::new(),
            power,
            penalty: 0.0,
            limits: [0.0; 2],
        };
        for (c, (lanes, loudness)) in sorted {
            search.characters.push(c);
            search.shares.push(lanes);
            search.loudness.push(loudness);
        }
        search
    }

    /// From now on the mean square of what spectra exceed their limits by counts as well: for all characters together,
    /// and for those of lines along an axis, which are few. The mean of a spectrum is 1.
    pub fn limit_spectrum(&mut self, penalty: f64, limits: [f32; 2]) {
        (self.penalty, self.limits) = (penalty, limits);
    }

    /// Improves the maps; returns the least energy, which is theirs.
    pub fn run(&self, maps: &mut [Map], seed: u64, tries: usize, heat: f64) -> f64 {
        let mut random = Random::new(seed);
        let count = maps.len();
        let mut lanes: Vec<Lanes> = maps.iter().map(|map| self.lanes(map)).collect();
        let mut histograms: Vec<Histogram> = maps.iter().map(|map| self.histogram(map)).collect();
        let (mut energy, mut excess) = (self.energy(&lanes), self.excess(&histograms));
        let mut best = (energy + excess, maps.to_vec());
        for done in 0..tries * count {
            let temperature = heat / count as f64 * libm::pow(LAST, done as f64 / (tries * count) as f64);
            let at = random.below(count);
            let mut map = maps[at];
            change(&mut map, &mut random);
            let limit = -temperature * libm::log(random.uniform().max(1e-12));
            let old_lanes = core::mem::replace(&mut lanes[at], self.lanes(&map));
            let new_energy = self.energy(&lanes);
            // The excess falls by no more than what there is.
            if new_energy - energy > limit + excess {
                lanes[at] = old_lanes;
                continue;
            }
            if self.penalty > 0.0 {
                let old = core::mem::replace(&mut histograms[at], self.histogram(&map));
                let new_excess = self.excess(&histograms);
                if new_energy + new_excess - energy - excess > limit {
                    lanes[at] = old_lanes;
                    histograms[at] = old;
                    continue;
                }
                excess = new_excess;
            }
            energy = new_energy;
            maps[at] = map;
            if energy + excess < best.0 {
                best = (energy + excess, maps.to_vec());
            }
        }
        maps.copy_from_slice(&best.1);
        best.0
    }

    /// The largest of each spectrum, its mean 1.
    pub fn spikes(&self, maps: &[Map]) -> Vec<f32> {
        let histograms: Vec<Histogram> = maps.iter().map(|map| self.histogram(map)).collect();
        self.spectra(&histograms).into_iter().map(|(_, s)| s.into_iter().fold(0.0, f32::max)).collect()
    }

    fn lanes(&self, map: &Map) -> Lanes {
        let sums = map.each_ref().map(sums);
        let mut total = self.rest;
        for (c, share) in self.characters.iter().zip(&self.shares) {
            let function = sums[0][usize::from(c[0])] ^ sums[1][usize::from(c[1])];
            let left = self.responses.both[usize::from(function)];
            for lane in 0..LANES {
                total[lane] += left * share[lane];
            }
        }
        total
    }

    fn energy(&self, lanes: &[Lanes]) -> f64 {
        let mut sum = 0.0;
        for lane in 0..LANES {
            let mean = lanes.iter().map(|lanes| f64::from(lanes[lane])).sum::<f64>() / lanes.len() as f64;
            let mut power = mean;
            for _ in 1..self.power {
                power *= mean;
            }
            sum += power;
        }
        if self.power == 1 { sum } else { libm::pow(sum, f64::from(self.power).recip()) }
    }

    fn histogram(&self, map: &Map) -> Histogram {
        let sums = map.each_ref().map(sums);
        let mut histogram = vec![vec![0f32; FUNCTIONS]; 2 * COUNTS];
        for (c, loud) in self.characters.iter().zip(&self.loudness) {
            let function = usize::from(sums[0][usize::from(c[0])] ^ sums[1][usize::from(c[1])]);
            histogram[loud.depth][function] += loud.power;
            if loud.along_axis {
                histogram[COUNTS + loud.depth][function] += loud.power;
            }
        }
        histogram
    }

    fn excess(&self, histograms: &[Histogram]) -> f64 {
        if self.penalty == 0.0 {
            return 0.0;
        }
        let spectra = self.spectra(histograms);
        let over = |(which, spectrum): &(usize, Vec<f32>)| -> f64 {
            let over = |&s: &f32| f64::from((s - self.limits[*which]).max(0.0));
            spectrum.iter().map(|s| over(s) * over(s)).sum()
        };
        let sum: f64 = spectra.iter().map(over).sum();
        self.penalty * sum / (spectra.len() * FREQUENCIES * FREQUENCIES) as f64
    }

    /// Mean spectra over the sets, a set and its transpose, of what as many samples or more leave over: of all (0), and
    /// of lines along an axis (1).
    fn spectra(&self, histograms: &[Histogram]) -> Vec<(usize, Vec<f32>)> {
        let mut spectra = Vec::new();
        for which in 0..2 {
            let mut power = vec![0f32; FUNCTIONS];
            for depth in (0..COUNTS).rev() {
                for histogram in histograms {
                    power.iter_mut().zip(&histogram[which * COUNTS + depth]).for_each(|(sum, p)| *sum += p);
                }
                spectra.extend(self.spectrum(&power).map(|spectrum| (which, spectrum)));
            }
        }
        spectra
    }

    /// On a triangle of frequencies, the mean 1; none where there is no power.
    fn spectrum(&self, power: &[f32]) -> Option<Vec<f32>> {
        let total: f32 = power.iter().sum();
        if total == 0.0 {
            return None;
        }
        let mut whole = [[0f32; FREQUENCIES]; FREQUENCIES];
        for (wy, row) in power.chunks_exact(BLOCK).enumerate() {
            let mut along = [0f32; FREQUENCIES];
            for (p, spectrum) in row.iter().zip(&self.responses.spectra).filter(|(p, _)| **p != 0.0) {
                along.iter_mut().zip(spectrum).for_each(|(sum, s)| *sum += p * s);
            }
            for (line, s) in whole.iter_mut().zip(&self.responses.spectra[wy]) {
                line.iter_mut().zip(&along).for_each(|(sum, a)| *sum += s * a);
            }
        }
        let triangle = (0..FREQUENCIES).flat_map(|y| (0..=y).map(move |x| (x, y)));
        Some(triangle.map(|(x, y)| 0.5 * (whole[y][x] + whole[x][y]) / total).collect())
    }
}

/// Another word for one digit, most often for one of the first.
fn change(map: &mut Map, random: &mut Random) {
    let bit = |random: &mut Random| 1u16 << random.below(2 * BLOCK_LOG2 as usize);
    let number = random.below(2);
    let digit = random.below(DIGITS).min(random.below(DIGITS));
    let by = match random.below(4) {
        0 => bit(random),
        1 => bit(random) | bit(random),
        2 => {
            let other = (random.below(2), random.below(DIGITS));
            if other == (number, digit) { 0 } else { map[other.0][other.1] }
        }
        _ => random.below(FUNCTIONS) as u16,
    };
    map[number][digit] ^= by;
}
