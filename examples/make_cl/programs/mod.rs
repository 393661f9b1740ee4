//! The project's own CL files, computed from formulas.

mod blade_strip;
mod clsf;
mod face_mill;
mod feed_screw;
mod hemisphere;
mod sine_surface;

/// The files' names and texts.
pub(crate) fn all() -> Vec<(&'static str, String)> {
    vec![
        ("blade_strip.cls", blade_strip::text()),
        ("face_mill.cls", face_mill::text()),
        ("feed_screw.cls", feed_screw::text()),
        ("hemisphere.cls", hemisphere::text()),
        ("sine_surface.cls", sine_surface::text()),
    ]
}
