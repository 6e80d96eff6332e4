//! Plots as SVG text, in the page's own colours: written by hand, so that one style sheet serves light and dark.

use core::fmt::Write;

/// A line with its points, or points alone.
#[derive(Clone, Debug)]
pub struct Series {
    pub name: String,
    /// A place on the colour wheel in degrees; `None` is the colour of the text.
    pub hue: Option<u32>,
    pub dashed: bool,
    pub thin: bool,
    pub dots: bool,
    pub points: Vec<[f64; 2]>,
}

/// One axis.
#[derive(Clone, Debug)]
pub struct Axis {
    pub label: String,
    pub logarithmic: bool,
    /// Labelled places; none: powers of ten, or eight steps.
    pub ticks: Vec<f64>,
}

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 450.0;
const LEFT: f64 = 62.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 28.0;
const BOTTOM: f64 = 50.0;

/// The plot of some series, their names in a legend below.
pub fn plot(axes: [&Axis; 2], series: &[Series]) -> String {
    let spans = [0, 1].map(|k| span(axes[k], series.iter().flat_map(|s| s.points.iter().map(move |p| p[k]))));
    let place = |[x, y]: [f64; 2]| {
        let [u, v] = [(0, x), (1, y)].map(|(k, value)| {
            let [low, high] = spans[k];
            (scaled(axes[k], value) - low) / (high - low)
        });
        [LEFT + u * (WIDTH - LEFT - RIGHT), TOP + (1.0 - v) * (HEIGHT - TOP - BOTTOM)]
    };
    let mut svg = format!("<figure><svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\">");
    for (k, axis) in axes.into_iter().enumerate() {
        for tick in ticks(axis, spans[k]) {
            let corner = [spans[0][0], spans[1][0]].map(|v| v);
            let mut at = [unscaled(axes[0], corner[0]), unscaled(axes[1], corner[1])];
            at[k] = tick;
            let [x, y] = place(at);
            let text = number(tick);
            _ = if k == 0 {
                write!(
                    svg,
                    "<path class=g d=\"M{x:.1} {TOP}V{:.1}\"/><text x={x:.1} y={:.1} text-anchor=middle>{text}</text>",
                    HEIGHT - BOTTOM,
                    HEIGHT - BOTTOM + 18.0
                )
            } else {
                write!(
                    svg,
                    "<path class=g d=\"M{LEFT} {y:.1}H{:.1}\"/><text x={:.1} y={:.1} text-anchor=end>{text}</text>",
                    WIDTH - RIGHT,
                    LEFT - 6.0,
                    y + 4.0
                )
            };
        }
    }
    _ = write!(
        svg,
        "<text x={:.1} y={:.1} text-anchor=middle>{}</text>",
        0.5 * (WIDTH + LEFT),
        HEIGHT - 7.0,
        axes[0].label
    );
    // Above the plot and not along the axis, where large letters would meet the numbers.
    _ = write!(svg, "<text x=4 y=16>{}</text>", axes[1].label);
    for line in series {
        let path: Vec<String> = line.points.iter().map(|&p| place(p)).map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
        let dash = if line.dashed { " stroke-dasharray=\"5 4\"" } else { "" };
        let (class, radius) = if line.thin { ("l thin", 2.2) } else { ("l", 3.4) };
        _ = write!(
            svg,
            "<g><title>{}</title><path class=\"{class}\" style=\"stroke:{}\"{dash} d=\"M{}\"/>",
            line.name,
            colour(line.hue),
            path.join("L")
        );
        for &point in line.points.iter().filter(|_| line.dots) {
            let [x, y] = place(point);
            let title = format!("{}: {}, {}", line.name, number(point[0]), number(point[1]));
            _ = write!(
                svg,
                "<circle cx={x:.1} cy={y:.1} r={radius} style=\"fill:{}\"><title>{title}</title></circle>",
                colour(line.hue)
            );
        }
        svg += "</g>";
    }
    svg += "</svg><figcaption>";
    for line in series {
        let mark = match (line.dashed, line.thin) {
            (true, _) => "┅",
            (_, true) => "─",
            _ => "━",
        };
        _ = write!(svg, "<span><b style=\"color:{}\">{mark}</b> {}</span> ", colour(line.hue), line.name);
    }
    svg + "</figcaption></figure>"
}

fn colour(hue: Option<u32>) -> String {
    hue.map_or("var(--ink)".into(), |hue| format!("hsl({hue} 65% var(--tone))"))
}

/// Hues far from each other for neighbours in a list of `count`.
pub fn hue(place: usize, count: usize) -> u32 {
    (place * 360 / count.max(1)) as u32
}

fn scaled(axis: &Axis, value: f64) -> f64 {
    if axis.logarithmic { value.max(1e-12).log10() } else { value }
}

fn unscaled(axis: &Axis, value: f64) -> f64 {
    if axis.logarithmic { 10f64.powf(value) } else { value }
}

fn span(axis: &Axis, values: impl Iterator<Item = f64>) -> [f64; 2] {
    let bounds = |[low, high]: [f64; 2], v: f64| [low.min(v), high.max(v)];
    let [low, high] = values
        .chain(axis.ticks.iter().copied())
        .map(|v| scaled(axis, v))
        .fold([f64::INFINITY, f64::NEG_INFINITY], bounds);
    // One value, or none: any span will do.
    if low >= high {
        return if low > high { [0.0, 1.0] } else { [low - 0.5, low + 0.5] };
    }
    let margin = 0.03 * (high - low);
    [if axis.logarithmic || low < 0.0 { low - margin } else { 0.0 }, high + margin]
}

fn ticks(axis: &Axis, [low, high]: [f64; 2]) -> Vec<f64> {
    if !axis.ticks.is_empty() {
        return axis.ticks.clone();
    }
    if axis.logarithmic {
        let steps: &[f64] = if high - low > 3.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let decades = low.floor() as i32..=high.ceil() as i32;
        let all = decades.flat_map(|e| steps.iter().map(move |s| s * 10f64.powi(e)));
        return all.filter(|v| (low..=high).contains(&v.log10())).collect();
    }
    let step = 10f64.powf(((high - low) / 6.0).log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|m| m * step).into_iter().find(|s| (high - low) / s < 8.0).unwrap_or(step);
    (0..20).map(|k| (low / step).ceil() * step + f64::from(k) * step).filter(|v| *v <= high).collect()
}

/// Four digits at most.
fn number(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        v if !(1e-3..1e5).contains(&v) => format!("{value:.0e}"),
        v if v >= 100.0 => format!("{value:.0}"),
        v => {
            let digits = (2 - v.log10().floor() as i32).clamp(0, 5) as usize;
            let text = format!("{value:.digits$}");
            text.trim_end_matches('0').trim_end_matches('.').to_string()
        }
    }
}
