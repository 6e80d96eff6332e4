//! What the machines should print.

fn main() {
    for &(name, sum) in firmware::INTEGERS.iter().chain(firmware::FLOATS) {
        println!("{name}: {:08x}", sum());
    }
}
