//! The sources that every generated post is built from are part of machc: a new file among them is a new machc.

fn main() {
    println!("cargo:rerun-if-changed=runtime/src");
    println!("cargo:rerun-if-changed=command/src");
}
