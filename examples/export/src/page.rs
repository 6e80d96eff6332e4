//! A page that runs the WGSL in the browser: `examples/web` in one file, which needs no server.

use crate::folder::{Folder, version};
use crate::shaders::{self, Use};
use base64::prelude::*;

/// What stands in the page at `@name@`.
const PARTS: [(&str, &str); 4] = [
    ("style.css", include_str!("../../web/style.css")),
    ("error.js", include_str!("../../web/error.js")),
    ("gpu.js", include_str!("../../web/gpu.js")),
    ("page.js", include_str!("../../web/page.js")),
];

/// Writes the page.
pub fn write(folder: &mut Folder) -> Result<(), String> {
    folder.write("index.html", "a page that compares the samplers, to be opened in a browser", page().as_bytes())
}

/// The text of the page.
pub fn page() -> String {
    let mut page = include_str!("../../web/index.html").to_string();
    for (name, text) in PARTS {
        page = page.replace(&format!("/* @{name}@ */\n"), text);
    }
    page.replace("/* @data@ */\n", &data())
}

/// The shaders and tables, as a script's constant.
fn data() -> String {
    let samplers: Vec<String> = shaders::USES.iter().filter(|each| each.is_sampler()).map(sampler).collect();
    let scene = quoted(include_str!("../../web/scene.wgsl"));
    let show = quoted(include_str!("../../web/show.wgsl"));
    let version = quoted(&format!("bluedither {}", version()));
    let samplers = samplers.join(",\n");
    format!("const DATA = {{ version: {version}, scene: {scene}, show: {show}, samplers: [\n{samplers}\n] }};\n")
}

fn sampler(each: &Use) -> String {
    let table = |bound: &shaders::Bound| {
        let base64 = BASE64_STANDARD.encode(bound.bytes());
        format!("{{ binding: {}, base64: \"{base64}\" }}", bound.table.binding)
    };
    let tables: Vec<_> = each.tables.iter().map(table).collect();
    let (title, word) = (each.title, each.name);
    let wgsl = quoted(&each.text());
    format!("{{ name: \"{title}\", word: \"{word}\", tables: [{}], wgsl: {wgsl} }}", tables.join(", "))
}

/// A string of JavaScript, inside HTML.
fn quoted(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n").replace('<', "\\u003c");
    format!("\"{text}\"")
}
