//! What a CL file gives, read from outside.

use crate::read::{Read, read, read_with};
use mach_runtime::cl::ReaderOptions;
use mach_runtime::machine::Strictness;
use mach_runtime::toolpath::{Approach, Command, Coolant, Feed, Spindle};
use mach_runtime::unit::LengthUnit;

fn clean(text: &str) -> Read {
    let read = read(text);
    assert!(read.diagnostics.is_empty(), "{:#?}", read.diagnostics);
    read
}

#[test]
fn a_whole_operation() {
    let read = clean(
        "TOOL PATH/POCKET,TOOL,MILL_D10\nTLDATA/MILL,10.0,0.0,75.0,0.0,0.0\n\
         MSYS/5.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0\n$$ centerline data\nPAINT/PATH\nLOAD/TOOL,3,ADJUST,7\n\
         SPINDL/RPM,8000,CCLW\nCOOLNT/MIST\nRAPID\nGOTO/1.0,2.0,30.0,0.0,0.6,0.8\n\
         FEDRAT/MMPM,250.\nGOTO/1.0,2.0,10.0\nGOTO/4.0,2.0,10.0\nSPINDL/OFF\nCOOLNT/OFF\nDELAY/2.5\nOPSTOP\nSTOP\nEND-OF-PATH\n\
         Tool Path Listing has 19 lines.",
    );
    let commands = [
        Command::Operation { name: "POCKET".into(), tool: "MILL_D10".into() },
        Command::Tool { number: 3, register: Some(7) },
        Command::SpindleOn(Spindle::Counterclockwise, 8000.0),
        Command::CoolantOn(Coolant::Mist),
        Command::SpindleOff,
        Command::CoolantOff,
        Command::Dwell(2.5),
        Command::OptionalStop,
        Command::Stop,
    ];
    assert_eq!(read.commands, commands);
    assert_eq!(read.tips(), [[1.0, 2.0, 30.0], [1.0, 2.0, 10.0], [4.0, 2.0, 10.0]]);
    assert!(read.points.iter().all(|point| point.axis == [0.0, 0.6, 0.8]), "the axis is kept");
    assert_eq!(read.points[0].approach, Approach::Rapid);
    assert_eq!(read.points[2].approach, Approach::Feed(Some(Feed::PerMinute(250.0))));
    assert_eq!(read.points.iter().map(|point| point.line).collect::<Vec<_>>(), [10, 12, 13]);
}

#[test]
fn a_bare_list_of_points_is_legal() {
    let read = clean("GOTO/1,2,3\nGOTO/2,3,4");
    assert_eq!(read.tips(), [[1.0, 2.0, 3.0], [2.0, 3.0, 4.0]]);
    assert_eq!(read.points[1].approach, Approach::Feed(None));
}

#[test]
fn rapid_holds_for_one_motion_only() {
    let read = clean("FEDRAT/100\nRAPID\nPAINT/COLOR,1\nGOTO/1,0,0\nGOTO/2,0,0\n");
    assert_eq!(read.points[0].approach, Approach::Rapid);
    assert_eq!(read.points[1].approach, Approach::Feed(Some(Feed::PerMinute(100.0))));
}

#[test]
fn every_spelling_of_a_goto_is_the_same_point() {
    for line in [
        "GOTO/1.5,-.25,30,0,0,1",
        "goto / 1.5 , -0.25 , 30. , 0.0 , 0. , 1",
        "GOTO/1.5,-2.5E-1,3.0e+1,0,0,1.0",
        "GOTO/1.50000000000000000,-.25,30,0,0,1",
        "GOTO/1.5,-.25,30,0,0,1 $$ 1.0,2.0,3.0",
        "  GOTO/1.5, $ goes on\n-.25,30 $$ a remark\n",
        "GOTO/1.5,-.25,$\n$$ a remark\n30,0,0,1",
        "\u{feff}GOTO/1.5,-.25,30",
        "GOTO/1.5,-.25,30\r\n\x1a",
    ] {
        let points = clean(line).points;
        assert_eq!((points[0].tip_mm, points[0].axis), ([1.5, -0.25, 30.0], [0.0, 0.0, 1.0]), "{line}");
    }
}

#[test]
fn minus_zero_never_leaves_the_reader() {
    let read = clean("FEDRAT/9\nGOTO/-0.0000,-0.0,-0,-0.0,-0.0,1.0\nGOTO/-0.0 , 0 , -0E0\n");
    for point in &read.points {
        assert!(point.tip_mm.iter().chain(&point.axis).all(|value| !value.is_sign_negative() || *value < 0.0));
    }
}

#[test]
fn an_increment_moves_from_where_the_tool_is() {
    let read = clean("FEDRAT/9\nGOTO/1,2,3,0,1,0\nGODLTA/1,1,1\nGODLTA/5\nGODLTA/0,0,1,0,0,1\n");
    assert_eq!(read.tips(), [[1.0, 2.0, 3.0], [2.0, 3.0, 4.0], [2.0, 8.0, 4.0], [2.0, 8.0, 5.0]]);
    assert_eq!(read.points[3].axis, [0.0, 0.0, 1.0]);
}

