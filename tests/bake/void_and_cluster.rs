//! Void-and-cluster against a twin that takes the textbook at its word, and what the ranks are for.

use rand::rngs::Xoshiro256PlusPlus;
use rand::{Rng, SeedableRng};

use crate::bake::void_and_cluster::{self, Window};

/// As recorded in `tables/`; any kernel would do here.
fn kernel() -> Vec<i32> {
    let weight = |r2: f64| 1_048_576.0 * (libm::exp(-r2 / 3.92) + 0.1 * libm::exp(-r2 / 12.5));
    (0..101).map(|r2| libm::round(weight(f64::from(r2))) as i32).collect()
}

fn bake(size_log2: u32, kernel: &[i32], seed: u64) -> Vec<u16> {
    void_and_cluster::void_and_cluster(size_log2, kernel, &mut Xoshiro256PlusPlus::seed_from_u64(seed))
}

/// A set of pixels, and what every pixel of the torus gets from its members and all their images.
#[derive(Clone)]
struct Pattern {
    size: usize,
    weights: Vec<i64>, // by the difference of two pixels modulo the size
    member: Vec<bool>,
    field: Vec<i64>,
}

impl Pattern {
    fn new(size: usize, kernel: &[i32]) -> Self {
        let mut weights = vec![0; size * size];
        // Images that are 16 pixels or more away get nothing from the longest kernel here.
        for y in -16i64..=16 {
            for x in -16i64..=16 {
                let at = y.rem_euclid(size as i64) as usize * size + x.rem_euclid(size as i64) as usize;
                weights[at] += i64::from(*kernel.get((x * x + y * y) as usize).unwrap_or(&0));
            }
        }
        Self { size, weights, member: vec![false; size * size], field: vec![0; size * size] }
    }

    fn set(&mut self, pixel: usize, member: bool) {
        assert_ne!(self.member[pixel], member);
        self.member[pixel] = member;
        let (size, sign) = (self.size, if member { 1 } else { -1 });
        for y in 0..size {
            let row = (y + size - pixel / size) % size * size;
            for x in 0..size {
                self.field[y * size + x] += sign * self.weights[row + (x + size - pixel % size) % size];
            }
        }
    }

    /// The first of the members with the largest field.
    fn tightest_cluster(&self) -> usize {
        let members = (0..self.member.len()).filter(|&p| self.member[p]);
        members.reduce(|best, p| if self.field[p] > self.field[best] { p } else { best }).expect("a member")
    }

    /// The first of the others with the smallest field.
    fn largest_void(&self) -> usize {
        let others = (0..self.member.len()).filter(|&p| !self.member[p]);
        others.reduce(|best, p| if self.field[p] < self.field[best] { p } else { best }).expect("a pixel that is none")
    }
}

/// Ulichney's three phases, the third of which looks at the minority of zeros.
fn twin(size_log2: u32, kernel: &[i32], seed: u64) -> Vec<u16> {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let size = 1usize << size_log2;
    let area = size * size;
    let mut pattern = Pattern::new(size, kernel);
    let ones = (area / 50).min(512);
    while pattern.member.iter().filter(|&&member| member).count() < ones {
        let pixel = (rng.next_u64() >> (64 - 2 * size_log2)) as usize;
        if !pattern.member[pixel] {
            pattern.set(pixel, true);
        }
    }
    loop {
        let cluster = pattern.tightest_cluster();
        pattern.set(cluster, false);
        let void = pattern.largest_void();
        pattern.set(void, true);
        if void == cluster {
            break;
        }
    }
    let mut ranks = vec![0; area];
    let mut taken = pattern.clone();
    for rank in (0..ones).rev() {
        let cluster = taken.tightest_cluster();
        taken.set(cluster, false);
        ranks[cluster] = rank as u16;
    }
    for rank in ones..area / 2 {
        let void = pattern.largest_void();
        pattern.set(void, true);
        ranks[void] = rank as u16;
    }
    let mut zeros = Pattern::new(size, kernel);
    (0..area).filter(|&p| !pattern.member[p]).for_each(|p| zeros.set(p, true));
    for rank in area / 2..area {
        let cluster = zeros.tightest_cluster();
        zeros.set(cluster, false);
        ranks[cluster] = rank as u16;
    }
    ranks
}

