//! Whole processes: one million GOTO records through `machc post` with the certificate on, against the floor: a post
//! for the one machine written by hand, without checks, limits, whole turns or read-back.
//!
//! `cargo bench --bench throughput [-- RECORDS]` times the floor, one thread and two in turn, and prints the ratios round by
//! round.

#[path = "throughput/floor.rs"]
mod floor;
#[path = "throughput/sine_cl.rs"]
mod sine_cl;

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

const ROUNDS: usize = 7;

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
    let machc = |threads| {
        let mut machc = Command::new(env!("CARGO_BIN_EXE_machc"));
        machc.args(["post", "--threads", threads]).arg(&machine).arg(cl).arg("-o").arg(nc);
        machc
    };
    let (mut one, mut two) = (machc("1"), machc("2"));
    let mut floor = Command::new(std::env::current_exe().expect("this program has a path"));
    floor.arg("--floor").arg(cl).arg(nc);
    let mut rounds: Vec<[f64; 3]> = (0..=ROUNDS).map(|_| [time(&mut floor), time(&mut one), time(&mut two)]).collect();
    rounds.remove(0); // the files are not in the cache yet
    println!("{:<24}{:>8}{:>8}{:>8}   ({ROUNDS} rounds)", "", "least", "median", "most");
    row("floor, s", rounds.iter().map(|round| round[0]));
    for (threads, index) in [("one thread", 1), ("two threads", 2)] {
        row(&format!("{threads}, s"), rounds.iter().map(|round| round[index]));
        row(&format!("{threads} / floor"), rounds.iter().map(|round| round[index] / round[0]));
    }
}

fn row(title: &str, values: impl Iterator<Item = f64>) {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let (least, median, most) = (values[0], values[values.len() / 2], values[values.len() - 1]);
    println!("{title:<24}{least:>8.3}{median:>8.3}{most:>8.3}");
}

/// Seconds from start to end of the process.
fn time(command: &mut Command) -> f64 {
    let start = Instant::now();
    let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status().expect("the program starts");
    let time = start.elapsed();
    assert!(status.success(), "{command:?} failed");
    time.as_secs_f64()
}