#[test]
fn home_is_where_from_was() {
    let read = clean("FROM/0,0,100\nRAPID\nGOTO/1,0,0\nRAPID\nGOHOME\nRAPID\nGOHOME/9,9,9\n");
    assert_eq!(read.from[0].tip_mm, [0.0, 0.0, 100.0]);
    assert_eq!(read.tips(), [[1.0, 0.0, 0.0], [0.0, 0.0, 100.0], [9.0, 9.0, 9.0]]);
}

#[test]
fn feeds_in_every_unit() {
    let read = read(
        "UNITS/INCHES\nFEDRAT/IPM,10\nGOTO/1,0,0\nFEDRAT/ .01 , IPR\nGOTO/2,0,0\nFEDRAT/.02\nGOTO/3,0,0\nUNIT/MM\n\
         FEDRAT/MMPR,.5\nGOTO/4,0,0\nFEDRAT/500,MMPM\nGOTO/5,0,0\n",
    );
    assert_eq!(read.codes(), ["W1004"], "the second UNITS");
    let feeds: Vec<Approach> = read.points.iter().map(|point| point.approach).collect();
    let expected = [
        Feed::PerMinute(254.0),
        Feed::PerRevolution(0.254),
        Feed::PerRevolution(0.508),
        Feed::PerRevolution(0.5),
        Feed::PerMinute(500.0),
    ];
    assert_eq!(feeds, expected.map(|feed| Approach::Feed(Some(feed))));
    assert_eq!(read.points[0].tip_mm[0], 25.4);
    assert_eq!(read.points[3].tip_mm[0], 4.0);
}

#[test]
fn the_unit_of_a_file_without_units_is_an_option() {
    let inch = ReaderOptions { length_unit: LengthUnit::Inch, ..ReaderOptions::default() };
    let read = read_with("FEDRAT/10\nGOTO/1,0,0\n", inch);
    assert_eq!(read.points[0].tip_mm, [25.4, 0.0, 0.0]);
    assert_eq!(read.points[0].approach, Approach::Feed(Some(Feed::PerMinute(254.0))));
}

#[test]
fn a_later_msys_is_placed_in_the_first() {
    let read = clean(
        "FEDRAT/9\nMSYS/0,0,50,1,0,0,0,1,0\nGOTO/1,2,3\nMSYS/10,0,50,0,1,0,-1,0,0\nGOTO/1,2,3,1,0,0\nGODLTA/1,0,0\n\
         MSYS/0,0,50,1,0,0,0,1,0\nGOTO/1,2,3\n",
    );
    assert_eq!(read.tips(), [[1.0, 2.0, 3.0], [8.0, 1.0, 3.0], [8.0, 2.0, 3.0], [1.0, 2.0, 3.0]]);
    let axes: Vec<_> = read.points[1..].iter().map(|point| point.axis).collect();
    assert_eq!(
        axes,
        [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        "kept until the next MSYS, whose Z it is then"
    );
}

#[test]
fn free_text_is_taken_as_it_stands() {
    let read = clean("PARTNO / MFG,0004\nPPRINT/ set $$ up, 50/60 $\nRAPID\nGOTO/0,0,0\npprint check\n");
    let texts = ["set $$ up, 50/60 $", "check"].map(|text| Command::Message(text.into()));
    assert_eq!(read.commands, texts);
}

#[test]
fn names_may_be_latin_1() {
    let read = read(b"TOOL PATH/FL\xc4CHE,TOOL,FR\xc4SER\nRAPID\nGOTO/0,0,0\nEND-OF-PATH\n");
    assert_eq!(read.commands, [Command::Operation { name: "FLÄCHE".into(), tool: "FRÄSER".into() }]);
}

#[test]
fn an_arc_becomes_chords_to_its_end() {
    let read = clean(
        "FEDRAT/9\nGOTO/0.0,10.0,5.0\nCIRCLE/0.0,0.0,5.0,0.0,0.0,1.0,10.0,0.06,0.5,10.0,0.0\nPAINT/COLOR,31\n\
         GOTO/10.0,0.0,5.0\nGOTO/20.0,0.0,5.0\n",
    );
    assert_eq!(read.points.len(), 2 + 18, "a quarter of r 10 to 0.01 mm");
    let arc = &read.points[1..19];
    assert!(arc.iter().all(|point| point.tip_mm[0] > 0.0 && point.line == 5), "clockwise about +z");
    assert_eq!(arc[17].tip_mm, [10.0, 0.0, 5.0]);
}

#[test]
fn a_helix_takes_its_turns() {
    let text =
        "FEDRAT/9\nGOTO/0.0,10.0,5.0\nCIRCLE/0.0,0.0,5.0,0,0,1,10.0,0.06,0.5,10.0,0.0,TIMES,3\nGOTO/0.0,10.0,-4.0\n";
    let read = clean(text);
    assert_eq!(read.points.len(), 1 + 3 * 71 - 2);
    assert!(read.points.windows(2).all(|pair| pair[1].tip_mm[2] < pair[0].tip_mm[2]));
}

#[test]
fn an_unknown_record_follows_the_policy() {
    let text = "RAPID\nGOTO/0,0,0\nWOBBLE/3\nWOBBLE/4\n";
    assert_eq!(read(text).codes(), ["E1010", "E1010"]);
    let warn = ReaderOptions { unknown_records: Strictness::Warn, ..ReaderOptions::default() };
    assert_eq!(read_with(text, warn).codes(), ["W1010"]);
}
