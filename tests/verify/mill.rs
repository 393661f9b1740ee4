//! A mill with three axes whose travel counts from the program zero, and what it is to cut.

use super::machc::Workshop;

/// What the programs of all hands do.
const CL: &str = "TOOL PATH/CUT,TOOL,MILL\nLOAD/TOOL,1\nSPINDL/RPM,3000,CLW\nRAPID\nGOTO/0,0,50\nRAPID\nGOTO/0,0,2\n\
                  FEDRAT/MMPM,200\nGOTO/0,0,-1\nGOTO/10,0,-1\nGOTO/10,20,-1\nRAPID\nGOTO/10,20,50\nEND-OF-PATH\n";

/// A folder with the mill and this control, and the CL.
pub(crate) fn workshop(name: &str, control: &str) -> Workshop {
    let workshop = Workshop::new(name);
    workshop.write("mill.mach", &mill(control));
    workshop.write("part.cls", CL);
    workshop
}

fn mill(control: &str) -> String {
    format!(
        r#"
use "controllers/{control}.mach"
machine mill {{
    chain w b X Y Z t
    linear X along +x  travel -500 .. 500
    linear Y along +y  travel -500 .. 500
    linear Z along +z  travel -500 .. 500
    tool along +z
    controller {control} {{ }}
}}
"#
    )
}
