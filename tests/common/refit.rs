//! Machines of the library with other controls than their own.

use crate::machine::Files;
use machc::sources::Sources;

/// The tool lies along X, and so does its length.
const ALONG_X: &str = r#"
    on approach {
        "G0 {rotary}"
        "G0 G19 G43 H{register:00} {X} {Y} {U} {V}"
        "G0 {Z} {W}"
    }
    on approach feed {
        "G1 {rotary} {feed}"
        "G1 G19 G43 H{register:00} {X} {Y} {U} {V} {feed}"
        "G1 {Z} {W}"
    }
"#;

/// The same in Klartext, where the tool's axis is said with the tool.
const KLARTEXT_ALONG_X: &str = r#"
    on tool {
        "M9"
        "M5"
        "L {retract} R0 FMAX M91"
        "TOOL CALL {tool} X"
    }
    on spindle clockwise {
        "TOOL CALL X S{speed}"
        "M3"
    }
    on spindle counterclockwise {
        "TOOL CALL X S{speed}"
        "M4"
    }
"#;

/// The machine's file does not count the travel as the control does.
const FROM_THE_TOP: &str = " retract \"Z0.\" ";

/// What machines say to a control other than the one in their file.
const OWN: [(&str, &[&str]); 7] = [
    ("dmu70_evline", &[FROM_THE_TOP]),
    ("integrex300", &[FROM_THE_TOP]),
    ("slant_millturn", &[ALONG_X]),
    ("tmv710a", &[FROM_THE_TOP]),
    ("vmc3_inch", &[" units inch "]),
    ("vstar_angle_head", &[FROM_THE_TOP, ALONG_X]),
    ("xzc_circumference", &[ALONG_X]),
];

/// A machine of the library with this control.
pub(crate) struct Refit<'a> {
    pub(crate) machine: &'a str,
    pub(crate) control: &'a str,
}

impl Refit<'_> {
    /// The name of its file, which is not there.
    pub(crate) fn path(&self) -> String {
        format!("machines/{}_{}.mach", self.machine, self.control)
    }

    /// The text of its file.
    pub(crate) fn text(&self) -> String {
        let Self { machine, control } = self;
        let own = OWN.iter().find(|(name, _)| name == machine).map(|(_, own)| own.concat()).unwrap_or_default();
        let own = match *control {
            "heidenhain" => own.replace(ALONG_X, KLARTEXT_ALONG_X).replace("Z0.", "Z+0"),
            _ => own,
        };
        format!(
            "use \"{machine}.mach\"\nuse \"controllers/{control}.mach\"\n\n\
             machine {machine}_{control} like {machine} {{\n    controller {control} {{{own}}}\n}}\n"
        )
    }
}

impl Sources for Refit<'_> {
    fn read(&self, path: &str) -> Result<String, String> {
        if path == self.path() { Ok(self.text()) } else { Files.read(path) }
    }
}
