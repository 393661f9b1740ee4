//! The iterated inverses against the closed form.

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;
#[path = "common/stems.rs"]
mod stems;

use machc::numeric::{Method, Numeric};
use program::{posted, posted_by};
use stems::stems;

#[test]
fn explore() {
    for name in stems("machines", "mach") {
        let compiled = machine::compiled(&format!("machines/{name}.mach"), &machine::Files);
        for program in stems("examples", "cls") {
            let cl = format!("examples/{program}.cls");
            let closed = posted(&compiled, &cl);
            for method in [Method::Newton, Method::Broyden] {
                let mut numeric = Numeric::new(&compiled.plan, method);
                let start = std::time::Instant::now();
                let by = posted_by(&mut numeric, &compiled, &cl);
                let time = start.elapsed();
                let (a, b) = (String::from_utf8_lossy(&closed.nc).into_owned(), String::from_utf8_lossy(&by.nc).into_owned());
                let diff = a.lines().zip(b.lines()).filter(|(a, b)| a != b).count();
                let codes = |p: &program::Posted| p.diagnostics.iter().map(|d| d.code.id).collect::<Vec<_>>();
                let e = numeric.effort();
                let same = a == b && codes(&closed) == codes(&by);
                println!("{name} {program} {method:?} same={same} diff={diff}/{} codes {}/{} mean {:.1} most {} bis {} search {}/{} {time:?}", a.lines().count(), codes(&closed).len(), codes(&by).len(),
                    e.mean_iterations(), e.most_iterations, e.bisections, e.searches, e.poses);
                if !same { if let Some((a, b)) = a.lines().zip(b.lines()).find(|(a, b)| a != b) { println!("   {a}\n   {b}"); }
                  if codes(&closed) != codes(&by) { println!("   {:?} {:?}", codes(&closed), codes(&by)); } }
            }
        }
    }
}
