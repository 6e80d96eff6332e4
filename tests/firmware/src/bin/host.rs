//! What the machines should print.

fn main() {
    for (name, sum) in firmware::FAMILIES {
        println!("{name}: {:08x}", sum());
    }
}
