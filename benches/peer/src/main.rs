//! Every inverse solution of the same poses, in turn: solvers that machc generates for machine tools, and a published
//! crate's for a robot. What can be compared and what cannot is in `benches/README.md`.
//!
//! `cargo run --release --manifest-path benches/peer/Cargo.toml`

mod generated;
mod poses;
mod robot;

use generated::{Machine, dmu50ev, tmv710a};
use robot::Robot;
use std::time::Instant;

const POSES: usize = 4096;
const ROUNDS: usize = 201;
const GAUGE_LENGTH_MM: f64 = 150.0;

/// One way to solve all poses.
struct Contestant<'a> {
    name: &'a str,
    /// Solves them; how many solutions there are.
    solve: Box<dyn FnMut() -> usize + 'a>,
    /// How many of these lead back to their pose.
    right: usize,
}

fn main() {
    let poses = poses::seeded(POSES);
    let robot = Robot::new(&poses);
    let mut contestants = vec![
        Contestant { name: "robot, pose", right: robot.right(), solve: Box::new(|| robot.solve()) },
        Contestant {
            name: "robot, tip and axis",
            right: robot.right_without_roll(),
            solve: Box::new(|| robot.solve_without_roll()),
        },
    ];
    contestants.extend(machine("tmv710a", "tmv710a, checked", || Machine::new(tmv710a::Solver, &poses)));
    contestants.extend(machine("dmu50ev", "dmu50ev, checked", || Machine::new(dmu50ev::Solver, &poses)));
    let rounds = measure(&mut contestants);
    print(&contestants, &rounds);
}

/// A machine as it is generated, and with every solution put through its forward chain.
fn machine<'a, K: mach_runtime::kinematics::Kinematics + 'a>(
    name: &'a str,
    checked: &'a str,
    new: impl Fn() -> Machine<K>,
) -> [Contestant<'a>; 2] {
    let (mut plain, mut again) = (new(), new());
    let right = again.solve_and_check();
    [
        Contestant { name, right, solve: Box::new(move || plain.solve()) },
        Contestant { name: checked, right, solve: Box::new(move || again.solve_and_check()) },
    ]
}

/// Nanoseconds a pose, by round and contestant. Everyone runs once in every round, so that all meet the same disturbances.
fn measure(contestants: &mut [Contestant<'_>]) -> Vec<Vec<f64>> {
    let round = |_| contestants.iter_mut().map(time).collect();
    let mut rounds: Vec<Vec<f64>> = (0..=ROUNDS).map(round).collect();
    rounds.remove(0); // nothing is in the caches yet
    rounds
}

fn time(contestant: &mut Contestant<'_>) -> f64 {
    let start = Instant::now();
    let found = (contestant.solve)();
    let spent = start.elapsed();
    // Whoever is faster must not be so by being wrong.
    assert_eq!(found, contestant.right, "{}: not every solution leads back to its pose", contestant.name);
    spent.as_nanos() as f64 / POSES as f64
}

fn print(contestants: &[Contestant<'_>], rounds: &[Vec<f64>]) {
    println!("{POSES} poses, {ROUNDS} rounds, ns\n");
    println!("| | solutions a pose | a pose, least | median | a solution, least | median |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for (index, Contestant { name, right, .. }) in contestants.iter().enumerate() {
        let mut spent: Vec<f64> = rounds.iter().map(|round| round[index]).collect();
        spent.sort_by(f64::total_cmp);
        let (least, median) = (spent[0], spent[ROUNDS / 2]);
        let each = *right as f64 / POSES as f64;
        println!("| {name} | {each:.2} | {least:.0} | {median:.0} | {:.0} | {:.0} |", least / each, median / each);
    }
}
