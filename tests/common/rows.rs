//! `tests/linuxcnc/rows.json`: what LinuxCNC's kinematics modules compute for the machines beside it.

use crate::machine;
use mach_runtime::vector::Vec3;
use machc::sources::Sources;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;

/// One pose.
#[derive(Deserialize)]
pub(crate) struct Row {
    pub(crate) parameters: BTreeMap<String, f64>,
    pub(crate) tip: Vec3,
    pub(crate) joints: BTreeMap<String, f64>,
}

/// Machine files with a row's values behind their `let`s.
pub(crate) struct Templates<'a>(pub(crate) &'a Row);

impl Sources for Templates<'_> {
    fn read(&self, path: &str) -> Result<String, String> {
        let template = machine::Files.read(path)?;
        let mut left: Vec<&str> = self.0.parameters.keys().map(String::as_str).collect();
        let text = template.lines().map(|line| {
            let Some((name, value)) = line.trim_start().strip_prefix("let ").and_then(|rest| rest.split_once(" = "))
            else {
                return line.to_owned() + "\n";
            };
            let name = name.trim_end();
            left.retain(|parameter| *parameter != name);
            let unit = value.split_whitespace().nth(1).expect("every parameter has a unit");
            format!("let {name} = {} {unit}\n", self.0.parameters[name])
        });
        let text = text.collect();
        assert!(left.is_empty(), "no parameter of the machine is called {left:?}");
        Ok(text)
    }
}

/// The rows of every machine, by its name.
pub(crate) fn all() -> BTreeMap<String, Vec<Row>> {
    let rows = fs::read_to_string(machine::root().join("tests/linuxcnc/rows.json")).expect("readable");
    let machines: BTreeMap<String, Vec<Row>> = serde_json::from_str(&rows).expect("rows of numbers");
    assert_eq!(machines.len(), 9);
    machines
}
