//! The frozen sequence of keys: what is read is what was written, and damage is seen.

use bluedither::sequence::Sequence;
use bluedither::tables::SEQUENCE;

use crate::bake::sequence::Columns;
use crate::tables;

fn text() -> String {
    std::fs::read_to_string(tables().join("sequence.txt")).expect("the file is there")
}

#[test]
fn the_library_holds_what_the_file_says() {
    let columns = Columns::read(&tables()).expect("sound");
    assert_eq!(SEQUENCE, Sequence::new(&columns.0));
    assert_eq!(columns.text(), text(), "written as it was read");
}

#[test]
fn a_damaged_file_is_noticed() {
    let text = text();
    let first = text.lines().position(|line| !line.starts_with('#')).expect("words");
    let lines: Vec<&str> = text.lines().collect();
    let without = |k: usize| [&lines[..k], &lines[k + 1..]].concat().join("\n");
    let swapped = [&lines[..first], &[lines[first + 1], lines[first]], &lines[first + 2..]].concat().join("\n");
    let longer = text.replacen("\nseal", "\n00000000 00000000\nseal", 1);
    let flipped = if lines[first].starts_with('0') { "1" } else { "0" };
    let other = text.replacen(lines[first], &(flipped.to_string() + &lines[first][1..]), 1);
    for damaged in [String::new(), without(first), without(lines.len() - 1), swapped, longer, other] {
        assert_eq!(Columns::parse(&damaged), None);
    }
}
