//! Klartext programs that machc did not write.

use super::machc::{Run, Workshop};
use super::mill;

fn workshop(name: &str, program: &str) -> Workshop {
    let workshop = mill::workshop(name, "heidenhain");
    workshop.write("part.h", program);
    workshop
}

fn verify(name: &str, program: &str, more: &[&str]) -> Run {
    workshop(name, program).run(&[&["verify", "mill.mach", "part.h"], more].concat())
}

/// The mill's CL in another hand: small letters, a blank form, remarks, all in TOOL CALL, steps, a feed that stays.
const OTHER_HAND: &str = "0  BEGIN PGM 2D_part-7 MM\n1  BLK FORM 0.1 Z X-10 Y-10 Z-20\n2  BLK FORM 0.2 X+100 Y+100 Z+0\n\
                          3  ; by hand\n4  CYCL DEF 247 DATUM SETTING ~\n   Q339=+1 ;DATUM NUMBER\n5  M126\n6  M137\n\
                          7  L Z+500 R0 FMAX M91\n8  TOOL CALL 1 Z S3000 F200\n9  L R0 FMAX M3\n10 l x+0 y+0 r0 fmax\n\
                          11 L Z+50 R0 FMAX\n12 L IZ-48 FMAX ; down\n/13 ; left out\n14 L Z-1 F200\n15 L IX+10\n16 L Y+20.000\n\
                          17 L Z+50 FMAX\n18 M5\n19 L Z+500 R0 FMAX M91\n20 M30\n21 END PGM 2D_part-7 MM\n";

#[test]
fn a_program_of_another_hand_agrees() {
    let Run { status, stdout, stderr } = verify("klartext-hand", OTHER_HAND, &["--against", "part.cls"]);
    assert_eq!((status, stderr.as_str()), (0, ""), "{stdout}");
    assert!(stdout.contains("against the CL: 0 differences"), "{stdout}");
    assert!(stdout.contains("33 mm at feed in 9.9 s"), "{stdout}");
}

#[test]
fn what_differs_is_told() {
    for (name, from, to, code) in [
        ("point", "L IX+10", "L IX+11", "E1210"),
        ("kind", "L Z-1 F200", "L Z-1 FMAX", "E1211"),
        ("feed", "L Z-1 F200", "L Z-1 F300", "E1212"),
        ("speed", "S3000", "S300", "E1213"),
        ("sense", "FMAX M3", "FMAX M4", "E1213"),
        ("tool", "TOOL CALL 1", "TOOL CALL 2", "E1216"),
        ("preset", "Q339=+1", "Q339=+2", "E1215"),
        ("side", "l x+0 y+0 r0", "l x+0 y+0 rl", "E1218"),
        ("turns", "5  M126", "5  M127", "E1218"),
        ("way out", "FMAX M91\n8", "FMAX\n8", "E1217"),
        ("units", "2D_part-7 MM\n1", "2D_part-7 INCH\n1", "E1210"),
    ] {
        let program = OTHER_HAND.replace(from, to);
        assert_ne!(program, OTHER_HAND, "{name}");
        let Run { status, stderr, .. } = verify(&format!("klartext-{name}"), &program, &["--against", "part.cls"]);
        assert_eq!(status, 1, "{name}: {stderr}");
        assert!(stderr.contains(&format!("error[{code}]")), "{name}: {stderr}");
    }
}

#[test]
fn what_the_description_leaves_out_is_told() {
    for (name, block, words) in [
        ("polar", "LP PR+10 PA+45 R0", "no word `LP`"),
        ("rounding", "RND R5", "no word `RND`"),
        ("tcpm", "M128", "no word `M128`"),
        ("plane", "PLANE RESET STAY", "no word `PLANE`"),
        ("cycle", "CYCL DEF 200 DRILLING", "no word `CYCL`"),
        ("name", "TOOL CALL \"D10\" Z", "no word `\"D10\"`"),
        ("delta", "TOOL CALL 1 Z S3000 DL+0.2", "no word `DL+0.2`"),
        ("parameter", "L X+Q1 R0 FMAX", "no word `X+Q1`"),
        ("comma", "L X+1,5 R0 FMAX", "no word `X+1,5`"),
        ("subprogram", "CALL LBL 1", "no word `CALL`"),
        ("automatic", "L X+5 R0 FAUTO", "no word `FAUTO`"),
        ("order", "R0 L X+5", "no word `L`"),
        ("two", "L X+5 L Y+5", "no word `L`"),
        ("bare", "X+5 Y+5 R0", "no word `X+5`"),
        ("together", "LX+5 R0", "no word `LX+5`"),
        ("rider", "M3 X+5", "no code says how the axis moves"),
        ("sides", "L X+5 R0 RL", "two codes that exclude each other"),
        ("twice", "L X+5 IX+5 R0", "stands twice"),
        ("pole", "C X+5 Y+5 DR+", "neither a centre nor a radius"),
        ("sense", "C X+5 Y+5", "no word `C`"),
        ("nested", "BEGIN PGM INNER MM", "a program that begins within another"),
    ] {
        let program = OTHER_HAND.replace("15 L IX+10\n", &format!("15 {block}\n"));
        let Run { status, stderr, .. } = verify(&format!("klartext-left-out-{name}"), &program, &[]);
        assert_eq!(status, 1, "{name}: {stderr}");
        assert!(stderr.contains("error[E1201]") && stderr.contains(words), "{name}: {stderr}");
        assert!(stderr.contains("part.h:17:"), "{name}: {stderr}");
    }
}

