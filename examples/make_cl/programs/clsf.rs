//! The records of NX CLSF.

/// A point or a direction.
pub(crate) type Vec3 = [f64; 3];

/// Straight up.
pub(crate) const UP: Vec3 = [0.0, 0.0, 1.0];

/// A cutter and the speed it turns at.
#[derive(Clone, Copy)]
pub(crate) struct Cutter {
    pub(crate) number: u32,
    pub(crate) name: &'static str,
    pub(crate) diameter_mm: f64,
    pub(crate) corner_mm: f64,
    pub(crate) speed_rpm: u32,
}

/// A tip and the unit tool axis there.
#[derive(Clone, Copy)]
pub(crate) struct Pose {
    pub(crate) tip_mm: Vec3,
    pub(crate) axis: Vec3,
}

impl Pose {
    /// Drawn back along the tool.
    pub(crate) fn back(self, by_mm: f64) -> Self {
        Self { tip_mm: std::array::from_fn(|i| self.tip_mm[i] + by_mm * self.axis[i]), ..self }
    }
}

/// A CL file that grows record by record.
#[derive(Default)]
pub(crate) struct Clsf {
    text: String,
    /// The tool axis written last, as it was written.
    axis: String,
}

impl Clsf {
    pub(crate) fn text(self) -> String {
        self.text
    }

    fn record(&mut self, record: &str) {
        self.text += record;
        self.text.push('\n');
    }

    /// The head of an operation, its tool, spindle and coolant.
    pub(crate) fn begin(&mut self, operation: &str, cutter: Cutter) {
        let Cutter { number, name, diameter_mm, corner_mm, speed_rpm } = cutter;
        self.record(&format!("TOOL PATH/{operation},TOOL,{name}"));
        self.record(&format!("TLDATA/MILL,{}", list([diameter_mm, corner_mm, 75.0, 0.0, 0.0], 4)));
        self.record(&format!("MSYS/{},{},{}", list([0.0; 3], 4), list([1.0, 0.0, 0.0], 7), list([0.0, 1.0, 0.0], 7)));
        self.record("$$ centerline data");
        self.record("PAINT/PATH");
        self.record("PAINT/SPEED,10");
        self.record(&format!("LOAD/TOOL,{number},ADJUST,{number}"));
        self.record(&format!("SPINDL/RPM,{speed_rpm},CLW"));
        self.record("COOLNT/FLOOD");
        self.axis.clear();
    }

    /// The foot of an operation.
    pub(crate) fn end(&mut self) {
        self.record("END-OF-PATH");
    }

    /// In rapid traverse to a point.
    pub(crate) fn rapid(&mut self, pose: Pose) {
        self.record("PAINT/COLOR,186");
        self.record("RAPID");
        self.goto(pose);
    }

    /// The feed of what follows, in mm/min.
    pub(crate) fn feed(&mut self, feed_mm_per_min: f64) {
        self.record("PAINT/COLOR,31");
        self.record(&format!("FEDRAT/MMPM,{feed_mm_per_min:.4}"));
    }

    /// On a line to a point; an axis that stays is left out, as NX does.
    pub(crate) fn goto(&mut self, pose: Pose) {
        let axis = list(pose.axis, 7);
        let tip = list(pose.tip_mm, 4);
        let changed = axis != self.axis;
        self.record(&if changed { format!("GOTO/{tip},{axis}") } else { format!("GOTO/{tip}") });
        self.axis = axis;
    }

    /// Level on an arc to a point, counter-clockwise or clockwise as seen from above. NX gives the normal of an arc by
    /// the left hand.
    pub(crate) fn arc(&mut self, centre_mm: Vec3, radius_mm: f64, counterclockwise: bool, pose: Pose) {
        let normal = [0.0, 0.0, if counterclockwise { -1.0 } else { 1.0 }];
        let (centre, normal) = (list(centre_mm, 4), list(normal, 7));
        self.record(&format!("CIRCLE/{centre},{normal},{radius_mm:.4},0.0600,0.5000,10.0000,0.0000"));
        self.goto(pose);
    }

    /// One cut: in rapid traverse to above its beginning, along it, and back off its end.
    pub(crate) fn cut(&mut self, poses: &[Pose], feed_mm_per_min: f64, clearance_mm: f64) {
        let (first, last) = (poses[0], poses[poses.len() - 1]);
        self.rapid(first.back(clearance_mm));
        self.feed(feed_mm_per_min);
        poses.iter().for_each(|pose| self.goto(*pose));
        self.rapid(last.back(clearance_mm));
    }
}

/// Numbers with so many decimals, and no minus before a zero.
fn list<const N: usize>(numbers: [f64; N], decimals: usize) -> String {
    let number = |number: f64| {
        let text = format!("{number:.decimals$}");
        let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
        if is_zero { text.trim_start_matches('-').to_owned() } else { text }
    };
    numbers.map(number).join(",")
}
