//! What `machc show` says of a machine: the textbook's equations are found without any case for a machine.

use machc::emit::data_sheet::data_sheet;

#[path = "common/machine.rs"]
mod machine;

fn sheet(name: &str) -> String {
    let compiled = machine::compiled(&format!("machines/{name}.mach"), &machine::Files);
    data_sheet(&compiled.model, &compiled.plan, &compiled.proof)
}

/// The lines of a section, without their indentation.
fn section<'s>(sheet: &'s str, title: &str) -> Vec<&'s str> {
    let lines = sheet.lines().skip_while(|line| *line != title).skip(1);
    lines.take_while(|line| !line.is_empty()).map(str::trim).collect()
}

#[test]
fn an_orthogonal_trunnion_has_the_equations_of_the_textbook() {
    let sheet = sheet("tmv710a");
    assert!(sheet.starts_with("tmv710a  Tongtai TMV-710A, A/C trunnion\n\nchain   w C A b X Y Z t\n"), "{sheet}");
    assert!(sheet.contains("family  5 axes, table/table, orthogonal\n"), "{sheet}");
    let forward = section(&sheet, "forward transformation");
    assert_eq!(forward[..3], ["i = sin A sin C", "j = -sin A cos C", "k = cos A"]);
    let inverse = section(&sheet, "inverse transformation");
    assert_eq!(
        inverse,
        [
            "t1 = atan2(√(i² + j²), k)",
            "solution 1",
            "A = t1",
            "C = atan2(i, -j)",
            "solution 2",
            "A = -t1",
            "C = atan2(-i, j)",
            "for either solution",
            "t1 = z + 20",
            "t2 = y cos C - x sin C",
            "X = x cos C + y sin C",
            "Y = t2 cos A + t1 sin A",
            "Z = L + t1 cos A - t2 sin A - 20",
        ]
    );
    assert_eq!(
        section(&sheet, "reach"),
        ["every direction", "singular at (0, 0, 1): C is free", "singular at (0, 0, -1): C is free"]
    );
}

#[test]
fn a_proof_without_rounding_is_within_nothing() {
    assert_eq!(section(&sheet("vmc3"), "proof")[1], "tip within 0 mm, tool axis within 0 rad");
}

#[test]
fn a_nutating_table_tells_its_cone() {
    let sheet = sheet("dmu50ev");
    assert!(sheet.contains("family  5 axes, table/table, nutating at 45 deg\n"), "{sheet}");
    assert_eq!(
        section(&sheet, "reach"),
        ["directions from 0 to 90 deg from (0, 0, 1)", "singular at (0, 0, 1): C is free"]
    );
}

#[test]
fn machines_with_fewer_rotaries_say_what_they_reach() {
    assert_eq!(section(&sheet("vmc3"), "reach"), ["tool axis (0, 0, 1) only"]);
    let four = sheet("vmc4");
    assert_eq!(section(&four, "reach"), ["directions at 90 deg from (1, 0, 0)"]);
    assert_eq!(section(&four, "inverse transformation")[0], "A = atan2(-j, k)");
}

#[test]
fn a_turning_centre_without_y_is_polar() {
    let sheet = sheet("xzc_face");
    assert!(sheet.contains("family  3 axes, mill-turn, polar X Z C\n"), "{sheet}");
    assert_eq!(
        section(&sheet, "inverse transformation"),
        [
            "solution 1",
            "C = atan2(y, x)",
            "solution 2",
            "C = atan2(-y, -x)",
            "for either solution",
            "X = x cos C + y sin C",
            "Z = L + z",
        ]
    );
    assert_eq!(section(&sheet, "reach"), ["tool axis (0, 0, 1) only", "singular at the axis of C: C is free"]);
}

#[test]
fn surplus_axes_are_told_and_not_solved_for() {
    let sheet = sheet("integrex300");
    assert!(sheet.contains("family  6 axes, head/table, orthogonal, with A preferred\n"), "{sheet}");
    assert!(section(&sheet, "axes").iter().any(|line| line.ends_with("unlimited, preferred at 0 deg")), "{sheet}");
    let inverse = section(&sheet, "inverse transformation");
    assert!(inverse[0] == "for any A" && inverse.iter().all(|line| !line.starts_with("A = ")), "{sheet}");
    assert_eq!(section(&sheet, "reach")[0], "with A at 0 deg:");
    let quill = self::sheet("bridge6_quill");
    assert!(quill.contains("family  6 axes, head/head, orthogonal, with W preferred\n"), "{quill}");
    assert!(section(&quill, "inverse transformation").iter().any(|line| line.contains(" - W")), "{quill}");
}

#[test]
fn every_sheet_ends_with_its_proof() {
    for name in ["tmv710a", "dmu50ev", "dmu80_monoblock", "endura900", "vmc3", "vmc4"] {
        let sheet = sheet(name);
        let proof = section(&sheet, "proof");
        assert_eq!(proof.len(), 2, "{sheet}");
        assert!(proof[0].starts_with("2048 seeded poses"), "{sheet}");
    }
}