/// From a tile that is smaller than the window (8) to several groups of blocks (64 and 128).
#[test]
fn ranks_are_those_of_the_textbook() {
    for size_log2 in 3..=6 {
        for seed in [1, 0x1234_5678_9abc_def0] {
            assert_eq!(bake(size_log2, &kernel(), seed), twin(size_log2, &kernel(), seed), "2^{size_log2}, {seed}");
        }
    }
    assert_eq!(bake(7, &kernel(), 3), twin(7, &kernel(), 3));
}

/// Short kernels leave most of the field equal: the choice among ties is all there is.
#[test]
fn short_kernels_make_no_difference() {
    for length in 1..=6 {
        for size_log2 in [3, 4, 5, 6] {
            let kernel = &[7, 5, 3, 2, 2, 1][..length];
            assert_eq!(bake(size_log2, kernel, 5), twin(size_log2, kernel, 5), "{length} weights, 2^{size_log2}");
        }
    }
}

#[test]
fn ranks_are_a_permutation() {
    for size_log2 in 3..=7 {
        let mut ranks = bake(size_log2, &kernel(), 2);
        ranks.sort_unstable();
        assert!(ranks.iter().enumerate().all(|(i, &rank)| i == usize::from(rank)), "2^{size_log2}");
    }
}

/// Sigmas from nothing to all: the tightest cluster is anywhere, or the same from everywhere. Neither may go round in
/// circles.
#[test]
fn kernels_of_no_width_and_of_any_width_end_in_a_permutation() {
    let kernels: [(&str, Vec<i32>); 5] = [
        ("nothing", vec![0]),
        ("the pixel alone", vec![1_048_576]),
        ("nothing, far", vec![0; 101]),
        ("flat", vec![1000; 101]),
        ("rising", (0..101).map(|r2| 10 * r2).collect()),
    ];
    for (name, kernel) in kernels {
        for size_log2 in [3, 4, 5] {
            let mut ranks = bake(size_log2, &kernel, 3);
            ranks.sort_unstable();
            assert!(ranks.into_iter().eq(0..1 << (2 * size_log2)), "{name}, {size_log2}");
        }
    }
}

fn shuffled(size: usize, seed: u64) -> Vec<u16> {
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut keys: Vec<(u64, u16)> = (0..size * size).map(|i| (rng.next_u64(), i as u16)).collect();
    keys.sort_unstable();
    keys.into_iter().map(|key| key.1).collect()
}

/// The smallest distance of two pixels that `chosen` picks by rank, on the torus.
fn smallest_distance(ranks: &[u16], size: usize, chosen: impl Fn(usize) -> bool) -> f64 {
    let pixels: Vec<usize> = (0..ranks.len()).filter(|&p| chosen(usize::from(ranks[p]))).collect();
    let along = |a: usize, b: usize| a.abs_diff(b).min(size - a.abs_diff(b)).pow(2);
    let squared = |p: usize, q: usize| along(p % size, q % size) + along(p / size, q / size);
    let pairs = pixels.iter().enumerate().flat_map(|(i, &p)| pixels[..i].iter().map(move |&q| squared(p, q)));
    (pairs.min().expect("two pixels") as f64).sqrt()
}

