//! Denavit–Hartenberg tables: the same machine as by directions, and the product of its links.

use mach_runtime::kinematics::{Kinematics, LANES, PoseBlock};
use mach_runtime::machine::{Motion, ToolGeometry};
use mach_runtime::vector::{angle_rad, norm, sub};
use machc::compile::{Compiled, compile};
use machc::plan::Interpreter;
use machc::sources::Sources;
use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};
use proptest::prelude::*;

#[path = "common/machine.rs"]
mod machine;
#[path = "common/program.rs"]
mod program;

/// One file.
struct Text<'a>(&'a str);

impl Sources for Text<'_> {
    fn read(&self, _: &str) -> Result<String, String> {
        Ok(self.0.to_owned())
    }
}

#[test]
fn a_machine_told_by_a_table_posts_the_same_program() {
    let [table, usual] =
        ["dmu50ev_dh", "dmu50ev"].map(|name| machine::compiled(&format!("machines/{name}.mach"), &machine::Files));
    for (of_table, of_usual) in table.model.axes.iter().zip(&usual.model.axes) {
        assert!((of_table.direction - of_usual.direction).norm() < 1e-15, "{}", of_usual.name);
    }
    let [table, usual] = [table, usual].map(|compiled| program::posted(&compiled, "examples/hemisphere.cls"));
    assert!(usual.certificate.is_some(), "{:?}", usual.diagnostics);
    assert_eq!(table.certificate.map(|certificate| certificate.blocks), usual.certificate.map(|c| c.blocks));
    let [table, usual] = [table.nc, usual.nc].map(|nc| String::from_utf8(nc).expect("text"));
    assert_eq!(table.replace("dmu50ev_dh", "dmu50ev"), usual);
}

/// The trunnion, a fork head whose linear axes are primed, and a head and a table; without directions.
const MACHINES: [(&str, &str, &str); 3] = [
    (
        "dh {
            link C: 90 deg, 0, 0, -20, 90 deg
            link A: 0, 0, 0, 0, 0
            bed
            link X: 90 deg, 0, 0, 0, 90 deg
            link Y: 90 deg, 0, 0, 0, 90 deg
            link Z: 0, 0, 0, 20, 0
        }
        linear X linear Y linear Z rotary A rotary C",
        "chain w C A b X Y Z t
        linear X along +x linear Y along +y linear Z along +z
        rotary A about +x through (0, 0, -20) rotary C about +z through (0, 0, -20)
        tool along +z",
        "table/table",
    ),
    (
        "dh {
            link     90 deg, 0, 0, 0, 90 deg
            link X': 90 deg, 0, 0, 0, 90 deg
            bed
            link Y': 90 deg, 0, 0, 0, 90 deg
            link Z:  0, 0, 0, 300, 0
            link C:  90 deg, 10, 0, 0, 90 deg
            link A:  -90 deg, 0, 0, 0, 0
            link     0, 0, 0, 0, -90 deg
        }
        linear X linear Y linear Z rotary A rotary C
        tool along +z at (0, 0, 250)",
        "chain w X' b Y' Z C A t
        linear X along +x linear Y along +y linear Z along +z
        rotary A about +x through (0, 10, 300) rotary C about +z through (0, 0, 300)
        tool along +z at (0, 0, 250)",
        "head/head",
    ),
    (
        "dh {
            link C: 0, 0, 0, 0, 0
            bed
            link 90 deg, 0, 0, 0, 90 deg
            link X: 90 deg, 0, 0, 0, 90 deg
            link Y: 90 deg, 0, 0, 0, 90 deg
            link Z: 0, 0, 0, 200, -30 deg
            link B: 0, 0, 0, 0, 30 deg
        }
        linear X linear Y linear Z rotary B rotary C",
        "chain w C b X Y Z B t
        linear X along +x linear Y along +y linear Z along +z
        rotary B about (0, sin(30 deg), cos(30 deg)) through (0, 0, 200) rotary C about +z
        tool along +z at (0, 0, 200)",
        "head/table",
    ),
];

