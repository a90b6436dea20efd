//! Readers that take part in iceoryx2, and what the daemon shares with them.

mod attach;
mod config;
mod connections;
mod count;
mod node_counter;
mod sample;
mod shortage;
mod subscription;

pub use attach::AttachTiming;
pub use config::{TransportService, iceoryx2_config, silence_iceoryx2};
pub use count::count_subscriptions;
pub use node_counter::{foreign_node_counter, node_counter, prepare_node_counter};
pub(crate) use sample::PinnedSample;
pub use subscription::Subscription;