/// A hexagonal lattice is the best there is; random pixels touch.
#[test]
fn minorities_keep_their_distance() {
    for (size_log2, seed) in [(5, 1), (5, 2), (6, 1), (6, 2)] {
        let size = 1usize << size_log2;
        let (area, ranks) = (size * size, bake(size_log2, &kernel(), seed));
        // A part of 1/64 has neighbours at the edge of the window.
        for part in [16, 32, 64] {
            let best = (part as f64 * 2.0 / 3f64.sqrt()).sqrt();
            let first = smallest_distance(&ranks, size, |rank| rank < area / part) / best;
            let last = smallest_distance(&ranks, size, |rank| rank >= area - area / part) / best;
            let random = smallest_distance(&shuffled(size, seed), size, |rank| rank < area / part) / best;
            println!("{size} 1/{part}: {first:.3} {last:.3}, random {random:.3}");
            assert!(first > 0.5 && last > 0.5, "{size}, 1/{part}: {first} and {last} of a lattice's distance");
            assert!(random < 0.5 * first, "{size}, 1/{part}: random {random}, ranks {first}");
        }
    }
}

/// The pixels of a prefix in squares of 8×8: the variance of their number, over that of random pixels.
fn variance(ranks: &[u16], size: usize, prefix: usize) -> f64 {
    let mean = 64.0 * prefix as f64 / ranks.len() as f64;
    let count = |corner: usize| {
        let place = |i: usize| (corner / size + i / 8) % size * size + (corner % size + i % 8) % size;
        (0..64).filter(|&i| usize::from(ranks[place(i)]) < prefix).count() as f64
    };
    let squares = (0..ranks.len()).map(|corner| (count(corner) - mean).powi(2)).sum::<f64>();
    squares / ranks.len() as f64 / (mean * (1.0 - mean / 64.0))
}

#[test]
fn every_prefix_is_evenly_spread() {
    let ranks = bake(5, &kernel(), 4);
    let random = shuffled(32, 4);
    let (mut worst, mut sums) = (0f64, [0.0; 2]);
    // Below 16 pixels, one for each square, there is nothing to spread.
    for prefix in 16..=1024 - 16 {
        let found = variance(&ranks, 32, prefix);
        worst = worst.max(found);
        sums[0] += found;
        sums[1] += variance(&random, 32, prefix);
    }
    println!("worst {worst:.3}, mean {:.4}, random {:.3}", sums[0] / 993.0, sums[1] / 993.0);
    assert!(worst < 0.5, "a prefix of variance {worst}");
    assert!(sums[0] < 0.2 * sums[1], "mean {} against {} of random pixels", sums[0] / 993.0, sums[1] / 993.0);
}

/// Several frames by the book: what a pixel feels is a sum over all ones of all frames, and each step is taken in every
/// frame, the first of which is another one every time.
fn twin_over_time(sizes: [u32; 2], windows: &[Window], weights: &dyn Fn(usize, usize, usize) -> i64) -> Vec<u16> {
    let (size, frames) = (1usize << sizes[0], 1usize << sizes[1]);
    let area = size * size;
    let mut rng = Xoshiro256PlusPlus::seed_from_u64(4);
    let mut ones = vec![false; frames * area];
    // As far as there are weights: 3 pixels, and in time as there are windows, forwards and backwards.
    let feel = |ones: &[bool], at: usize| -> i64 {
        let reach = -3i64..=3;
        let mut sum = 0;
        for t in 1 - windows.len() as i64..windows.len() as i64 {
            let frame = (at / area) as i64 + t;
            for (dy, dx) in reach.clone().flat_map(|dy| reach.clone().map(move |dx| (dy, dx))) {
                let weight = weights(dx.unsigned_abs() as usize, dy.unsigned_abs() as usize, t.unsigned_abs() as usize);
                let x = ((at % size) as i64 + dx).rem_euclid(size as i64) as usize;
                let y = ((at / size % size) as i64 + dy).rem_euclid(size as i64) as usize;
                if weight != 0 && ones[frame.rem_euclid(frames as i64) as usize * area + y * size + x] {
                    sum += weight;
                }
            }
        }
        sum
    };
    let extreme = |ones: &[bool], frame: usize, of_ones: bool| {
        let all = (frame * area..(frame + 1) * area).filter(|&p| ones[p] == of_ones);
        let sign = if of_ones { -1 } else { 1 };
        all.min_by_key(|&p| (sign * feel(ones, p), p)).expect("a pixel")
    };
    let count = (area / 50).min(512);
    for frame in 0..frames {
        while ones[frame * area..(frame + 1) * area].iter().filter(|&&one| one).count() < count {
            ones[frame * area + (rng.next_u64() >> (64 - 2 * sizes[0])) as usize] = true;
        }
    }
    loop {
        let before = ones.clone();
        for frame in 0..frames {
            let cluster = extreme(&ones, frame, true);
            ones[cluster] = false;
            let void = extreme(&ones, frame, false);
            ones[void] = true;
        }
        if ones == before {
            break;
        }
    }
    let order = |rank: usize| {
        (0..frames).map(move |turn| {
            let reversed = (0..sizes[1]).fold(0, |r, bit| r << 1 | (turn >> bit & 1));
            (reversed + rank) % frames
        })
    };
    let mut ranks = vec![0; frames * area];
    let mut taken = ones.clone();
    for rank in (0..count).rev() {
        for frame in order(rank) {
            let cluster = extreme(&taken, frame, true);
            taken[cluster] = false;
            ranks[cluster] = rank as u16;
        }
    }
    for rank in count..area {
        for frame in order(rank) {
            let void = extreme(&ones, frame, false);
            ones[void] = true;
            ranks[void] = rank as u16;
        }
    }
    ranks
}

