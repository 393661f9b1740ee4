//! The controllers that machc brings along: what a `use` finds where no file of that name is.

use std::path::Path;

/// Path and text of each, as in `machines/`.
pub(super) const CONTROLLERS: [(&str, &str); 5] = [
    ("controllers/fanuc.mach", include_str!("../../machines/controllers/fanuc.mach")),
    ("controllers/linuxcnc.mach", include_str!("../../machines/controllers/linuxcnc.mach")),
    ("controllers/heidenhain.mach", include_str!("../../machines/controllers/heidenhain.mach")),
    ("controllers/siemens.mach", include_str!("../../machines/controllers/siemens.mach")),
    ("controllers/syntec.mach", include_str!("../../machines/controllers/syntec.mach")),
];

/// The text that stands in for a file that is not there: that of the controller whose path the file's path ends in.
pub(super) fn stand_in(path: &str) -> Option<&'static str> {
    let found = CONTROLLERS.into_iter().find(|(name, _)| Path::new(path).ends_with(name));
    found.map(|(_, text)| text)
}

/// Their names, as a machine file spells them.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    CONTROLLERS.into_iter().filter_map(|(path, _)| Path::new(path).file_stem()?.to_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_controller_is_brought_along() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/machines/controllers");
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = format!("controllers/{}", path.file_name().unwrap().to_string_lossy());
            assert_eq!(stand_in(&name), Some(std::fs::read_to_string(path).unwrap().as_str()), "{name}");
        }
    }

    #[test]
    fn only_whole_names_are_found() {
        assert!(stand_in("machines/controllers/syntec.mach").is_some());
        assert!(stand_in("my_controllers/syntec.mach").is_none());
        assert!(stand_in("syntec.mach").is_none());
    }
}
