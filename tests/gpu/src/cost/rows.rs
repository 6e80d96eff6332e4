//! The table: samplers and what they are compared with, and the most that each may cost.

use crate::link::{Declaration, linked};
use crate::radv::Radv;
use crate::shader::{costs, head};

/// How many numbers are drawn.
const COUNTS: [usize; 3] = [2, 4, 8];

/// A sampler in the shape that all share.
struct Row {
    title: &'static str,
    /// What its functions' names begin with.
    word: &'static str,
    /// What its pixel is made of first.
    sampler: &'static str,
    /// For every count of numbers: instructions and inverse throughput, with some room for other versions of Mesa.
    most: [u64; COUNTS.len()],
}

const fn row(title: &'static str, word: &'static str, sampler: &'static str, most: [u64; COUNTS.len()]) -> Row {
    Row { title, word, sampler, most }
}

#[rustfmt::skip]
const ROWS: [Row; 11] = [
    row("`Sampler::with_spp`", "bd_sampler", "bd_sampler_with_spp(bd_fill.seed, bd_fill.spp)", [570, 630, 760]),
    row("`Sampler::new`", "bd_sampler", "bd_sampler_new(bd_fill.seed)", [570, 630, 760]),
    row("`Keyed::with_spp`", "bd_keyed", "bd_keyed_with_spp(bd_fill.seed, bd_fill.spp)", [220, 400, 740]),
    row("`Dithered`", "bd_dithered", "bd_dithered_with_spp(bd_fill.seed, bd_fill.spp)", [180, 280, 480]),
    row("`Dithered::lattice`", "bd_dithered", "bd_dithered_lattice(bd_fill.seed)", [150, 240, 400]),
    row("`Dithered::stratified`", "bd_dithered", "bd_dithered_stratified(bd_dithered_new(bd_fill.seed), bd_fill.spp)", [1300, 2500, 5000]),
    row("`White`", "bd_white", "bd_white_new(bd_fill.seed)", [390, 620, 1080]),
    row("`Dither`, four channels", "dither", "0u", [0, 150, 0]),
    row("pcg4d, Jarzynski and Olano 2020", "pcg4d", "bd_fill.seed", [100, 130, 230]),
    row("tables of Heitz et al. 2019", "heitz", "bd_fill.seed", [95, 140, 220]),
    row("Owen-scrambled Sobol in 4-D, Burley 2020", "owen_sobol", "bd_fill.seed", [270, 720, 1360]),
];

/// Prints the table. The error tells which figures are not as they should be.
pub fn print(radv: &Radv, library: &[Declaration]) -> Result<(), String> {
    let has = |name: &str| library.iter().any(|(declared, _)| declared == name);
    let all = ROWS.iter().flat_map(|row| (0..).zip(COUNTS).map(move |(k, count)| (row, k, count)));
    let drawn: Vec<(&Row, usize, usize)> = all.filter(|(row, _, count)| has(&row.draw(*count))).collect();
    let text: String = drawn.iter().enumerate().map(|(k, (row, _, count))| row.entry(k, *count)).collect();
    let text = linked(&text, library)?;
    let found = costs(radv, &text)?;
    println!("{}", head("sampler | numbers"));
    for ((row, _, count), (_, cost)) in drawn.iter().zip(&found) {
        println!("| {} | {count} |{cost}", row.title);
    }
    println!();
    let mut wrong = unlisted(library);
    for ((row, k, count), (_, cost)) in drawn.iter().zip(&found) {
        if cost.instructions().max(cost.inverse_throughput()) > row.most[*k] {
            wrong.push(format!("{}: {count} numbers cost more than {}", row.title, row.most[*k]));
        }
    }
    for (two, four) in drawn.iter().zip(&found).zip(drawn.iter().zip(&found).skip(1)) {
        let [(one, few), (other, more)] = [two, four].map(|((row, ..), (_, cost))| (row.title, cost.instructions()));
        if one == other && few >= more {
            wrong.push(format!("{one}: more numbers cost no more, so some are not drawn"));
        }
    }
    if costs(radv, &text)? != found {
        wrong.push("a second run has other figures".to_string());
    }
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join("; ")) }
}

/// Samplers of the crate that have no row.
fn unlisted(library: &[Declaration]) -> Vec<String> {
    let words = library.iter().filter_map(|(name, _)| name.strip_suffix("_draw4"));
    let missing = words.filter(|word| !ROWS.iter().any(|row| row.word == *word));
    missing.map(|word| format!("{word}_draw4 has no row")).collect()
}

impl Row {
    fn draw(&self, count: usize) -> String {
        format!("{}_draw{count}", self.word)
    }

    /// Entry point `number`, by which every pixel draws `count` numbers and stores them: the pass of the export.
    fn entry(&self, number: usize, count: usize) -> String {
        let draw = self.draw(count);
        let Self { word, sampler, .. } = self;
        let stored = match count {
            2 => "bd_filled[place] = vec4<f32>(drawn, 0.0, 0.0);",
            4 => "bd_filled[place] = drawn;",
            _ => {
                "bd_filled[2u * place] = vec4<f32>(drawn[0], drawn[1], drawn[2], drawn[3]);
    bd_filled[2u * place + 1u] = vec4<f32>(drawn[4], drawn[5], drawn[6], drawn[7]);"
            }
        };
        format!(
            "@compute @workgroup_size(8, 8)
fn row_{number}_(@builtin(global_invocation_id) id: vec3<u32>) {{
    if id.x >= bd_fill.width || id.y >= bd_fill.height {{
        return;
    }}
    let pixel = {word}_pixel({sampler}, id.x, id.y, bd_fill.frame);
    let drawn = {draw}(pixel, bd_fill.domain, bd_fill.index);
    let place = id.y * bd_fill.width + id.x;
    {stored}
}}
"
        )
    }
}