#[test]
fn a_line_that_goes_on_needs_the_next_one() {
    let dropped = OTHER_HAND.replace("   Q339=+1 ;DATUM NUMBER\n", "");
    let Run { status, stderr, .. } = verify("klartext-dropped", &dropped, &[]);
    assert_eq!(status, 1);
    assert!(stderr.contains("no word `CYCL`") && stderr.contains("part.h:6:"), "{stderr}");
    let unfinished = "0 BEGIN PGM P MM\n1 CYCL DEF 247 DATUM SETTING ~\n";
    let Run { status, stderr, .. } = verify("klartext-unfinished", unfinished, &[]);
    assert_eq!(status, 1);
    assert!(stderr.contains("the program ends in a block that should go on"), "{stderr}");
}

/// The motion of these blocks behind a start at X10 Y0 Z0, as CL.
fn as_cl(name: &str, unit: &str, blocks: &str) -> String {
    let program = format!(
        "0 BEGIN PGM P {unit}\n1 M137\n2 TOOL CALL 1 Z S1000\n3 L X+10 Y+0 Z+0 R0 FMAX M3\n{blocks}\n9 END PGM P {unit}\n"
    );
    let workshop = workshop(name, &program);
    let Run { status, stdout, stderr } = workshop.run(&["verify", "mill.mach", "part.h", "--cl", "out.cls"]);
    assert_eq!(status, 0, "{stderr}{stdout}");
    format!("{stdout}{}", workshop.read("out.cls"))
}

#[test]
fn arcs_are_measured_and_written_back() {
    for (name, blocks) in [
        ("centre", "4 CC X+0 Y+0\n5 C X+0 Y+10 DR+ R0 F100"),
        ("steps", "4 CC IX-10 IY+0\n5 C IX-10 IY+10 DR+ R0 F100"),
        ("radius", "4 CR X+0 Y+10 R+10 DR+ R0 F100"),
        ("pole stays", "4 CC X+0 Y+0\n5 L X+10 R0 F100\n6 C X+0 Y+10 DR+"),
    ] {
        let told = as_cl(&format!("klartext-arc-{name}"), "MM", blocks);
        assert!(told.contains("16 mm at feed"), "{name}: {told}");
    }
    for (name, blocks, length) in [
        ("clockwise", "4 CC X+0 Y+0\n5 C X+0 Y+10 DR- R0 F100", "47 mm at feed"),
        ("longer", "4 CR X+0 Y+10 R-10 DR- R0 F100", "47 mm at feed"),
        ("full", "4 CC X+0 Y+0\n5 C X+10 Y+0 DR+ R0 F100", "63 mm at feed"),
    ] {
        let told = as_cl(&format!("klartext-arc-{name}"), "MM", blocks);
        assert!(told.contains(length), "{name}: {told}");
    }
}

#[test]
fn inches_and_tenths_of_them_a_minute() {
    let told = as_cl("klartext-inch", "INCH", "4 L X+11 R0 F100");
    // 25.4 mm at 10 inches a minute.
    assert!(told.contains("25 mm at feed in 6.0 s"), "{told}");
}

#[test]
fn a_dwell_a_stop_and_a_way_out_along_the_tool() {
    let blocks =
        "4 CYCL DEF 9.0 DWELL TIME\n5 CYCL DEF 9.1 DWELL 1.5\n6 STOP\n7 L M140 MB MAX\n8 L Z+5 X+0 Y+0 R0 FMAX";
    let told = as_cl("klartext-events", "MM", blocks);
    assert!(told.contains("DELAY/1.5") && told.contains("STOP"), "{told}");
    assert!(told.contains("GOTO/0.000000,0.000000,5.000000"), "{told}");
}
