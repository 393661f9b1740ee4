//! Whole processes: one million GOTO records through `machc post` with the certificate on, against the floor: a post
//! for the one machine written by hand, without checks, limits, whole turns or read-back.
//!
//! `cargo bench --bench throughput [-- RECORDS]` times both in turn and prints the medians and the ratio of each pair.

#[path = "throughput/floor.rs"]
mod floor;
#[path = "throughput/sine_cl.rs"]
mod sine_cl;

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

const PAIRS: usize = 7;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    if let [flag, cl, nc] = &arguments[..]
        && flag == "--floor"
    {
        return floor::post(Path::new(cl), Path::new(nc));
    }
    let records = arguments.first().map_or(1_000_000, |count| count.parse().expect("a number of records"));
    let folder = tempfile::tempdir().expect("a folder for the CL file");
    let (cl, nc) = (folder.path().join("sine.cls"), folder.path().join("sine.nc"));
    std::fs::write(&cl, sine_cl::records(records)).expect("the CL file is written");
    compare(&cl, &nc);
}

fn compare(cl: &Path, nc: &Path) {
    let machine = Path::new(env!("CARGO_MANIFEST_DIR")).join("machines/tmv710a.mach");
    let mut machc = Command::new(env!("CARGO_BIN_EXE_machc"));
    machc.arg("post").arg(machine).arg(cl).arg("-o").arg(nc);
    let mut floor = Command::new(std::env::current_exe().expect("this program has a path"));
    floor.arg("--floor").arg(cl).arg(nc);
    let mut pairs: Vec<[f64; 2]> = (0..=PAIRS).map(|_| [time(&mut floor), time(&mut machc)]).collect();
    pairs.remove(0); // the files are not in the cache yet
    println!("{:<16}{:>8}{:>8}{:>8}   ({PAIRS} pairs)", "", "least", "median", "most");
    row("floor, s", pairs.iter().map(|pair| pair[0]));
    row("machc post, s", pairs.iter().map(|pair| pair[1]));
    row("machc / floor", pairs.iter().map(|pair| pair[1] / pair[0]));
}

fn row(title: &str, values: impl Iterator<Item = f64>) {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let (least, median, most) = (values[0], values[values.len() / 2], values[values.len() - 1]);
    println!("{title:<16}{least:>8.3}{median:>8.3}{most:>8.3}");
}

/// Seconds from start to end of the process.
fn time(command: &mut Command) -> f64 {
    let start = Instant::now();
    let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status().expect("the program starts");
    let time = start.elapsed();
    assert!(status.success(), "{command:?} failed");
    time.as_secs_f64()
}