#[test]
fn a_table_and_directions_give_the_same_forward_chain() {
    for (table, directions, family) in MACHINES {
        let compiled = [table, directions].map(|text| {
            let text = format!("machine m {{ {text} }}");
            machine::compiled("m.mach", &Text(&text))
        });
        assert!(machc::model::class::class(&compiled[0].model).contains(family));
        let mut poses = compiled.iter().map(|compiled| forward(compiled, 120.0));
        let (a, b) = (poses.next().expect("two"), poses.next().expect("two"));
        for lane in 0..LANES {
            assert!(norm(sub(a.tip(lane), b.tip(lane))) < 1e-10, "{family}: {:?} {:?}", a.tip(lane), b.tip(lane));
            assert!(angle_rad(a.axis(lane), b.axis(lane)) < 1e-12, "{family}");
        }
    }
}

/// Where axes go in a lane: millimetres or degrees.
fn joint(axis: usize, lane: usize) -> f64 {
    ((axis + 2) * (lane + 3) * 37 % 331) as f64 - 165.0
}

fn forward(compiled: &Compiled, tool_length_mm: f64) -> PoseBlock {
    let joints = (0..compiled.model.axes.len()).map(|axis| std::array::from_fn(|lane| joint(axis, lane))).collect();
    let mut poses = PoseBlock::ZERO;
    Interpreter::new(&compiled.plan).forward(&joints, ToolGeometry::of_length(tool_length_mm), &mut poses);
    poses
}

/// One link: θ and α in degrees, a, b and l in millimetres.
fn link() -> impl Strategy<Value = [f64; 5]> {
    let angle = || prop_oneof![(-180.0..180.0f64), (-1..=2i32).prop_map(|quarters| f64::from(quarters) * 90.0)];
    let length = || prop_oneof![Just(0.0), -200.0..200.0f64];
    (angle(), length(), length(), length(), angle()).prop_map(|(theta, a, b, l, alpha)| [theta, a, b, l, alpha])
}

const ORDER: [&str; 6] = ["C", "A'", "X", "Y'", "", "Z"];

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_chain_is_the_product_of_its_links(links in prop::collection::vec(link(), 6), order in Just(ORDER.to_vec()).prop_shuffle()) {
        let row = |(name, [theta, a, b, l, alpha]): (&&str, &[f64; 5])| {
            let axis = if name.is_empty() { String::new() } else { format!("{name}:") };
            format!("link {axis} {theta}, {a}, {b}, {l}, {alpha}\n")
        };
        let rows: String = order.iter().zip(&links).map(row).collect();
        let text = format!("machine m {{ dh {{ bed {rows} }} linear X linear Y linear Z rotary A rotary C }}");
        let compiled = compile("m.mach", &Text(&text));
        // Random lines do not always make a machine.
        prop_assume!(compiled.is_ok());
        let compiled = compiled.expect("just looked");
        let poses = forward(&compiled, 0.0);
        for lane in 0..LANES {
            let frame = order.iter().zip(&links).fold(Isometry3::identity(), |frame, (name, link)| {
                frame * transform(&compiled, name, *link, lane)
            });
            let tip: [f64; 3] = (frame * Point3::origin()).coords.into();
            let axis: [f64; 3] = (frame * Vector3::z()).into();
            prop_assert!(norm(sub(poses.tip(lane), tip)) < 1e-9, "{text} {:?} {tip:?}", poses.tip(lane));
            prop_assert!(angle_rad(poses.axis(lane), axis) < 1e-12, "{text}");
        }
    }
}

/// `Rz(θ) Trans(a, b, l) Rx(α)` with the axis' value in it.
fn transform(compiled: &Compiled, name: &str, [theta, a, b, l, alpha]: [f64; 5], lane: usize) -> Isometry3<f64> {
    let letter = name.trim_end_matches('\'');
    let index = compiled.model.axes.iter().position(|axis| axis.name == letter);
    let value = index.map_or(0.0, |index| joint(index, lane)) * if name.ends_with('\'') { -1.0 } else { 1.0 };
    let is_rotary = index.is_some_and(|index| compiled.model.axes[index].motion == Motion::Rotary);
    let (theta, l) = if is_rotary { (theta + value, l) } else { (theta, l + value) };
    let turn = |axis, angle: f64| UnitQuaternion::from_axis_angle(&axis, angle.to_radians());
    turn(Vector3::z_axis(), theta) * Translation3::new(a, b, l) * turn(Vector3::x_axis(), alpha)
}
