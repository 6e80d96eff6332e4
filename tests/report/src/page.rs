//! One HTML page that needs nothing else: text, tables and SVG, light or dark as the reader's device says.

use crate::table::Table;

/// A chapter of the page.
#[derive(Clone, Debug, Default)]
pub struct Chapter {
    pub title: String,
    /// A paragraph of HTML.
    pub text: String,
    /// SVG figures and images.
    pub figures: Vec<String>,
    pub tables: Vec<Table>,
}

const STYLE: &str = "
:root{color-scheme:light dark;--ink:#1b1b1b;--paper:#fdfdfb;--faint:#d9d9d4;--tone:40%}
@media(prefers-color-scheme:dark){:root{--ink:#e6e6e1;--paper:#161618;--faint:#3a3a3e;--tone:65%}}
body{margin:0 auto;max-width:60rem;padding:0 1rem 4rem;color:var(--ink);background:var(--paper);font:1rem/1.5 system-ui,sans-serif}
figure{margin:1rem 0}svg{width:100%;height:auto;font:11px system-ui,sans-serif;fill:var(--ink)}
.g{stroke:var(--faint);fill:none}.l{fill:none;stroke-width:2.4;stroke-linejoin:round}.thin{stroke-width:1.1}
svg g{transition:opacity .15s}svg:has(g:hover) g:not(:hover){opacity:.12}
figcaption{font-size:.85rem;line-height:1.7}figcaption span{margin-right:.9em;white-space:nowrap}
.t{overflow-x:auto}table{border-collapse:collapse;font-size:.85rem;font-variant-numeric:tabular-nums}
th,td{padding:.15rem .6rem;text-align:right;white-space:nowrap;border-bottom:1px solid var(--faint)}
th:first-child,td:first-child{text-align:left;position:sticky;left:0;background:var(--paper)}
summary{cursor:pointer;margin:.4rem 0}img{image-rendering:pixelated;max-width:100%}h2{margin-top:2.5rem}.p{display:inline-block;margin:.3rem}.p img{height:auto;border-radius:3px}nav a{margin-right:1em}a{color:inherit}
@media(max-width:40rem){svg{font-size:19px}.p{width:calc(50% - .7rem)}h1{font-size:1.5rem}}";

pub fn page(title: &str, about: &str, chapters: &[Chapter]) -> String {
    let links: String =
        (0..).zip(chapters).map(|(k, c): (u32, _)| format!("<a href=\"#c{k}\">{}</a> ", c.title)).collect();
    let body: String = (0..).zip(chapters).map(|(k, chapter)| self::chapter(k, chapter)).collect();
    format!(
        "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content=\"width=device-width,initial-scale=1\">\
         <title>{title}</title><style>{STYLE}</style><h1>{title}</h1><p>{about}</p><nav>{links}</nav>{body}</html>\n"
    )
}

fn chapter(number: u32, chapter: &Chapter) -> String {
    // A chapter shows two tables; the others open at a tap.
    let tables: String = chapter.tables.iter().enumerate().map(|(k, one)| table(one, k < 2)).collect();
    format!("<h2 id=c{number}>{}</h2><p>{}</p>{}{tables}", chapter.title, chapter.text, chapter.figures.concat())
}

fn table(table: &Table, open: bool) -> String {
    let row = |cells: &Vec<String>, tag: &str, tint: &dyn Fn(&str) -> String| {
        let cells: String = cells.iter().map(|cell| format!("<{tag}{}>{}</{tag}>", tint(cell), escape(cell))).collect();
        format!("<tr>{cells}</tr>")
    };
    let plain = |_: &str| String::new();
    let tint: &dyn Fn(&str) -> String = if table.about.contains("over that of white noise") { &tint } else { &plain };
    let rows: String = table.rows.iter().map(|cells| row(cells, "td", tint)).collect();
    let (title, about) = (escape(&table.title), escape(&table.about));
    format!(
        "<details{}><summary><b>{title}</b> {about}</summary><div class=t><table>{}{rows}</table></div></details>",
        if open { " open" } else { "" },
        row(&table.head, "th", &plain)
    )
}

/// A background for a number that white noise has as 1: greener below, redder above, full at a quarter and at four
/// times.
fn tint(cell: &str) -> String {
    let number = cell.split([' ', '/']).next().and_then(|text| text.parse::<f64>().ok()).filter(|v| *v > 0.0);
    number.map_or(String::new(), |value| {
        let hue = if value < 1.0 { 150 } else { 10 };
        let depth = (value.log2().abs() / 2.0).min(1.0) * 45.0;
        if depth < 1.0 { String::new() } else { format!(" style=\"background:hsl({hue} 70% 50%/{depth:.0}%)\"") }
    })
}

pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
