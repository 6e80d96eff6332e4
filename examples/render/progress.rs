//! A bar on a terminal; anywhere else one plain line when a step begins and one when it ends.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::time::Instant;

pub struct Progress {
    bar: ProgressBar,
    label: &'static str,
    start: Instant,
    plain: bool,
}

impl Progress {
    pub fn new(label: &'static str, steps: usize) -> Self {
        let plain = !std::io::stderr().is_terminal();
        let bar = if plain { ProgressBar::hidden() } else { ProgressBar::new(steps as u64) };
        let style = ProgressStyle::with_template("{msg:32} {bar:40} {percent:>3} %  {elapsed}");
        bar.set_style(style.expect("the template is a constant"));
        bar.set_message(label);
        if plain {
            eprintln!("{label} ...");
        }
        Self { bar, label, start: Instant::now(), plain }
    }

    pub fn add(&self, steps: usize) {
        self.bar.inc(steps as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
        let way = if self.plain { "done" } else { self.label };
        eprintln!("{way}: {:.1} s", self.start.elapsed().as_secs_f32());
    }
}
