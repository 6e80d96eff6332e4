//! One function: its WGSL, its Rust, and whether they agree.

use bluedither::shader::Parts;

use crate::arguments::{CALLS, arguments};
use crate::device::{Bound, Device, Way};

/// The bindings `GIVEN` and `FOUND` of a [`Device`].
const BUFFERS: &str = "
@group(0) @binding(20) var<storage, read> given: array<u32>;
@group(0) @binding(21) var<storage, read_write> found: array<u32>;
";
const ENTRY: &str = "
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let call = id.x;";

/// From the words of the arguments to those of the results.
type Rust = Box<dyn Fn(&[u32], &mut [u32])>;

/// A function of words, by name `a`, `b`, `c`, … in the WGSL.
pub struct Case {
    pub parts: Parts,
    pub tables: Vec<Bound>,
    arguments: usize,
    results: usize,
    /// One expression, after statements that it needs. A vector for more than one result, an array for more than four.
    pub expression: &'static str,
    rust: Rust,
    ways: &'static [Way],
}

/// `expression`, made of `parts`, against `rust`; floats by their bits.
pub fn case<const N: usize, const M: usize>(
    parts: Parts,
    expression: &'static str,
    rust: impl Fn([u32; N]) -> [u32; M] + 'static,
) -> Case {
    let rust = move |given: &[u32], found: &mut [u32]| {
        let given = given.try_into().expect("as many as asked for");
        found.copy_from_slice(&rust(given));
    };
    Case {
        parts,
        tables: Vec::new(),
        arguments: N,
        results: M,
        expression,
        rust: Box::new(rust),
        ways: &[Way::Storage],
    }
}

impl Case {
    /// With a table bound, by each way.
    pub fn with(mut self, table: Bound) -> Self {
        self.tables.push(table);
        self.ways = &[Way::Storage, Way::Texture];
        self
    }

    /// With a table bound that only other functions read, which are called by each way: this one by storage buffers.
    pub fn with_read(mut self, table: Bound) -> Self {
        self.tables.push(table);
        self
    }

    /// The whole shader, with nothing but the parts that the function is said to need.
    pub fn text(&self, way: Way) -> String {
        let texts: String = self.parts.texts().collect();
        let tables: String = self.tables.iter().map(|table| table.text(way)).collect();
        format!("{texts}{tables}{}", self.entry())
    }

    fn entry(&self) -> String {
        format!("{BUFFERS}{ENTRY}\n{}}}\n", self.call())
    }

    /// Statements that read the arguments and write the results.
    fn call(&self) -> String {
        let (n, m) = (self.arguments, self.results);
        let names = ('a'..='z').take(n).zip(0..);
        let names: String = names.map(|(name, k)| format!("    let {name} = given[{n}u * call + {k}u];\n")).collect();
        let (statements, value) = self.expression.rsplit_once("; ").unwrap_or(("", self.expression));
        let end = if statements.is_empty() { "" } else { ";\n" };
        let component = |k| if m == 1 { String::new() } else { format!("[{k}]") };
        let result = |k| format!("    found[{m}u * call + {k}u] = bitcast<u32>(result{});\n", component(k));
        let results: String = (0..m).map(result).collect();
        format!("{names}    {statements}{end}    let result = {value};\n{results}")
    }

    /// Calls it a million times. The error tells the first difference.
    pub fn check(&self, device: &Device) -> Result<(), String> {
        let given = arguments(self.arguments);
        let mut rust = vec![0; CALLS * self.results];
        for (given, rust) in given.chunks(self.arguments).zip(rust.chunks_mut(self.results)) {
            (self.rust)(given, rust);
        }
        for &way in self.ways {
            let groups = [CALLS as u32 / 64, 1];
            let found = device.run(&self.text(way), &self.tables, way, given, rust.len(), groups);
            let calls = given.chunks(self.arguments).zip(rust.chunks(self.results).zip(found.chunks(self.results)));
            let mut apart = calls.filter(|(_, (rust, found))| rust != found);
            if let Some((given, (rust, found))) = apart.next() {
                return Err(format!(
                    "{} of {given:x?}: {rust:x?} in Rust, {found:x?} in the shader ({way:?}), and {} more differ",
                    self.expression,
                    apart.count()
                ));
            }
        }
        Ok(())
    }
}

/// One shader that calls all of the cases.
pub fn all_in_one(parts: Parts, cases: &[&Case], way: Way) -> String {
    let mut tables: Vec<&Bound> = Vec::new();
    for bound in cases.iter().flat_map(|case| &case.tables) {
        // Of two sizes of a mask, the first.
        if !tables.iter().any(|other| other.table == bound.table) {
            tables.push(bound);
        }
    }
    let texts: String = parts.texts().collect();
    let tables: String = tables.iter().map(|table| table.text(way)).collect();
    let calls: String = cases.iter().map(|case| format!("    {{\n{}    }}\n", case.call())).collect();
    format!("{texts}{tables}{BUFFERS}{ENTRY}\n{calls}}}\n")
}
