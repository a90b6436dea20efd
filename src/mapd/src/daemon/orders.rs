//! What the thread that serves is told to do.

use super::child::Refusal;
use super::overlays::OverlayOrder;
use super::prepare::Prepared;
use crate::control::{Response, Trigger};
use crate::serve::Ringer;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Instant;

/// An order.
pub(crate) enum Order {
    /// Look what readers hold, so that the board says what is so now; then say so.
    Look(Sender<()>),
    /// Change what is served.
    Change(Change),
    /// Look at what is laid over a map, or change it.
    Overlay(OverlayOrder),
    /// A map has been prepared, or not.
    Prepared(Box<Job>, Result<Prepared, Refusal>),
}

/// Changes what is served of a map.
pub(crate) struct Change {
    pub(crate) map: String,
    pub(crate) trigger: Trigger,
    /// Leave it staged; for reloads that were not requested, the map's settings decide.
    pub(crate) stage: bool,
    pub(crate) begun: Instant,
    /// Where the outcome goes. If the caller no longer waits for it, it is dropped.
    pub(crate) reply: Option<Sender<Response>>,
}

/// A map to prepare.
pub(crate) struct Job {
    pub(crate) change: Change,
    /// Not from the cache, whose archive did not prove.
    pub(crate) anew: bool,
}

/// Sends orders, and rings.
#[derive(Clone)]
pub(crate) struct Orders {
    sender: Sender<Order>,
    ringer: std::sync::Arc<Ringer>,
}

impl Orders {
    pub(crate) fn new(ringer: Ringer) -> (Self, Receiver<Order>) {
        let (sender, receiver) = channel();
        (Self { sender, ringer: std::sync::Arc::new(ringer) }, receiver)
    }

    /// Gives an order; false if the daemon ends.
    pub(crate) fn give(&self, order: Order) -> bool {
        let given = self.sender.send(order).is_ok();
        self.ringer.ring();
        given
    }
}