#[test]
fn frames_are_those_of_the_book() {
    // Of one pixel in other frames, and of several.
    let point = |dx: usize, dy: usize, t: usize| match (t, dx * dx + dy * dy) {
        (0, r2) => [50, 30, 20, 11, 9, 6, 3, 3, 2].get(r2).copied().unwrap_or(0),
        (t, 0) => [0, 40, 22, 5][t],
        _ => 0,
    };
    let wide = |dx: usize, dy: usize, t: usize| match (dx, dy) {
        (0..=3, 0..=2) => [7, 5, 2, 1][dx] * [9, 4, 1][dy] * [3, 2, 1, 1][t],
        _ => 0,
    };
    let weights: [&dyn Fn(usize, usize, usize) -> i64; 2] = [&point, &wide];
    for (k, weight) in weights.into_iter().enumerate() {
        let windows: Vec<Window> = (0..4).map(|t| Window::new(3, |dx, dy| weight(dx, dy, t) as i32)).collect();
        for sizes in [[3, 2], [4, 1], [3, 3]] {
            let mut rng = Xoshiro256PlusPlus::seed_from_u64(4);
            let baked = void_and_cluster::over_time(sizes, &windows, &mut rng);
            assert!(
                baked == twin_over_time(sizes, &windows, &|x, y, t| if x.max(y) > 3 { 0 } else { weight(x, y, t) }),
                "{k}: {sizes:?}"
            );
        }
    }
}

/// Each frame holds every rank once, and frames that do not feel each other are as good as still ones.
#[test]
fn every_frame_is_a_permutation() {
    let over_time = |size_log2, frames_log2, time_kernel: &[i32]| {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(4);
        let mut windows = vec![Window::round(&kernel())];
        windows.extend(time_kernel.iter().skip(1).map(|&weight| Window::new(0, |_, _| weight)));
        void_and_cluster::over_time([size_log2, frames_log2], &windows, &mut rng)
    };
    for (size_log2, frames_log2) in [(3, 1), (4, 0), (4, 2), (3, 5)] {
        for time_kernel in [&[0, 700_000, 300_000][..], &[0, 9, 8, 7, 6, 5, 4, 3, 2, 1], &[]] {
            let ranks = over_time(size_log2, frames_log2, time_kernel);
            assert_eq!(ranks.len(), 1 << (2 * size_log2 + frames_log2));
            for frame in ranks.chunks(1 << (2 * size_log2)) {
                let mut sorted = frame.to_vec();
                sorted.sort_unstable();
                assert!(sorted.iter().enumerate().all(|(i, &rank)| i == usize::from(rank)));
            }
        }
    }
    assert_eq!(over_time(5, 0, &[0, 5, 5]), over_time(5, 0, &[]), "one frame has no other");
}
