//! Generated source compiles and computes what the interpreter computes.

#[path = "../common/machine.rs"]
mod machine;
#[path = "../common/rows.rs"]
mod rows;
#[path = "../common/stems.rs"]
mod stems;

mod blocks;
mod c;
mod golden;
mod rust;

use machc::compile::Compiled;

/// The shipped machines.
fn library() -> Vec<Compiled> {
    let names = stems::stems("machines", "mach");
    names.iter().map(|name| machine::compiled(&format!("machines/{name}.mach"), &machine::Files)).collect()
}
