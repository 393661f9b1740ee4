//! Programs that machc did not write.

use super::machc::Run;
use super::mill;

fn verify(name: &str, program: &str, more: &[&str]) -> Run {
    let workshop = mill::workshop(name, "syntec");
    workshop.write("part.nc", program);
    workshop.run(&[&["verify", "mill.mach", "part.nc"], more].concat())
}

/// The mill's CL in another hand: lower case, no blanks, leading zeros, no numbers, incremental words, a skipped block.
const OTHER_HAND: &str = "%\no0001 (another hand)\ng17g21g40g49g80g90g94\ng54\nm9\nm5\ng53 g00 z500.\nt1m06\ns3000m03\n\
                          G00X0.Y0.\nG43Z50.H01\n/ (skipped) \nZ 2.\nG01 Z-1. F200\nG91 X10.\nG90\nX10.Y20.\nG00Z50.\n\
                          M09\nM05\nG53G00Z500.\nM30\n%\n";

#[test]
fn a_program_of_another_hand_agrees() {
    let Run { status, stdout, stderr } = verify("hand", OTHER_HAND, &["--against", "part.cls"]);
    assert_eq!((status, stderr.as_str()), (0, ""), "{stdout}");
    assert!(stdout.contains("against the CL: 0 differences"), "{stdout}");
    assert!(stdout.contains("6 points reached"), "{stdout}");
    assert!(stdout.contains("33 mm at feed in 9.9 s"), "{stdout}");
}

#[test]
fn what_differs_is_told_at_its_line() {
    for (name, from, to, code, line) in [
        ("differs-point", "G91 X10.", "G91 X11.", "E1210", 15),
        ("differs-kind", "G01 Z-1. F200", "G00 Z-1. F200", "E1211", 14),
        ("differs-feed", "F200", "F300", "E1212", 14),
        ("differs-speed", "s3000m03", "s300m03", "E1213", 14),
        ("differs-sense", "m03", "m04", "E1213", 14),
        ("differs-tool", "t1m06", "t2m06", "E1216", 8),
        ("differs-register", "H01", "H02", "E1215", 14),
        ("differs-offset", "g54", "g55", "E1215", 11),
        ("differs-units", "g21", "g20", "E1217", 8),
        ("differs-retract", "g53 g00 z500.\n", "\n", "E1217", 8),
    ] {
        let Run { status, stderr, .. } = verify(name, &OTHER_HAND.replace(from, to), &["--against", "part.cls"]);
        assert_eq!(status, 1, "{name}: {stderr}");
        assert!(stderr.contains(&format!("error[{code}]")), "{name}: {stderr}");
        assert!(stderr.contains(&format!("--> part.nc:{line}:1")), "{name}: {stderr}");
    }
}

#[test]
fn arcs_by_centre_and_by_radius_are_measured_and_written_back() {
    let quarter = |arc: &str| {
        format!("G17 G21 G90 G94\nT1 M6\nS1000 M3\nG0 X10. Y0. Z5.\nG43 H1 Z0.\nG1 F100. X10.\n{arc}\nM30\n")
    };
    let half_pi_ten = 15.708;
    for (name, arc) in [
        ("arc-centre", "G3 X0. Y10. I-10. J0."),
        ("arc-radius", "G3 X0. Y10. R10."),
        ("arc-clockwise", "G2 X20. Y10. I10. J0."),
    ] {
        let run = verify(name, &quarter(arc), &["--json", "--cl", "back.cls"]);
        assert_eq!(run.status, 0, "{name}: {}", run.stderr);
        let value: serde_json::Value = serde_json::from_str(run.stdout.trim()).expect("JSON");
        let feed_mm = value["tools"][0]["feed_mm"].as_f64().expect("a length");
        assert!((feed_mm - half_pi_ten).abs() < 0.001, "{name}: {feed_mm}");
    }
    let run = verify("arc-long", &quarter("G3 X0. Y10. R-10."), &["--json"]);
    let value: serde_json::Value = serde_json::from_str(run.stdout.trim()).expect("JSON");
    let feed_mm = value["tools"][0]["feed_mm"].as_f64().expect("a length");
    assert!((feed_mm - 3.0 * half_pi_ten).abs() < 0.002, "{feed_mm}");
    let off = verify("arc-off", &quarter("G3 X0. Y10. I-9. J0."), &[]);
    assert_eq!(off.status, 1);
    assert!(off.stderr.contains("the ends are off the arc by 1."), "{}", off.stderr);
}

