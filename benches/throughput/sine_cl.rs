//! A CL file of any size: a zig-zag over z = 20 + 5 sin(2πx/100) + 5 sin(2πy/100), tool normal to the surface.

use std::fmt::Write;

/// About so many GOTO records, in a square.
pub(crate) fn records(count: usize) -> String {
    let side = libm::sqrt(count as f64) as usize;
    let mut text = String::with_capacity(count * 62);
    text.push_str("TOOL PATH/SINE,TOOL,BALL_MILL\nTLDATA/MILL,10.0000,5.0000,75.0000,0.0000,0.0000\n");
    text.push_str("MSYS/0.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0\nLOAD/TOOL,2\nFEDRAT/MMPM,250.0000\n");
    let place = |step: usize| -50.0 + 100.0 * step as f64 / (side - 1) as f64;
    for row in 0..side {
        for column in 0..side {
            point(&mut text, place(if row % 2 == 0 { column } else { side - 1 - column }), place(row));
        }
    }
    text.push_str("END-OF-PATH\n");
    text
}

fn point(text: &mut String, x: f64, y: f64) {
    let wave = 2.0 * std::f64::consts::PI / 100.0;
    let z = 20.0 + 5.0 * libm::sin(wave * x) + 5.0 * libm::sin(wave * y);
    let (slope_x, slope_y) = (5.0 * wave * libm::cos(wave * x), 5.0 * wave * libm::cos(wave * y));
    let length = libm::sqrt(slope_x * slope_x + slope_y * slope_y + 1.0);
    let (i, j, k) = (-slope_x / length, -slope_y / length, 1.0 / length);
    writeln!(text, "GOTO/{x:.4},{y:.4},{z:.4},{i:.7},{j:.7},{k:.7}").expect("writing to a string does not fail");
}
