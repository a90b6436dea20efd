//! What processes on board say: taken on a socket of each map, judged by the operator's policy, told in an audit log. Without a policy there is no such
//! socket.
//!
//! Invariants: who says something is what the kernel says of the other end, and what the policy calls it. Everything is bounded: the length of a proposal,
//! how many are read at a time, how many a source may make in a minute and have at a time, for how long they hold, what waits for others.
//! Nothing is accepted that the audit log does not have.

mod audit;
mod judge;
mod policy;

pub(crate) use audit::{Audit, Line};
pub(crate) use judge::Judge;
pub(crate) use policy::ProposalPolicy;
