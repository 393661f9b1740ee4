//! The `machc` command.

fn main() {}
