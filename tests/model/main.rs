//! What a machine file says and what the model then holds.

use mach_runtime::machine::{Motion, Preference, Strictness, Travel, Written};
mod mutations;

use mach_command::render::plain;
use machc::compile::compile;
use machc::model::machine::Model;
use machc::sources::Sources;
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Files by name.
struct Texts(BTreeMap<&'static str, String>);

impl Sources for Texts {
    fn read(&self, path: &str) -> Result<String, String> {
        self.0.get(path).cloned().ok_or_else(|| "no such file".to_owned())
    }
}

fn model(files: &[(&'static str, &str)]) -> Model {
    let texts = Texts(files.iter().map(|(name, text)| (*name, (*text).to_owned())).collect());
    match compile(files[0].0, &texts) {
        Ok(compiled) => compiled.model,
        Err(diagnostics) => panic!("{}", plain(&diagnostics)),
    }
}

const TRUNNION: &str = r#"
machine trunnion "A/C trunnion" {
    let centre = -20 mm
    chain w C A b X' Y Z t
    linear X along +x  travel -355 .. 355  rapid 36 m/min
    linear Y along +y  travel -1 .. 2 in
    linear Z along (0, 0, 2)
    rotary A about +x  through (0, 0, centre)  travel -30 .. 120 deg  rapid 10 rpm
    rotary C about (cos(90 deg), 0, 1)  through (0, 0, centre)  turns unlimited
    tool along +z at (0, 0, 5 * 2) length 1 in
    branch {
        start least |C|, positive A
        reposition warn
    }
}
"#;

#[test]
fn every_quantity_is_in_its_base_unit() {
    let model = model(&[("m.mach", TRUNNION)]);
    let [x, y, z, a, c] = &model.axes[..] else { panic!("five axes") };
    assert_eq!((x.motion, x.travel), (Motion::Linear, Travel { lower: -355.0, upper: 355.0 }));
    assert_eq!(x.rapid_per_min, Some(36_000.0));
    assert_eq!(y.travel, Travel { lower: -25.4, upper: 50.8 }, "a bare bound takes the unit of the other");
    assert_eq!((z.direction, z.travel), (Vector3::z(), Travel::UNLIMITED));
    assert_eq!((a.motion, a.travel), (Motion::Rotary, Travel { lower: -30.0, upper: 120.0 }));
    assert_eq!((a.point_mm, a.rapid_per_min), (Vector3::new(0.0, 0.0, -20.0), Some(3600.0)));
    assert_eq!((c.direction, c.travel), (Vector3::z(), Travel::UNLIMITED));
    assert_eq!((model.tool.gauge_mm, model.tool.length_mm), (Vector3::new(0.0, 0.0, 10.0), 25.4));
    assert_eq!(model.parameters, [("centre".to_owned(), "-20 mm".to_owned())]);
}

#[test]
fn the_chain_keeps_its_order_its_bed_and_its_primes() {
    let model = model(&[("m.mach", TRUNNION)]);
    let names: Vec<&str> = model.chain.iter().map(|joint| model.axes[joint.axis].name.as_str()).collect();
    assert_eq!(names, ["C", "A", "X", "Y", "Z"]);
    assert_eq!(model.chain.iter().map(|joint| joint.primed).collect::<Vec<_>>(), [false, false, true, false, false]);
    assert_eq!(model.bed, 2);
}

#[test]
fn what_is_not_said_has_its_default() {
    let model = model(&[("m.mach", TRUNNION)]);
    assert_eq!(model.zero_mm, Vector3::zeros());
    assert!((model.axis_tolerance_rad.to_degrees() - 0.0001).abs() < 1e-12);
    assert_eq!(model.chord_tolerance_mm, 0.01);
    assert_eq!(model.unknown_records, Strictness::Error);
    assert_eq!(model.branch.start, [Preference::Least(4), Preference::Positive(3)]);
    assert_eq!(model.branch.then, [Preference::Nearest]);
    assert_eq!(model.branch.reposition, Strictness::Warn);
    assert!(model.axes.iter().all(|axis| axis.written == Written::Unwound));
    assert!(model.dialect.is_none());
}

#[test]
fn a_machine_is_its_family_and_what_it_says_itself() {
    let own = r#"
use "families/trunnion.mach"
machine mill3 like trunnion "Mill 3" {
    let lift   = 0.5 mm
    let centre = -20 mm - lift
    linear X along +x travel -500 .. 500
    branch { start negative A }
}
"#;
    let model = model(&[("mill3.mach", own), ("families/trunnion.mach", TRUNNION)]);
    assert_eq!((model.name.as_str(), model.title.as_deref()), ("mill3", Some("Mill 3")));
    let names: Vec<&str> = model.axes.iter().map(|axis| axis.name.as_str()).collect();
    assert_eq!(names, ["X", "Y", "Z", "A", "C"], "a statement keeps the place of the one it replaces");
    assert_eq!(model.axes[0].travel.upper, 500.0);
    assert_eq!(model.axes[0].rapid_per_min, None, "a statement replaces the whole of the other");
    assert_eq!(model.axes[3].point_mm.z, -20.5);
    assert_eq!(model.branch.start, [Preference::Negative(3)]);
    assert_eq!(model.branch.reposition, Strictness::Warn, "the rest of the block is the family's");
}

const CONTROLLERS: &str = include_str!("controllers.mach");

#[test]
fn a_controller_is_its_family_and_what_the_machine_changes() {
    let machine = TRUNNION.replace("    branch {", "    controller fine { word Z angle }\n    branch {");
    let text = format!("use \"c.mach\"\n{machine}");
    let model = model(&[("m.mach", &text), ("c.mach", CONTROLLERS)]);
    assert_eq!(model.axes[4].written, Written::Wrapped { from_deg: -180.0 });
    assert_eq!(model.axes[3].written, Written::Unwound);
    let dialect = model.dialect.expect("a controller was named");
    let decimals: Vec<u8> = dialect.axes.iter().map(|word| word.picture.decimals).collect();
    assert_eq!((dialect.name.as_str(), &decimals[..]), ("fine", &[3, 3, 4, 4, 4][..]));
}

#[test]
fn no_turn_is_taken_off_an_axis_with_limits() {
    let wrapped = |own: &str, travel_c: &str| {
        let machine = TRUNNION.replace("    branch {", &format!("    controller plain {{ {own} }}\n    branch {{"));
        let text = format!("use \"c.mach\"\n{}", machine.replace("turns unlimited", travel_c));
        let model = model(&[("m.mach", &text), ("c.mach", CONTROLLERS)]);
        [3, 4].map(|axis| model.axes[axis].written != Written::Unwound)
    };
    assert_eq!(wrapped("write A -180 .. 180", "turns unlimited"), [false, true]);
    assert_eq!(wrapped("", "travel 0 .. 359.9999"), [false, false], "359.9999 is printed as 360, not as 0");
    assert_eq!(wrapped("write C unwound", "travel -200 .. 200"), [false, false]);
    assert_eq!(wrapped("write C -200 .. 160", "travel -200 .. 159"), [false, false]);
}

#[test]
fn a_file_used_twice_is_read_once() {
    let text = format!("use \"lib/a.mach\"\nuse \"./lib/../lib/b.mach\"\n{TRUNNION}");
    let files = [("m.mach", text.as_str()), ("lib/a.mach", "use \"b.mach\""), ("lib/b.mach", CONTROLLERS)];
    assert_eq!(model(&files).axes.len(), 5);
}

#[test]
fn machines_of_three_and_four_axes_are_machines() {
    let linear = "linear X along +x linear Y along +y linear Z along +z tool along +z";
    assert_eq!(model(&[("m.mach", &format!("machine m {{ chain w Y' X' b Z t {linear} }}"))]).bed, 2);
    let four = format!("machine m {{ chain w A b X Y Z t {linear} rotary A about +x }}");
    assert_eq!(model(&[("m.mach", &four)]).chain.len(), 4);
}

#[test]
fn an_entry_that_is_not_there_is_a_diagnostic() {
    let diagnostics = compile("m.mach", &Texts(BTreeMap::new())).expect_err("there is no file");
    assert_eq!(plain(&diagnostics).trim_end(), "error[E0201]: cannot read `m.mach`: no such file");
}

#[test]
fn parameters_may_come_in_any_order_and_number() {
    let chained: String = (0..5000).map(|i| format!("let p{i} = p{} + 1 mm\n", i + 1)).collect();
    let text = TRUNNION.replace("let centre = -20 mm", &format!("{chained} let p5000 = 1 mm let centre = p0"));
    assert_eq!(model(&[("m.mach", &text)]).axes[3].point_mm.z, 5001.0);
}
