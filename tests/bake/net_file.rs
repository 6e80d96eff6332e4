//! The frozen columns of the joint net: what is read is what was written, and damage is seen.

use crate::bake::net::Net;
use crate::tables;
use bluedither::tables::NET;

fn text() -> String {
    std::fs::read_to_string(tables().join("net.txt")).expect("the file is there")
}

#[test]
fn the_library_holds_what_the_file_says() {
    let net = Net::read(&tables()).expect("sound");
    assert_eq!(net.orders.last(), Some(&NET.progressive));
    assert_eq!(net.orders[..8], NET.known);
    assert_eq!(net.frames, NET.frames);
    assert_eq!(net.text(), text(), "written as it was read");
}

#[test]
fn no_digit_can_change_unseen() {
    let text = text();
    let digits = text.match_indices(|c: char| c.is_ascii_hexdigit()).map(|(at, _)| at);
    let first = text.lines().filter(|line| line.starts_with('#')).map(|line| line.len() + 1).sum::<usize>();
    let mut changed = 0;
    for at in digits.filter(|&at| at >= first).step_by(97) {
        let mut other = text.clone();
        let by = if &text[at..=at] == "0" { "1" } else { "0" };
        if text[at..].starts_with("seal") || text[..at].ends_with('s') || text[..at].ends_with("se") {
            continue; // the word itself
        }
        other.replace_range(at..=at, by);
        assert_eq!(Net::parse(&other), None, "at {at}");
        changed += 1;
    }
    assert!(changed > 50);
    assert_eq!(Net::parse(&text[..text.len() / 2]), None, "the half of it");
    assert_eq!(Net::parse(""), None);
}
