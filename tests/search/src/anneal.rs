//! Simulated annealing (Kirkpatrick, Gelatt and Vecchi 1983) of a map.

use crate::energy::{Model, Sums, sets};
use crate::map::{Map, NUMBERS};
use crate::random::Random;

/// Rows that are changed most; what lies below is as it fell.
const ROWS: usize = 10;
/// The last temperature in parts of the first one.
const LAST: f64 = 0.003;
/// The first temperature in parts of the first energy.
const HEAT: f64 = 0.01;

/// A map, its tables and its energy.
struct State<'a> {
    models: &'a [Model<'a>],
    map: Map,
    sums: Vec<Vec<Sums>>,
    /// By model and set.
    parts: Vec<Vec<f64>>,
    sets: Vec<Vec<usize>>,
}

impl<'a> State<'a> {
    fn new(models: &'a [Model<'a>], map: Map) -> Self {
        let sums = models.iter().map(|model| (0..NUMBERS).map(|number| model.sums(&map, number)).collect()).collect();
        let sets = sets();
        let mut state = Self { models, map, sums, parts: vec![vec![0.0; sets.len()]; models.len()], sets };
        state.weigh(&[true; NUMBERS]);
        state
    }

    /// The parts of all sets that hold a number that was changed.
    fn weigh(&mut self, changed: &[bool; NUMBERS]) {
        for ((model, sums), parts) in self.models.iter().zip(&self.sums).zip(&mut self.parts) {
            for (part, set) in parts.iter_mut().zip(&self.sets) {
                if set.iter().any(|&number| changed[number]) {
                    *part = model.part(sums, set);
                }
            }
        }
    }

    fn energy(&self) -> f64 {
        self.parts.iter().flatten().sum()
    }

    /// What is put back if the change was none for the better.
    fn put(&mut self, map: Map, changed: &[bool; NUMBERS]) -> (Map, Vec<(usize, usize, Sums)>, Vec<Vec<f64>>) {
        let old = (core::mem::replace(&mut self.map, map), self.parts.clone());
        let mut sums = Vec::new();
        for (m, model) in self.models.iter().enumerate() {
            for number in (0..NUMBERS).filter(|&number| changed[number]) {
                let new = model.sums(&self.map, number);
                sums.push((m, number, core::mem::replace(&mut self.sums[m][number], new)));
            }
        }
        self.weigh(changed);
        (old.0, sums, old.1)
    }
}

/// The best map of so many tries, and its energy. Of the first `columns` bits of a sample's number, columns are added
/// to later ones.
pub fn anneal(models: &[Model], start: Map, columns: usize, tries: usize, seed: u64) -> (f64, Map) {
    let mut random = Random::new(seed);
    let mut state = State::new(models, start);
    let mut energy = state.energy();
    let mut best = (energy, state.map.clone());
    let heat = HEAT * energy;
    for done in 0..tries {
        let temperature = heat * libm::pow(LAST, done as f64 / tries as f64);
        let mut map = state.map.clone();
        let changed = change(&mut map, columns, &mut random);
        let (old_map, old_sums, old_parts) = state.put(map, &changed);
        let new = state.energy();
        if new - energy < -temperature * libm::log(random.uniform().max(1e-12)) {
            energy = new;
            if energy < best.0 {
                best = (energy, state.map.clone());
            }
            continue;
        }
        (state.map, state.parts) = (old_map, old_parts);
        for (m, number, sums) in old_sums {
            state.sums[m][number] = sums;
        }
    }
    best
}

/// Another function of the place for a digit, most often; or a row added to a later one, or a column. The numbers it
/// changes.
fn change(map: &mut Map, columns: usize, random: &mut Random) -> [bool; NUMBERS] {
    let mut changed = [false; NUMBERS];
    let digit = |random: &mut Random| random.below(ROWS).min(random.below(ROWS));
    let number = random.below(NUMBERS);
    changed[number] = true;
    match random.below(10) {
        0..7 => {
            let to = digit(random);
            if random.below(3) > 0 {
                let (other, from) = (random.below(NUMBERS), digit(random));
                map.0[number][to].place ^= match random.below(3) {
                    0 => 1 << random.below(4),
                    1 => random.below(16) as u16,
                    _ => (map.0[number][to].place ^ map.0[other][from].place) & 15,
                };
            }
            if random.below(3) == 0 {
                let by = if random.below(2) == 0 { 1 << random.below(6) } else { random.below(64) };
                map.0[number][to].place ^= (by as u16) << 4;
            }
            if random.below(6) == 0 {
                let (other, from) = (random.below(NUMBERS), digit(random));
                let place = map.0[other][from].place;
                map.0[other][from].place = core::mem::replace(&mut map.0[number][to].place, place);
                changed[other] = true;
            }
        }
        9 if columns > 1 => {
            map.add_column(number / 2, columns, random);
            changed[number ^ 1] = true;
        }
        _ => map.add_row(number, ROWS, random),
    }
    changed
}