#[test]
fn a_program_written_back_posts_to_the_same_motion() {
    let workshop = mill::workshop("way-back", "syntec");
    workshop.write("part.nc", OTHER_HAND);
    assert_eq!(workshop.run(&["verify", "mill.mach", "part.nc", "--cl", "back.cls"]).status, 0);
    let Run { status, stderr, .. } = workshop.run(&["post", "mill.mach", "back.cls", "-o", "again.nc"]);
    assert_eq!(status, 0, "{stderr}");
    let run = workshop.run(&["verify", "mill.mach", "again.nc", "--against", "back.cls"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert!(workshop.read("back.cls").contains("FEDRAT/MMPM,200\nGOTO/0.000000,0.000000,-1.000000"));
}

#[test]
fn what_is_suspicious_is_told() {
    let program = "G17\nT1 M6\nG0 X10. Y0. Z5.\nG1 X0.\nS100 M3\nG1 X5. F100.\nG0 Z-20.\nM30\n";
    let Run { status, stderr, .. } = verify("suspicious", program, &[]);
    assert_eq!(status, 0, "{stderr}");
    for (code, line) in [("W1201", 4), ("W1202", 4), ("W1203", 3), ("W1205", 7)] {
        assert!(stderr.contains(&format!("warning[{code}]")), "{code}: {stderr}");
        assert!(stderr.contains(&format!("--> part.nc:{line}:1")), "{code}: {stderr}");
    }
}

#[test]
fn what_the_control_does_not_declare_is_an_error_at_its_place() {
    for (name, block, message, column) in [
        ("unknown-code", "G90 M11 X1.", "the controller knows no word `M11`", 5),
        ("unknown-word", "G1 X1. Q5.", "the controller knows no word `Q5.`", 8),
        ("variable", "G1 X#100", "no word begins with this character", 5),
        ("open-comment", "G1 X1. (cut", "the comment is not closed in its line", 8),
        ("twice", "G1 X1. X2.", "`X2.` stands twice in one block", 8),
        ("two-codes", "G0 G1 X1.", "two codes that exclude each other", 1),
        ("pointless", "G1 X10", "has no decimal point", 4),
        ("centreless", "G17 G90 G2 X1. Y1.", "counts from a position that is not known", 1),
    ] {
        let Run { status, stderr, .. } = verify(name, &format!("G21 G90 G94\n{block}\n"), &[]);
        assert_eq!(status, 1, "{name}");
        assert!(stderr.contains("error[E1201]") && stderr.contains(message), "{name}: {stderr}");
        assert!(stderr.contains(&format!("--> part.nc:2:{column}\n")), "{name}: {stderr}");
    }
}

#[test]
fn a_program_has_a_name_and_begins_with_it() {
    for (name, head) in
        [("number", "O1234"), ("word", "Opart1_SETUP_3"), ("letters", "O_FACING"), ("blank", "O part 7")]
    {
        let program = OTHER_HAND.replace("o0001 (another hand)", head);
        let run = verify(&format!("named-{name}"), &program, &["--against", "part.cls"]);
        let is_one_name = name != "blank";
        assert_eq!((run.status == 0, run.stderr.is_empty()), (is_one_name, is_one_name), "{head}: {}", run.stderr);
    }
    for (name, slip) in [("slip", "OG0X5"), ("other", "O2")] {
        let program = OTHER_HAND.replace("G91 X10.", &format!("{slip}\nG91 X10."));
        let run = verify(&format!("named-{name}"), &program, &[]);
        assert_eq!(run.status, 1, "{slip}");
        assert!(run.stderr.contains("a program that begins within another is not followed"), "{slip}: {}", run.stderr);
    }
}

#[test]
fn what_stands_behind_the_end_is_told_and_not_run() {
    for (name, behind, line) in [
        ("nothing", "", None),
        ("mark", "%\n\n(made by hand)\n", None),
        ("block", "G0 X400.\n%\n", Some(23)),
        ("unknown", "%\nnotes Q #1 (\n", Some(24)),
        ("program", "%\nO0002\nG90 G0 X1000.\nM30\n%\n", Some(24)),
    ] {
        let program = OTHER_HAND.strip_suffix("%\n").expect("the tape's mark").to_owned() + behind;
        let Run { status, stdout, stderr } = verify(&format!("behind-{name}"), &program, &["--against", "part.cls"]);
        assert_eq!(status, 0, "{name}: {stderr}");
        assert!(stdout.contains("0.000 .. 10.000 mm"), "{name}: {stdout}");
        assert_eq!(stderr.contains("warning[W1207]: text behind the end of the program"), line.is_some(), "{stderr}");
        let place = line.map(|line| format!("--> part.nc:{line}:1"));
        assert!(place.is_none_or(|place| stderr.contains(&place)), "{name}: {stderr}");
    }
}

/// A difference of cuts is told again only after a cut without it: rapid motions in between show nothing.
#[test]
fn a_difference_is_told_again_when_it_was_right_in_between() {
    let cl = "LOAD/TOOL,1\nSPINDL/RPM,3000,CLW\nFEDRAT/MMPM,200\n".to_owned()
        + &(0..4).map(|x| format!("RAPID\nGOTO/{x},0,5\nGOTO/{x},0,-1\n")).collect::<String>();
    let hole = |x: u32, feed: u32| format!("G0 X{x}. Y0. Z5.\nG1 Z-1. F{feed}.\n");
    let program = |feeds: [u32; 4]| {
        let holes: String = (0..).zip(feeds).map(|(x, feed)| hole(x, feed)).collect();
        let head =
            "G17 G21 G40 G49 G80 G90 G94\nG54\nM9\nM5\nG53 G0 Z500.\nT1 M6\nG54\nS3000 M3\nG0 X0. Y0.\nG43 H1 Z5.\n";
        format!("{head}{holes}M9\nM5\nG53 G0 Z500.\nM30\n")
    };
    for (name, feeds, told) in [
        ("right", [200; 4], 0),
        ("wrong", [300; 4], 1),
        ("wrong-again", [300, 300, 200, 300], 2),
        ("late", [200, 200, 300, 400], 1),
    ] {
        let workshop = mill::workshop(&format!("again-{name}"), "syntec");
        workshop.write("part.nc", &program(feeds));
        workshop.write("holes.cls", &cl);
        let run = workshop.run(&["verify", "mill.mach", "part.nc", "--against", "holes.cls"]);
        assert_eq!(run.stderr.matches("error[E1212]").count(), told, "{name}: {}", run.stderr);
        assert_eq!(run.stderr.matches("error[").count(), told, "{name}: {}", run.stderr);
    }
}
