//! What is measured: the samplers and what they are compared with.

/// A sampler in the shape that all share.
pub struct Row {
    pub title: &'static str,
    /// What its functions' names begin with.
    word: &'static str,
    /// What its pixel is made of first.
    sampler: &'static str,
}

const fn row(title: &'static str, word: &'static str, sampler: &'static str) -> Row {
    Row { title, word, sampler }
}

pub const ROWS: [Row; 13] = [
    row("`Sampler::with_spp`", "bd_sampler", "bd_sampler_with_spp(bd_fill.seed, bd_fill.spp)"),
    row("`Sampler::new`", "bd_sampler", "bd_sampler_new(bd_fill.seed)"),
    row("`ZOrder`", "bd_z_order", "bd_z_order_new(bd_fill.seed)"),
    row("`Keyed::with_spp`", "bd_keyed", "bd_keyed_with_spp(bd_fill.seed, bd_fill.spp)"),
    row("`Rank1`", "bd_rank1", "bd_rank1_new(bd_fill.seed)"),
    row("`Dithered`", "bd_dithered", "bd_dithered_with_spp(bd_fill.seed, bd_fill.spp)"),
    row("`Dithered::stratified`", "bd_dithered", "bd_dithered_stratified(bd_dithered_new(bd_fill.seed), bd_fill.spp)"),
    row("`White`", "bd_white", "bd_white_new(bd_fill.seed)"),
    row("`Constant`", "bd_constant", "bd_constant_with_spp(bd_fill.seed, bd_fill.spp)"),
    row("pcg4d (Jarzynski and Olano 2020)", "pcg4d", "bd_fill.seed"),
    row("tables of 2019 (Heitz et al.)", "heitz", "bd_fill.seed"),
    row("Owen-scrambled Sobol in 4-D (Burley 2020)", "owen_sobol", "bd_fill.seed"),
    row("`Dither`, four channels", "dither", "bd_fill.seed"),
];

impl Row {
    /// The function that draws.
    pub fn draw(&self, count: usize) -> String {
        format!("{}_draw{count}", self.word)
    }

    /// An entry point by which every pixel draws `count` numbers and stores them.
    pub fn entry(&self, name: &str, count: usize) -> String {
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
fn {name}(@builtin(global_invocation_id) id: vec3<u32>) {{
    if id.x >= bd_fill.width || id.y >= bd_fill.height {{
        return;
    }}
    let pixel = {word}_pixel({sampler}, id.x, id.y, bd_fill.frame);
    let drawn = {word}_draw{count}(pixel, bd_fill.domain, bd_fill.index);
    let place = id.y * bd_fill.width + id.x;
    {stored}
}}
"
        )
    }
}
