//! What a number costs: medians of rounds in which all samplers take turns, so that a busy moment hits all alike.

use crate::progress::Progress;
use crate::samplers;
use crate::shape::{Pixel, Sampler, Task};
use crate::table::Table;
use std::hint::black_box;
use std::time::Instant;

/// Numbers a sample: one, a pair, a domain, two domains.
pub const DIMENSIONS: [usize; 4] = [1, 2, 4, 8];
/// Samples per pixel.
pub const SPP: [u32; 3] = [1, 16, 256];
/// Samples of one measurement: less than a millisecond, so that most are not interrupted.
const SAMPLES: u32 = 1 << 14;
/// Pixels of a row.
const WIDTH: u32 = 256;
/// Numbers of the buffer that is written over and over; it stays in the first cache.
const BUFFER: usize = 4096;

/// The order in which pixels are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Row by row, draw by draw.
    Rows,
    /// Pixels in no order, draw by draw.
    Random,
    /// Row by row, a pixel's whole set at once.
    Batch,
    /// Row by row, one sample of all pixels of the row at once.
    Together,
}

/// One measurement: all samples of some pixels, over and over.
#[derive(Clone, Copy, Debug)]
pub struct Timing<'a> {
    pub dimensions: usize,
    pub spp: u32,
    pub order: Order,
    pub pixels: &'a [[u32; 2]],
}

impl Task for Timing<'_> {
    /// Nanoseconds a number.
    type Output = f64;

    fn run<S: Sampler>(&self, make: fn(u32, u32) -> S) -> f64 {
        match (self.order, self.dimensions) {
            (Order::Batch, 1) => self.time(make, |pixel, out: &mut [[f32; 1]]| pixel.fill(0, 0, out)),
            (Order::Batch, 2) => self.time(make, |pixel, out: &mut [[f32; 2]]| pixel.fill(0, 0, out)),
            (Order::Batch, 4) => self.time(make, |pixel, out: &mut [[f32; 4]]| pixel.fill(0, 0, out)),
            (Order::Batch, _) => self.time(make, |pixel, out: &mut [[f32; 8]]| {
                // Two domains, one after the other.
                let (first, second) = out.as_flattened_mut().as_chunks_mut::<4>().0.split_at_mut(self.spp as usize);
                pixel.fill(0, 0, first);
                pixel.fill(1, 0, second);
            }),
            (Order::Together, 1) => {
                self.rows(make, |sampler, at, index, out: &mut [[f32; 1]]| sampler.row(at, 0, index, out))
            }
            (Order::Together, 2) => {
                self.rows(make, |sampler, at, index, out: &mut [[f32; 2]]| sampler.row(at, 0, index, out))
            }
            (Order::Together, 4) => {
                self.rows(make, |sampler, at, index, out: &mut [[f32; 4]]| sampler.row(at, 0, index, out))
            }
            (Order::Together, _) => self.rows(make, |sampler, at, index, out: &mut [[f32; 8]]| {
                let half = out.len();
                let (first, second) = out.as_flattened_mut().as_chunks_mut::<4>().0.split_at_mut(half);
                sampler.row(at, 0, index, first);
                sampler.row(at, 1, index, second);
            }),
            (_, 1) => self.each(make, |pixel, index| pixel.draw::<1>(0, index)),
            (_, 2) => self.each(make, |pixel, index| pixel.draw::<2>(0, index)),
            (_, 4) => self.each(make, |pixel, index| pixel.draw::<4>(0, index)),
            (_, _) => self.each(make, |pixel, index| {
                let mut both = [0.0; 8];
                both[..4].copy_from_slice(&pixel.draw::<4>(0, index));
                both[4..].copy_from_slice(&pixel.draw::<4>(1, index));
                both
            }),
        }
    }
}

