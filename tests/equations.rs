//! What `machc emit equations` and `machc emit json` write, locked.

use mach_runtime::machine::Rule;
use machc::emit::{json, latex};

#[path = "common/machine.rs"]
mod machine;

fn compiled(name: &str) -> machc::compile::Compiled {
    machine::compiled(&format!("machines/{name}.mach"), &machine::Files)
}

#[test]
fn equations_are_as_locked() {
    for name in ["tmv710a", "dmu50ev", "vmc4", "vmc3"] {
        let compiled = compiled(name);
        insta::assert_snapshot!(format!("{name}_equations"), latex::equations(&compiled.model, &compiled.plan));
    }
}

#[test]
fn resolved_machines_are_as_locked() {
    for name in ["tmv710a", "dmu50ev"] {
        insta::assert_snapshot!(format!("{name}_json"), json::machine(&compiled(name).model));
    }
}

#[test]
fn measured_errors_are_listed() {
    let page = |name: &str| {
        let compiled = compiled(name);
        latex::equations(&compiled.model, &compiled.plan)
    };
    let measured = page("tmv710a_measured");
    for part in ["\n## Errors\n\n- EC0Y = -15 urad", "without the errors that depend on positions"] {
        assert!(measured.contains(part), "{measured}");
    }
    assert!(!page("tmv710a").contains("Errors"));
}

#[test]
fn every_machine_has_both() {
    for entry in std::fs::read_dir(machine::root().join("machines")).expect("the folder is there") {
        let path = entry.expect("readable").path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()?.strip_suffix(".mach")) else { continue };
        let compiled = compiled(name);
        let page = latex::equations(&compiled.model, &compiled.plan);
        let displays: Vec<&str> = page.split("$$").skip(1).step_by(2).collect();
        assert!(displays.len() >= 3, "{name}: {page}");
        for display in displays {
            let count = |part: &str| display.matches(part).count();
            assert_eq!((count("{"), count("\\left(")), (count("}"), count("\\right)")), "{name}: {display}");
            assert!(display.is_ascii(), "{name}: {display}");
        }
        let parsed: serde_json::Value = serde_json::from_str(&json::machine(&compiled.model)).expect("JSON");
        assert_eq!(parsed["axes"].as_array().expect("axes").len(), compiled.model.axes.len(), "{name}");
        assert_eq!(parsed["name"], name);
        for (axis, told) in compiled.model.axes.iter().zip(parsed["axes"].as_array().expect("axes")) {
            let keys = ["lock_mm", "lock_deg", "prefer_mm", "prefer_deg", "free"];
            let is_told = keys.iter().any(|key| told.get(key).is_some());
            assert_eq!(is_told, axis.rule != Rule::Pose, "{name}: {told}");
        }
    }
}
