//! The README's table of what calls cost a Cortex-M0, made from what `run.sh` measures, and checked against it.
//!
//! `cost` prints the keys of the calls. `cost README.md` reads a line for each, "key code constants stack floats",
//! prints the table, and fails where the README has other rows, or less than four fifths of a number; `cost README.md
//! --write` puts the table there instead. `floats` counts the functions of floating point that a call links: integer
//! paths have none.

use firmware::calls::CALLS;
use std::io::Read;

const OPEN: &str = "<!-- firmware: cost -->\n";
const CLOSE: &str = "<!-- /firmware -->";
/// Growth that is no news: a quarter, and this many bytes.
const SLACK: u32 = 64;

/// Bytes of code, of constants and of stack.
type Cost = [u32; 3];

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some(path) = arguments.first() else {
        CALLS.iter().for_each(|call| println!("{}", call.key));
        println!("integers");
        return Ok(());
    };
    let mut input = String::new();
    std::io::stdin().read_to_string(&mut input).map_err(|error| format!("no measurements ({error})"))?;
    let costs = measured(&input)?;
    let table = table(&costs);
    print!("{table}");
    let readme = std::fs::read_to_string(path).map_err(|error| format!("{path} cannot be read ({error})"))?;
    let (before, rest) = readme.split_once(OPEN).ok_or(format!("{path} has no line {OPEN:?}"))?;
    let (stated, after) = rest.split_once(CLOSE).ok_or(format!("{path} has no {CLOSE:?}"))?;
    if arguments.iter().any(|argument| argument == "--write") {
        let text = format!("{before}{OPEN}{table}{CLOSE}{after}");
        return std::fs::write(path, text).map_err(|error| format!("{path} cannot be written ({error})"));
    }
    compare(stated, &costs)
}

/// The cost of each call, in their order.
fn measured(input: &str) -> Result<Vec<Cost>, String> {
    let line = |key: &str| {
        let mut words =
            input.lines().map(str::split_whitespace).find_map(|mut line| (line.next() == Some(key)).then_some(line))?;
        let mut number = || words.next()?.parse::<u32>().ok();
        Some(([number()?, number()?, number()?], number()?))
    };
    let no_line = |key: &str| format!("{key} was not measured");
    let (_, floats) = line("integers").ok_or_else(|| no_line("integers"))?;
    if floats > 0 {
        return Err(format!("integer functions link {floats} functions of floating point"));
    }
    let mut costs = Vec::new();
    for call in CALLS {
        let (cost, floats) = line(call.key).ok_or_else(|| no_line(call.key))?;
        if call.floats != (floats > 0) {
            return Err(format!("{} links {floats} functions of floating point", call.name));
        }
        costs.push(cost);
    }
    Ok(costs)
}

fn table(costs: &[Cost]) -> String {
    let rows = CALLS
        .iter()
        .zip(costs)
        .map(|(call, [code, constants, stack])| format!("| {} | {code} | {constants} | {stack} |\n", call.name));
    let head = "| call | code | constants | stack |\n|---|---:|---:|---:|\n".to_string();
    rows.fold(head, |table, row| table + &row)
}

/// Whether the README's table has these rows, and nothing has grown.
fn compare(stated: &str, costs: &[Cost]) -> Result<(), String> {
    let hint = "note why, and write the table anew: tests/firmware/run.sh --write";
    let shape = |table: &str| -> Vec<String> {
        table.lines().map(|line| line.chars().filter(|c| !c.is_ascii_digit()).collect()).collect()
    };
    if shape(stated) != shape(&table(costs)) {
        return Err(format!("the README has other rows or columns of costs; {hint}"));
    }
    for ((call, cost), line) in CALLS.iter().zip(costs).zip(stated.lines().skip(2)) {
        let numbers = line.rsplit('|').skip(1).take(3).map(|cell| cell.trim().parse::<u32>().unwrap_or(0));
        for (&cost, stated) in cost.iter().rev().zip(numbers) {
            if cost > stated + stated / 4 + SLACK {
                return Err(format!("{} takes {cost} bytes where the README says {stated}; {hint}", call.name));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod checks {
    use super::*;

    fn input(code: u32, floats: u32) -> String {
        let line = |call: &firmware::calls::Call| format!("{} {code} 2 3 {}\n", call.key, u32::from(call.floats));
        CALLS.iter().map(line).collect::<String>() + &format!("integers 9 9 9 {floats}\n")
    }

    #[test]
    fn growth_rows_and_floats_are_seen() {
        let stated = table(&measured(&input(1000, 0)).expect("whole"));
        let against = |code| compare(&stated, &measured(&input(code, 0)).expect("whole"));
        assert_eq!((against(500), against(1314)), (Ok(()), Ok(())));
        assert!(against(1315).is_err_and(|line| line.contains("1315 bytes where the README says 1000")));
        let without_a_row = stated.replacen("| `Keyed`", "| `Other`", 1);
        assert!(compare(&without_a_row, &measured(&input(1000, 0)).expect("whole")).is_err());
        assert!(measured(&input(1000, 1)).is_err_and(|line| line.contains("link 1 functions")));
        assert!(measured("rank 1 2 3 0\n").is_err_and(|line| line.contains("was not measured")));
        let floating = input(1000, 0).replace("rank 1000 2 3 0", "rank 1000 2 3 4");
        assert!(measured(&floating).is_err_and(|line| line.contains("links 4 functions")));
    }
}
