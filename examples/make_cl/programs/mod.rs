//! The project's own CL files, computed from formulas.

mod blade_strip;
mod clsf;
mod cone;
mod face_mill;
mod feed_screw;
mod hemisphere;
mod impeller_hub;
mod long_rail;
mod pole;
mod sine_surface;

/// The files' names and texts.
pub(crate) fn all() -> Vec<(&'static str, String)> {
    vec![
        ("blade_strip.cls", blade_strip::text()),
        ("cone.cls", cone::text()),
        ("face_mill.cls", face_mill::text()),
        ("feed_screw.cls", feed_screw::text()),
        ("hemisphere.cls", hemisphere::text()),
        ("impeller_hub.cls", impeller_hub::text()),
        ("long_rail.cls", long_rail::text()),
        ("pole_crossed.cls", pole::crossed()),
        ("pole_missed.cls", pole::missed()),
        ("sine_surface.cls", sine_surface::text()),
    ]
}