impl Timing<'_> {
    /// Draw by draw.
    #[inline]
    fn each<S: Sampler, const D: usize>(
        &self,
        make: fn(u32, u32) -> S,
        draw: impl Fn(S::Pixel, u32) -> [f32; D],
    ) -> f64 {
        self.time(make, |pixel, out| {
            for (index, out) in (0..).zip(out) {
                *out = draw(pixel, index);
            }
        })
    }

    /// `row` writes one sample of pixels that follow each other.
    #[inline]
    fn rows<S: Sampler, const D: usize>(
        &self,
        make: fn(u32, u32) -> S,
        row: impl Fn(&S, [u32; 2], u32, &mut [[f32; D]]),
    ) -> f64 {
        let mut buffer = [[0.0; D]; WIDTH as usize];
        let made = black_box(make(black_box(7), black_box(self.spp)));
        let spp = black_box(self.spp);
        let start = Instant::now();
        for pixels in self.pixels.chunks(WIDTH as usize) {
            for index in 0..spp {
                row(&made, pixels[0], index, &mut buffer[..pixels.len()]);
                black_box(&mut buffer);
            }
        }
        start.elapsed().as_secs_f64() * 1e9 / (self.pixels.len() * spp as usize * D) as f64
    }

    /// `set` writes all samples of a pixel.
    #[inline]
    fn time<S: Sampler, const D: usize>(
        &self,
        make: fn(u32, u32) -> S,
        set: impl Fn(S::Pixel, &mut [[f32; D]]),
    ) -> f64 {
        let mut buffer = vec![[0.0; D]; BUFFER / D];
        let made = black_box(make(black_box(7), black_box(self.spp)));
        let spp = black_box(self.spp) as usize;
        let start = Instant::now();
        for run in self.pixels.chunks((buffer.len() / spp).max(1)) {
            for (&[x, y], out) in run.iter().zip(buffer.chunks_exact_mut(spp)) {
                set(made.pixel(x, y, 0), out);
            }
            black_box(&mut buffer);
        }
        start.elapsed().as_secs_f64() * 1e9 / (self.pixels.len() * spp * D) as f64
    }
}

/// Nanoseconds a number of each sampler, in `DIMENSIONS` × `SPP`, by rows and in random order.
#[derive(Debug)]
pub struct Speeds {
    pub names: Vec<&'static str>,
    rows: Vec<Setting>,
}

#[derive(Debug)]
struct Setting {
    dimensions: usize,
    spp: u32,
    order: Order,
    /// One a sampler.
    nanoseconds: Vec<f64>,
}

