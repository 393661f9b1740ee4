//! Writes the CL files beside this folder: `cargo run --example make_cl`.

use std::path::Path;
use std::{fs, io};

mod programs;

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for (name, text) in programs::all() {
        fs::write(folder.join(name), text)?;
    }
    Ok(())
}
