//! What a number costs: medians of rounds in which all samplers take turns, so that a busy moment hits all alike.

use crate::progress::Progress;
use crate::samplers;
use crate::shape::{Sampler, Task};
use crate::table::Table;
use std::hint::black_box;
use std::time::Instant;

/// Numbers a sample: one, a pair, a domain, two domains.
pub const DIMENSIONS: [usize; 4] = [1, 2, 4, 8];
/// Samples per pixel.
pub const SPP: [u32; 3] = [1, 16, 256];
/// Samples of one measurement: less than a millisecond, so that most are not interrupted.
const SAMPLES: u32 = 1 << 14;
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
}

#[derive(Clone, Copy, Debug)]
struct Timing<'a> {
    dimensions: usize,
    spp: u32,
    order: Order,
    pixels: &'a [[u32; 2]],
}

impl Task for Timing<'_> {
    /// Nanoseconds a number.
    type Output = f64;

    fn run(&self, sampler: &impl Sampler) -> f64 {
        if self.order == Order::Batch {
            return match self.dimensions {
                1 => self.time(sampler, |pixel, out| sampler.fill_1(pixel, 0, 0, out)),
                2 => self.time(sampler, |pixel, out| sampler.fill_2(pixel, 0, 0, out)),
                4 => self.time(sampler, |pixel, out| sampler.fill_4(pixel, 0, 0, out)),
                _ => self.time(sampler, |pixel, out: &mut [[f32; 8]]| {
                    // Two domains, one after the other.
                    let (first, second) = out.as_flattened_mut().as_chunks_mut::<4>().0.split_at_mut(self.spp as usize);
                    sampler.fill_4(pixel, 0, 0, first);
                    sampler.fill_4(pixel, 1, 0, second);
                }),
            };
        }
        match self.dimensions {
            1 => self.each(sampler, |pixel, index, out| *out = sampler.draw_1(pixel, 0, index)),
            2 => self.each(sampler, |pixel, index, out| *out = sampler.draw_2(pixel, 0, index)),
            4 => self.each(sampler, |pixel, index, out| *out = sampler.draw_4(pixel, 0, index)),
            _ => self.each(sampler, |pixel, index, out: &mut [f32; 8]| {
                out[..4].copy_from_slice(&sampler.draw_4(pixel, 0, index));
                out[4..].copy_from_slice(&sampler.draw_4(pixel, 1, index));
            }),
        }
    }
}

impl Timing<'_> {
    /// Draw by draw.
    #[inline]
    fn each<S: Sampler, const D: usize>(&self, sampler: &S, draw: impl Fn(S::Pixel, u32, &mut [f32; D])) -> f64 {
        self.time(sampler, |pixel, out| {
            for (index, out) in (0..).zip(out) {
                draw(pixel, index, out);
            }
        })
    }

    /// `set` writes all samples of a pixel.
    #[inline]
    fn time<S: Sampler, const D: usize>(&self, sampler: &S, set: impl Fn(S::Pixel, &mut [[f32; D]])) -> f64 {
        let mut buffer = vec![[0.0; D]; BUFFER / D];
        let made = black_box(sampler.make(black_box(7), black_box(self.spp)));
        let spp = black_box(self.spp) as usize;
        let pixels = &self.pixels[..SAMPLES as usize / spp];
        let start = Instant::now();
        for run in pixels.chunks((buffer.len() / spp).max(1)) {
            for (&[x, y], out) in run.iter().zip(buffer.chunks_exact_mut(spp)) {
                set(sampler.pixel(&made, x, y, 0), out);
            }
            black_box(&mut buffer);
        }
        start.elapsed().as_secs_f64() * 1e9 / f64::from(SAMPLES) / D as f64
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
    let by_rows: Vec<[u32; 2]> = (0..SAMPLES).map(|k| [k % 256, k / 256]).collect();
    let anywhere: Vec<[u32; 2]> = (0..SAMPLES).map(|_| [random.bits_32() >> 20, random.bits_32() >> 20]).collect();
    let mut timings = Vec::new();
    for (order, pixels) in [(Order::Rows, &by_rows), (Order::Random, &anywhere), (Order::Batch, &by_rows)] {
        for dimensions in DIMENSIONS {
            timings.extend(SPP.map(|spp| Timing { dimensions, spp, order, pixels }));
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

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

impl Speeds {
    /// Nanoseconds a number, by rows, of a sampler; between the measured sample counts the nearest above.
    pub fn of(&self, name: &str, dimensions: usize, spp: u32) -> Option<f64> {
        let sampler = self.names.iter().position(|n| *n == name)?;
        let spp = SPP.into_iter().find(|s| *s >= spp).unwrap_or(SPP[SPP.len() - 1]);
        let found = |row: &&Setting| row.order == Order::Rows && row.dimensions == dimensions && row.spp == spp;
        self.rows.iter().find(found).map(|row| row.nanoseconds[sampler])
    }

    pub fn tables(&self) -> Vec<Table> {
        let mut all = vec![
            self.table("speed", "Nanoseconds a number, row by row", Order::Rows, None),
            self.table("speed-batch", "Nanoseconds a number, a pixel's whole set at once", Order::Batch, None),
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
            }
        }
        all
    }

    /// One row a sampler; with `over`, ratios to the time of that sampler.
    fn table(&self, id: &str, title: &str, order: Order, over: Option<&str>) -> Table {
        let rows: Vec<&Setting> = self.rows.iter().filter(|row| row.order == order).collect();
        let heads = rows.iter().map(|row| format!("{}D, {}", row.dimensions, row.spp));
        let line = |(k, name): (usize, &&str)| {
            let cell = |row: &&Setting| match over {
                None => format!("{:.2}", row.nanoseconds[k]),
                Some("sobol_burley") => {
                    format!("{:.2}", row.nanoseconds[k] / self.of("sobol_burley", 4, row.spp).unwrap_or(1.0))
                }
                Some(other) => {
                    format!("{:.2}", row.nanoseconds[k] / self.of(other, row.dimensions, row.spp).unwrap_or(1.0))
                }
            };
            core::iter::once((*name).to_string()).chain(rows.iter().map(cell)).collect()
        };
        Table {
            id: id.into(),
            title: title.into(),
            about: "Numbers a sample and samples per pixel; written to a buffer, one thread, baseline target, median of rounds that take turns.".into(),
            head: core::iter::once("sampler".to_string()).chain(heads).collect(),
            rows: self.names.iter().enumerate().map(line).collect(),
        }
    }
}
