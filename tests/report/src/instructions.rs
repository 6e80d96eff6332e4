//! What a number costs in instructions, which repeats exactly where nanoseconds wander: this program runs itself under
//! valgrind's callgrind and writes a dump at every call of `boundary`.

use crate::progress::Progress;
use crate::samplers;
use crate::speed::{DIMENSIONS, Order, SPP, Timing, table};
use crate::table::Table;
use std::hint::black_box;
use std::path::Path;
use std::process::{Command, Stdio};

const ORDERS: [Order; 3] = [Order::Rows, Order::Batch, Order::Together];
/// Samples of the longer of two measurements; the shorter has half of them, and what both need is their difference.
const SAMPLES: u32 = 1 << 11;

/// Where one count ends and the next begins.
#[inline(never)]
fn boundary() {
    black_box(());
}

fn settings() -> impl Iterator<Item = (Order, usize, u32)> {
    ORDERS.into_iter().flat_map(|order| DIMENSIONS.into_iter().flat_map(move |d| SPP.map(|spp| (order, d, spp))))
}

/// What is counted: all samplers in all settings, three calls of `boundary` each.
pub fn work(names: &[&'static str]) {
    let pixels: Vec<[u32; 2]> = (0..SAMPLES).map(|k| [k % 256, k / 256]).collect();
    for name in names {
        for (order, dimensions, spp) in settings() {
            let [half, whole] = [2, 1].map(|part| {
                let pixels = &pixels[..(SAMPLES / spp / part) as usize];
                Timing { dimensions, spp, order, pixels }
            });
            // What is made once and kept is made here.
            samplers::with(name, &half);
            boundary();
            samplers::with(name, &half);
            boundary();
            samplers::with(name, &whole);
            boundary();
        }
    }
}

/// Instructions a number of each sampler, draw by draw and a set at once; or why there are none, in a line.
pub fn tables(names: &[&'static str], out: &Path) -> Result<Vec<Table>, String> {
    let folder = out.join("instructions");
    let say = |what: &dyn core::fmt::Display| format!("Instructions are not counted: {what}.");
    std::fs::create_dir_all(&folder).map_err(|error| say(&error))?;
    let program = std::env::current_exe().map_err(|error| say(&error))?;
    let progress = Progress::new("instructions", 1);
    let status = Command::new("valgrind")
        .args(["--tool=callgrind", "--dump-before=*instructions*boundary*", "-q"])
        .arg(format!("--callgrind-out-file={}", folder.join("dump").display()))
        .arg(program)
        .args(["--count-instructions", "--only", &names.join(",")])
        .stdout(Stdio::null())
        .status()
        .map_err(|error| say(&format!("valgrind does not run ({error})")))?;
    if !status.success() {
        return Err(say(&"valgrind failed"));
    }
    progress.add(1);
    let count = |dump: usize| -> Option<u64> {
        let text = std::fs::read_to_string(folder.join(format!("dump.{dump}"))).ok()?;
        text.lines().find_map(|line| line.strip_prefix("summary: "))?.trim().parse().ok()
    };
    let per_name = settings().count();
    let cell = |name: usize, k: usize| -> Option<f64> {
        // Of the three dumps of a setting the second is the half and the third the whole.
        let first = 3 * (name * per_name + k) + 1;
        let numbers = f64::from(SAMPLES / 2) * settings().nth(k)?.1 as f64;
        Some(count(first + 2)?.checked_sub(count(first + 1)?)? as f64 / numbers)
    };
    let mut found = vec![Vec::new(); names.len()];
    for (name, row) in found.iter_mut().enumerate() {
        for k in 0..per_name {
            row.push(cell(name, k).ok_or_else(|| say(&"valgrind wrote other dumps than were asked for"))?);
        }
    }
    // Some hundred files that no one reads.
    std::fs::remove_dir_all(&folder).map_err(|error| say(&error))?;
    let one = |(order, id, title): (Order, &str, &str)| {
        let places: Vec<usize> = settings().enumerate().filter(|(_, s)| s.0 == order).map(|(k, _)| k).collect();
        let heads: Vec<(usize, u32)> = places.iter().filter_map(|&k| settings().nth(k)).map(|s| (s.1, s.2)).collect();
        let about = "By valgrind: these repeat exactly, whatever else the machine does.";
        table([id, title, about], names, &heads, |name, column| format!("{:.1}", found[name][places[column]]))
    };
    Ok(vec![
        one((Order::Rows, "instructions", "Instructions a number, draw by draw")),
        one((Order::Batch, "instructions-batch", "Instructions a number, a pixel's whole set at once")),
        one((Order::Together, "instructions-together", "Instructions a number, one sample of a row of pixels at once")),
    ])
}
