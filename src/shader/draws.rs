//! Samplers whose draws come from templates: texts pasted together, with the names of each, while compiling.

/// Draws of floats, by those in fixed point.
pub(super) const FLOATS: &str = include_str!("../wgsl/sampler/draws.wgsl");

/// Draws in fixed point, by a sampler's pairs and singles.
pub(super) const PADDED: &str = include_str!("../wgsl/sampler/padded.wgsl");

/// Draws in fixed point, by a function that gives all eight numbers.
pub(super) const JOINT: &str = include_str!("../wgsl/sampler/joint.wgsl");

/// Some texts one behind the other, NAME and TITLE replaced by words, and how long that is: what is behind `N` is left
/// out.
pub(super) const fn paste<const N: usize>(texts: [&str; 3], name: &str, title: &str) -> ([u8; N], usize) {
    let (mut pasted, mut length) = ([0; N], 0);
    let mut text = 0;
    while text < texts.len() {
        let mut rest = texts[text].as_bytes();
        while let [first, behind @ ..] = rest {
            if let [b'N', b'A', b'M', b'E', behind @ ..] = rest {
                length = write(&mut pasted, length, name.as_bytes());
                rest = behind;
            } else if let [b'T', b'I', b'T', b'L', b'E', behind @ ..] = rest {
                length = write(&mut pasted, length, title.as_bytes());
                rest = behind;
            } else {
                length = write(&mut pasted, length, &[*first]);
                rest = behind;
            }
        }
        text += 1;
    }
    (pasted, length)
}

/// Where the text goes on.
const fn write(to: &mut [u8], at: usize, bytes: &[u8]) -> usize {
    let mut k = 0;
    while k < bytes.len() {
        if at + k < to.len() {
            to[at + k] = bytes[k];
        }
        k += 1;
    }
    at + bytes.len()
}

/// Text that was pasted.
pub(super) const fn text(pasted: &[u8]) -> &str {
    match core::str::from_utf8(pasted) {
        Ok(text) => text,
        Err(_) => panic!("pieces of texts are texts"),
    }
}
