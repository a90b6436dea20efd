//! What one may do on a lane: speed, overtaking, lines, turns, right of way.

mod country;
pub(crate) mod entry_sign;
mod last_sign;
mod lines;
mod movement;
mod overtaking;
pub(crate) mod right_of_way;
mod speed;
mod speed_records;
pub(crate) mod speed_signs;

pub(crate) use country::by_rules;
pub(crate) use entry_sign::EntrySign;
pub use lines::{LaneLine, LineAhead, LineSource};
pub(crate) use movement::ENTRY_REACH;
pub use movement::{Basis, EntrySignal, RightOfWay, Turn, YieldsTo};
pub use overtaking::OvertakingRule;
pub(crate) use speed::{Carried, Limits, NOTHING};
pub use speed::{SpeedOrigin, SpeedRule, SpeedStretch};
pub(crate) use speed_records::SpeedRecords;
pub(crate) use speed_signs::{SpeedSigns, Zone};
