//! Finds the constants of the joint net (`bluedither::net`) and prints them, columns as `tables/net.txt` has them: an order for
//! each number of samples, then the columns of frames.
//!
//! ```sh
//! cargo run --release -p search -- 4 20000     # the order for 2⁴ samples, by 20,000 tries
//! cargo run --release -p search -- any 20000   # for any number of samples, and the columns of frames
//! ```
//! The integrands are random half-spaces and smooth functions of two, three and five numbers; the evaluation (`report --
//! several`) uses others, and nothing here is taken from it. All sums are in a fixed order and all functions libm's, so
//! that the outcome is the same on every machine.

mod anneal;
mod energy;
mod frames;
mod map;
mod power;
mod random;
mod response;
mod ridge;

use bluedither::net::Digits;
use energy::{Model, Training};
use map::Map;
use power::{COUNTS, Family};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (Some(counts), Some(tries)) = (arguments.first().and_then(|word| counts(word)), tries(&arguments)) else {
        eprintln!("usage: search ORDER [TRIES]: ORDER is 0..8, for 2^ORDER samples, or any");
        std::process::exit(2);
    };
    let training = Training {
        pair: [Family::new(101, 2, false, 400), Family::new(102, 2, true, 200)],
        several: [Family::new(104, 3, false, 200), Family::new(105, 5, false, 200), Family::new(106, 5, true, 160)],
    };
    eprintln!("power of the training integrands");
    let costs = response::costs();
    let models: Vec<Model> = counts.iter().map(|&m| Model::new(&training, m, &costs)).collect();
    let any = counts.len() > 1;
    let columns = if any { 10 } else { counts[0] };
    let (energy, map) = anneal::anneal(&models, Map::random(3), columns, tries, 1);
    eprintln!("energy {energy:.4} after {tries} tries");
    let order = map.order();
    order.samples.iter().chain(&order.inside).chain(&order.place).for_each(print);
    if any {
        frames::columns(&map).iter().for_each(print);
    }
}

/// log₂ of the numbers of samples that an order serves.
fn counts(word: &str) -> Option<Vec<usize>> {
    if word == "any" {
        return Some((0..COUNTS).collect());
    }
    word.parse().ok().filter(|&m| m < COUNTS).map(|m| vec![m])
}

fn tries(arguments: &[String]) -> Option<usize> {
    arguments.get(1).map_or(Some(20_000), |word| word.parse().ok())
}

fn print(column: &Digits) {
    println!("{:08x} {:08x} {:08x} {:08x}", column[0], column[1], column[2], column[3]);
}
