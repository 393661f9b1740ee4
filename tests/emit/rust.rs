//! Generated Rust: every shipped machine is a module of one crate, which is built and asked.

use crate::blocks::{Block, blocks};
use crate::{library, machine};
use mach_runtime::kinematics::{JointBlock, Kinematics, LANES, Lane, PoseBlock, SolutionBlock};
use mach_runtime::machine::ToolGeometry;
use machc::compile::Compiled;
use machc::emit::rust::rust;
use machc::model::tables;
use machc::plan::Interpreter;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

include!("answer.rs");

/// Machines with names that a programming language keeps for itself, or that values of the code have.
const AWKWARD: &str = r#"
machine awkward "names that are taken: */ \" ///" {
    chain w Self As b Fn Tip_x T1 t
    linear Fn    along (1, 0.2, 0)
    linear Tip_x along +y
    linear T1    along +z
    rotary As    about +x  // a comment
                 through (10, 20, 30)
    rotary Self  about (0.3, 0, 1)
    tool along +z
}
"#;

struct Awkward;

impl machc::sources::Sources for Awkward {
    fn read(&self, _: &str) -> Result<String, String> {
        Ok(AWKWARD.replace("\\\"", "'"))
    }
}

fn machines() -> Vec<Compiled> {
    let mut machines = library();
    machines.push(machine::compiled("awkward.mach", &Awkward));
    machines
}

/// Writes the crate and builds it; the program's path.
fn built(machines: &[Compiled]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("emitted");
    let source = folder.join("src");
    fs::create_dir_all(source.join("machines")).expect("writable");
    let write = |path: PathBuf, text: &str| {
        // What did not change is not built again.
        if fs::read_to_string(&path).ok().as_deref() != Some(text) {
            fs::write(path, text).expect("writable");
        }
    };
    let runtime = machine::root().join("runtime");
    let manifest = format!(
        "[package]\nname = \"emitted\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\n\
         libm = \"0.2\"\nmach-runtime = {{ path = {runtime:?} }}\n\n[lints.rust]\nwarnings = \"deny\"\n\
         missing_docs = \"warn\"\n\n[profile.dev]\ndebug = false\nincremental = false\n"
    );
    write(folder.join("Cargo.toml"), &manifest);
    write(folder.join("Cargo.lock"), &lock_file());
    write(source.join("main.rs"), include_str!("harness.rs"));
    write(source.join("answer.rs"), include_str!("answer.rs"));
    write(source.join("machines.rs"), &index(machines));
    for machine in machines {
        write(source.join(format!("machines/{}.rs", machine.model.name)), &rust(machine));
    }
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--quiet", "--offline"]).current_dir(&folder).env("CARGO_TARGET_DIR", folder.join("target"));
    let output = cargo.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder.join("target/debug/emitted")
}

/// The project's own lock file: whatever it has is at hand without a network.
fn lock_file() -> String {
    fs::read_to_string(machine::root().join("Cargo.lock")).expect("readable")
}

/// The module that knows every machine by its name.
fn index(machines: &[Compiled]) -> String {
    let (mut modules, mut solvers, mut tables) = (String::new(), String::new(), String::new());
    for Compiled { model, .. } in machines {
        let name = &model.name;
        let dialect = if model.dialect.is_some() { format!("Some({name}::rig().dialect)") } else { "None".to_owned() };
        writeln!(modules, "mod {name};").expect("strings can be written");
        writeln!(solvers, "{name:?} => Box::new({name}::Solver),").expect("strings can be written");
        writeln!(tables, "{name:?} => ({name}::machine(), {dialect}),").expect("strings can be written");
    }
    format!(
        "//! Every machine.\n\n{modules}
use mach_runtime::kinematics::Kinematics;
use mach_runtime::nc::dialect::Dialect;

/// The solver of this name.
pub fn solver(name: &str) -> Box<dyn Kinematics> {{
    match name {{ {solvers} _ => unreachable!() }}
}}

/// The tables of this name.
pub fn tables(name: &str) -> String {{
    let tables: (_, Option<Dialect>) = match name {{ {tables} _ => unreachable!() }};
    format!(\"{{tables:?}}\")
}}
"
    )
}

fn run(program: &Path, arguments: &[&str], input: &[u8]) -> Vec<u8> {
    let mut process = Command::new(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    process.stdin.take().expect("piped").write_all(input).expect("it reads everything first");
    let output = process.wait_with_output().expect("it ends");
    assert!(output.status.success());
    output.stdout
}

fn bytes(blocks: &[Block]) -> Vec<u8> {
    let mut numbers = Vec::new();
    for Block { tool, poses, joints } in blocks {
        numbers.push(tool.length_mm);
        poses.tip_mm.iter().chain(&poses.axis).chain(joints).for_each(|lane| numbers.extend(lane));
    }
    numbers.into_iter().flat_map(f64::to_le_bytes).collect()
}

fn same_bits(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn generated_rust_computes_the_bits_of_the_interpreter() {
    let machines = machines();
    assert!(machines.len() >= 26);
    let program = built(&machines);
    for machine in &machines {
        let name = &machine.model.name;
        let (blocks, mut expected) = (blocks(machine), Vec::new());
        let mut interpreter = Interpreter::new(&machine.plan);
        for Block { tool, poses, joints } in &blocks {
            answer(&mut interpreter, *tool, poses, joints, &mut expected);
        }
        let found = run(&program, &["solve", name], &bytes(&blocks));
        let found: Vec<f64> =
            found.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().expect("eight"))).collect();
        assert_eq!(found.len(), expected.len(), "{name}");
        let wrong = (0..found.len()).find(|&place| !same_bits(found[place], expected[place]));
        assert_eq!(wrong.map(|place| (found[place], expected[place])), None, "{name}");
        let tables = (tables::machine(&machine.model), &machine.model.dialect);
        assert_eq!(String::from_utf8(run(&program, &["tables", name], &[])), Ok(format!("{tables:?}")));
    }
}
