//! Codes of an overlay's tables.

use crate::codes::codes;

codes! {
    /// What an entry of an overlay says.
    OverlayKind {
        /// Closed for these vehicles.
        Closed = 0, "closed";
        /// Opened for these vehicles, such as a hard shoulder. What is closed as well stays closed.
        Open = 1, "open";
        /// No faster than this.
        Speed = 2, "speed";
        /// No overtaking.
        NoOvertaking = 3, "no-overtaking";
        /// The surface is wet.
        Wet = 4, "wet";
        /// There is ice.
        Icy = 5, "icy";
        /// A signal, or traffic light, is out of service.
        SignalOff = 6, "signal-off";
        /// A warning, in words.
        Warning = 7, "warning";
        /// There is snow.
        Snow = 8, "snow";
        /// The surface is rough.
        Rough = 9, "rough";
    }
}
