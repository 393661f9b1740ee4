//! How events are written.

use super::tree::Event;

/// Every event and how it is written after `on`.
pub const EVENTS: [(&str, Event); 19] = [
    ("start", Event::Start),
    ("end", Event::End),
    ("operation", Event::Operation),
    ("tool", Event::Tool),
    ("spindle clockwise", Event::SpindleClockwise),
    ("spindle counterclockwise", Event::SpindleCounterclockwise),
    ("spindle off", Event::SpindleOff),
    ("coolant flood", Event::CoolantFlood),
    ("coolant mist", Event::CoolantMist),
    ("coolant through", Event::CoolantThrough),
    ("coolant off", Event::CoolantOff),
    ("stop", Event::Stop),
    ("optional stop", Event::OptionalStop),
    ("dwell", Event::Dwell),
    ("message", Event::Message),
    ("approach", Event::Approach),
    ("approach feed", Event::ApproachFeed),
    ("rapid", Event::Rapid),
    ("feed", Event::Feed),
];

impl Event {
    /// As it is written after `on`.
    pub fn words(self) -> &'static str {
        EVENTS.iter().find(|(_, event)| *event == self).map(|(words, _)| *words).expect("EVENTS lists every event")
    }

    /// The event that is written like this, with one blank between its words.
    pub fn from_words(words: &str) -> Option<Self> {
        EVENTS.iter().find(|(written, _)| *written == words).map(|(_, event)| *event)
    }
}
