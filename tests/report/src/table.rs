//! Tables: the one form in which numbers leave, as Markdown, CSV and HTML.

/// A titled table of text; the first column names the rows.
#[derive(Clone, Debug)]
pub struct Table {
    /// Its name as a file.
    pub id: String,
    pub title: String,
    /// What the numbers mean, in a sentence or two.
    pub about: String,
    pub head: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Table {
    pub fn markdown(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule: Vec<String> =
            self.head.iter().enumerate().map(|(k, _)| if k == 0 { "---" } else { "---:" }.into()).collect();
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        format!("### {}\n\n{}\n\n{}{}{rows}", self.title, self.about, line(&self.head), line(&rule))
    }

    pub fn csv(&self) -> String {
        let quote = |cell: &String| {
            if cell.contains([',', '"', '\n']) { format!("\"{}\"", cell.replace('"', "\"\"")) } else { cell.clone() }
        };
        let line = |cells: &Vec<String>| cells.iter().map(quote).collect::<Vec<_>>().join(",") + "\n";
        core::iter::once(&self.head).chain(&self.rows).map(line).collect()
    }
}