pub fn measure(names: &[&'static str], rounds: usize) -> Speeds {
    let mut random = crate::analysis::random::Random::new(1);
    let by_rows: Vec<[u32; 2]> = (0..SAMPLES).map(|k| [k % WIDTH, k / WIDTH]).collect();
    let anywhere: Vec<[u32; 2]> = (0..SAMPLES).map(|_| [random.bits_32() >> 20, random.bits_32() >> 20]).collect();
    let mut timings = Vec::new();
    let orders =
        [(Order::Rows, &by_rows), (Order::Random, &anywhere), (Order::Batch, &by_rows), (Order::Together, &by_rows)];
    for (order, pixels) in orders {
        for dimensions in DIMENSIONS {
            let enough = |spp: u32| &pixels[..(SAMPLES / spp) as usize];
            timings.extend(SPP.map(|spp| Timing { dimensions, spp, order, pixels: enough(spp) }));
        }
    }
    let mut times = vec![vec![Vec::new(); names.len()]; timings.len()];
    let progress = Progress::new("speed", rounds);
    for _ in 0..rounds {
        for (timing, times) in timings.iter().zip(&mut times) {
            for (name, times) in names.iter().zip(times) {
                times.push(samplers::with(name, timing));
            }
        }
        progress.add(1);
    }
    let setting = |(Timing { dimensions, spp, order, .. }, times): (Timing, Vec<Vec<f64>>)| Setting {
        dimensions,
        spp,
        order,
        nanoseconds: times.into_iter().map(median).collect(),
    };
    let rows = timings.into_iter().zip(times).map(setting).collect();
    Speeds { names: names.to_vec(), rows }
}

pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

impl Speeds {
    /// Nanoseconds a number, by rows, of a sampler; between the measured sample counts the nearest above.
    pub fn of(&self, name: &str, dimensions: usize, spp: u32) -> Option<f64> {
        self.by(Order::Rows, name, dimensions, spp)
    }

    /// Nanoseconds that a pixel's whole set takes by whichever call is the faster, one draw after the other or all at
    /// once; between the measured sample counts on a line.
    pub fn of_set(&self, name: &str, dimensions: usize, spp: u32) -> Option<f64> {
        let at = SPP.iter().position(|s| *s >= spp).unwrap_or(SPP.len() - 1);
        let [low, high] = [SPP[at.saturating_sub(1)], SPP[at]];
        let set = |spp: u32| {
            let times = [Order::Rows, Order::Batch].map(|order| self.by(order, name, dimensions, spp));
            Some(times.into_iter().flatten().reduce(f64::min)? * dimensions as f64 * f64::from(spp))
        };
        let part = if low == high { 0.0 } else { (f64::from(spp) - f64::from(low)) / f64::from(high - low) };
        Some(set(low)? * (1.0 - part) + set(high)? * part)
    }

    fn by(&self, order: Order, name: &str, dimensions: usize, spp: u32) -> Option<f64> {
        let sampler = self.names.iter().position(|n| *n == name)?;
        let spp = SPP.into_iter().find(|s| *s >= spp).unwrap_or(SPP[SPP.len() - 1]);
        let found = |row: &&Setting| row.order == order && row.dimensions == dimensions && row.spp == spp;
        self.rows.iter().find(found).map(|row| row.nanoseconds[sampler])
    }

    pub fn tables(&self) -> Vec<Table> {
        let mut all = vec![
            self.table("speed", "Nanoseconds a number, row by row", Order::Rows, None),
            self.table("speed-batch", "Nanoseconds a number, a pixel's whole set at once", Order::Batch, None),
            self.table(
                "speed-together",
                "Nanoseconds a number, one sample of a row of pixels at once",
                Order::Together,
                None,
            ),
            self.table("speed-random", "Nanoseconds a number, random pixels", Order::Random, None),
        ];
        for (id, name, of) in [
            ("speed-over-sobol_burley", "sobol_burley", "sample_4d of sobol_burley (its 4 dimensions)"),
            ("speed-over-2019", "heitz-2019", "the 2019 tables, as u8"),
        ] {
            if self.names.contains(&name) {
                all.push(self.table(id, &format!("Time over that of {of}"), Order::Rows, Some(name)));
                let title = format!("Time of the whole set at once over that of {of}");
                all.push(self.table(&format!("{id}-batch"), &title, Order::Batch, Some(name)));
                let title = format!("Time of a row at once over that of {of}");
                all.push(self.table(&format!("{id}-together"), &title, Order::Together, Some(name)));
            }
        }
        all
    }

    /// One row a sampler; with `over`, ratios to the time of that sampler.
    fn table(&self, id: &str, title: &str, order: Order, over: Option<&str>) -> Table {
        let rows: Vec<&Setting> = self.rows.iter().filter(|row| row.order == order).collect();
        let heads: Vec<(usize, u32)> = rows.iter().map(|row| (row.dimensions, row.spp)).collect();
        let about = "Written to a buffer, one thread, baseline target, median of rounds that take turns.";
        table([id, title, about], &self.names, &heads, |name, column| {
            let Setting { dimensions, spp, nanoseconds, .. } = rows[column];
            let unit = match over {
                None => Some(1.0),
                // Its numbers come by fours.
                Some("sobol_burley") => self.of("sobol_burley", 4, *spp),
                Some(other) => self.of(other, *dimensions, *spp),
            };
            format!("{:.2}", nanoseconds[name] / unit.unwrap_or(1.0))
        })
    }
}

/// A row a sampler, a column for each number of dimensions and of samples.
pub fn table(
    [id, title, about]: [&str; 3],
    names: &[&'static str],
    heads: &[(usize, u32)],
    cell: impl Fn(usize, usize) -> String,
) -> Table {
    let row = |(k, name): (usize, &&str)| {
        core::iter::once((*name).to_string()).chain((0..heads.len()).map(|column| cell(k, column))).collect()
    };
    let heads = heads.iter().map(|(dimensions, spp)| format!("{dimensions}D, {spp}"));
    Table {
        id: id.into(),
        title: title.into(),
        about: format!("Numbers a sample and samples per pixel. {about}"),
        head: core::iter::once("sampler".to_string()).chain(heads).collect(),
        rows: names.iter().enumerate().map(row).collect(),
    }
}
