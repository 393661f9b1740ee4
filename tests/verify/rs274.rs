//! LinuxCNC's own interpreter, where it is installed (the program `rs274` of Debian's package `linuxcnc-uspace`), as a second
//! opinion: it makes the same canonical motion of a program as the control's model does.

use super::stems::stems;
use super::verified::Setup;
use mach_runtime::control::Control;
use mach_runtime::dialect::meaning::Spindle;
use mach_runtime::machine::{Axis, Motion as AxisMotion};
use mach_runtime::motion::{Event, Feed, Item, Law, Motion, State, What};
use mach_runtime::tool::ToolGeometry;
use mach_runtime::unit::LengthUnit;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

/// The axes of a canonical motion, in its order.
const AXES: [&str; 6] = ["X", "Y", "Z", "A", "B", "C"];

/// The canonical commands that are compared.
const COMPARED: [&str; 8] = [
    "STRAIGHT_TRAVERSE(",
    "STRAIGHT_FEED(",
    "ARC_FEED(",
    "CHANGE_TOOL(",
    "DWELL(",
    "PROGRAM_STOP(",
    "OPTIONAL_PROGRAM_STOP(",
    "PROGRAM_END(",
];

/// What the interpreter makes of a program: its commands, cuts with feed, speed and sense of the spindle; `None` where it is not
/// installed.
fn interpreted(nc: &str, folder: &Path) -> Option<Vec<String>> {
    let tools: String = (1..100).map(|tool| format!("T{tool} P{tool} Z0 D0\n")).collect();
    fs::write(folder.join("tools.tbl"), tools).expect("writable");
    fs::write(folder.join("part.ngc"), nc).expect("writable");
    let run = Command::new("rs274").args(["-g", "-t", "tools.tbl", "part.ngc"]).current_dir(folder).output();
    let output = match run {
        Err(error) if error.kind() == ErrorKind::NotFound => return None,
        run => run.expect("rs274 runs"),
    };
    let text = String::from_utf8_lossy(&output.stdout);
    let (mut feed, mut speed, mut spindle) = (String::new(), String::new(), "off");
    let mut commands = Vec::new();
    for command in text.lines().filter_map(|line| line.split_once("N..... ")).map(|(_, command)| command) {
        let argument = command.trim_end_matches(')').rsplit(['(', ' ']).next().unwrap_or("");
        match command.split('(').next().unwrap_or("") {
            "SET_FEED_RATE" => argument.clone_into(&mut feed),
            "SET_SPINDLE_SPEED" => argument.clone_into(&mut speed),
            "START_SPINDLE_CLOCKWISE" => spindle = "clockwise",
            "START_SPINDLE_COUNTERCLOCKWISE" => spindle = "counterclockwise",
            "STOP_SPINDLE_TURNING" => spindle = "off",
            "STRAIGHT_FEED" | "ARC_FEED" => commands.push(format!("{command} F{feed} S{speed} {spindle}")),
            _ if COMPARED.iter().any(|it| command.starts_with(it)) => commands.push(command.to_owned()),
            _ => {}
        }
    }
    Some(commands)
}

/// The same of the control's model.
struct Model<'a> {
    axes: &'a [Axis],
    units: LengthUnit,
}

impl Model<'_> {
    fn commands(&self, setup: &Setup, nc: &str) -> Vec<String> {
        let mut control = Control::new(&setup.rig.dialect.table, self.axes, ToolGeometry::of_length(0.0));
        let mut motion = Motion::new(self.axes.len());
        for (number, line) in (1..).zip(nc.lines()) {
            control.run(line, number, &mut motion).unwrap_or_else(|error| panic!("{line}: {error:?}"));
        }
        motion.items().iter().map(|item| self.command(&motion, item)).collect()
    }

    fn command(&self, motion: &Motion, item: &Item) -> String {
        let state = motion.state(item);
        match item.what {
            What::Event(Event::ToolChange(tool)) => format!("CHANGE_TOOL({tool})"),
            What::Event(Event::Dwell(seconds)) => format!("DWELL({})", number(seconds)),
            What::Event(Event::Stop) => "PROGRAM_STOP()".to_owned(),
            What::Event(Event::OptionalStop) => "OPTIONAL_PROGRAM_STOP()".to_owned(),
            What::Event(Event::End) => "PROGRAM_END()".to_owned(),
            What::Move(it) => {
                let ends = AXES.map(|name| self.end(name, motion.joints(&it)));
                match it.law {
                    Law::Rapid => format!("STRAIGHT_TRAVERSE({})", list(&ends)),
                    Law::Line => format!("STRAIGHT_FEED({}) {}", list(&ends), self.cut(state)),
                    Law::Arc(arc) => {
                        let arc = motion.arc(arc);
                        let [first, second, normal] = match arc.normal {
                            [_, _, 1.0] => [0, 1, 2],
                            [_, 1.0, _] => [2, 0, 1],
                            _ => [1, 2, 0],
                        };
                        let centre = arc.centre_mm.map(|it| it / self.length());
                        let flat = [ends[first], ends[second], centre[first], centre[second]];
                        let turns = arc.sweep_rad.signum();
                        let rest = [ends[normal], ends[3], ends[4], ends[5]];
                        format!("ARC_FEED({}, {turns}, {}) {}", list(&flat), list(&rest), self.cut(state))
                    }
                }
            }
        }
    }

    /// What a unit of length is, in millimetres.
    fn length(&self) -> f64 {
        if self.units == LengthUnit::Inch { 25.4 } else { 1.0 }
    }

    /// Where the axis of this name ends, in the program's units.
    fn end(&self, name: &str, joints: &[f64]) -> f64 {
        let found = self.axes.iter().zip(joints).find(|(axis, _)| axis.name == name);
        let unit = |axis: &Axis| if axis.motion == AxisMotion::Linear { self.length() } else { 1.0 };
        found.map_or(0.0, |(axis, joint)| joint / unit(axis))
    }

    fn cut(&self, state: &State) -> String {
        let feed = match state.feed {
            Some(Feed::PerMinute(feed) | Feed::PerRevolution(feed)) => feed / self.length(),
            Some(Feed::Inverse(_)) | None => 0.0,
        };
        let spindle = match state.spindle {
            Spindle::Off => "off",
            Spindle::Clockwise => "clockwise",
            Spindle::Counterclockwise => "counterclockwise",
        };
        format!("F{} S{} {spindle}", number(feed), number(state.speed_rpm))
    }
}

fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    if text == "-0.0000" { "0.0000".to_owned() } else { text }
}

fn list(values: &[f64]) -> String {
    values.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ")
}

/// Both read a program alike; whether the interpreter is installed.
fn is_read_alike(name: &str, setup: &Setup, nc: &str, folder: &Path) -> bool {
    let Some(expected) = interpreted(nc, folder) else { return false };
    // Words are what counts: no zero and no length in the model either.
    let plain = |axis: &Axis| Axis { zero: 0.0, length_share: 0.0, ..axis.clone() };
    let axes: Vec<Axis> = setup.rig.machine.axes.iter().map(plain).collect();
    let units = if nc.contains("G20") { LengthUnit::Inch } else { LengthUnit::Millimetre };
    let found = Model { axes: &axes, units }.commands(setup, nc);
    for (at, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert_eq!(found, expected, "{name}, command {at}");
    }
    assert_eq!(found.len(), expected.len(), "{name}: {:?}", &expected[found.len().min(expected.len())..]);
    true
}

const NOT_INSTALLED: &str = "not compared: `rs274` of LinuxCNC is not installed";

#[test]
fn linuxcnc_reads_the_library_as_the_model_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut compared = 0;
    for machine in stems("machines", "mach") {
        let setup = Setup::refitted(&machine, "linuxcnc");
        // Without a machine's INI file the interpreter knows these axes.
        if setup.rig.machine.axes.iter().any(|axis| !AXES.contains(&axis.name.as_str())) {
            continue;
        }
        for program in stems("examples", "cls") {
            let cl = fs::read_to_string(super::machine::root().join(format!("examples/{program}.cls")));
            let Some(nc) = setup.post(&cl.expect("an example")) else { continue };
            if !is_read_alike(&format!("{machine} {program}"), &setup, &nc, folder.path()) {
                return println!("{NOT_INSTALLED}");
            }
            compared += 1;
        }
    }
    println!("{compared} programs of the library are read alike");
    assert!(compared > 150, "{compared}");
}

/// What the post does not print: arcs in three planes by centre and radius, a helix, steps, other feeds, stops, another hand.
const OTHER_HAND: &str = "(ANOTHER HAND)\ng17g21g40g49g80g90g94g91.1\nt1m06\ns1000m03\nG00X10Y0Z5A0\nG01Z0F100\n\
    G3 X0 Y10 I-10 J0\nG2 X10 Y0 R10\nG3 X10 Y0 Z-3 I-10 J0\nG18 G2 X20 Z-3 I5 K0\nG19 G3 Y10 Z-3 J5 K0\n\
    G17 G3 X10. Y0 R-12\nG91 G1 X1 Y1\nX-2 Z.5\nG0 A45\nG90 A-10 G1 X3\nG90.1 G2 X5 Y2 I4 J1.5\nG91.1\nM4 S500\nG95 G1 X0 F.1\n\
    G4 P1.5\nG94 M0\nM1\nF77 G1 Y3\nG53 G0 Z0\nM5\nM2\n";

#[test]
fn linuxcnc_reads_another_hand_as_the_model_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let setup = Setup::refitted("vmc4", "linuxcnc");
    let inch = OTHER_HAND.replace("g21", "g20");
    for (name, nc) in [("millimetres", OTHER_HAND), ("inches", &inch)] {
        if !is_read_alike(name, &setup, &nc.to_uppercase(), folder.path()) {
            return println!("{NOT_INSTALLED}");
        }
    }
}
