//! The document as a whole, once it has ended.

use crate::examiner::{Examined, Examiner, Rules};
use crate::network::Network;
use crate::rule::Check;
use std::sync::Arc;

/// What is kept of a document that has ended, and the rules that look at it. Each may do so on another thread.
pub struct Whole {
    pub(crate) rules: Arc<Rules>,
    pub(crate) network: Network,
}

impl Whole {
    /// What is kept of the document.
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Number of checks of the document as a whole: one for each rule, and the last for all rules on links of lanes.
    pub fn checks(&self) -> usize {
        self.rules.lists.network.len().saturating_add(1)
    }

    /// Whether the document's ids are together longer than 4 GiB, so that rules take some of them for empty: who compiles or
    /// checks such a document rejects it.
    pub fn lacks_ids(&self) -> bool {
        self.network.lacks_ids()
    }

    /// Whether more roads lie over one another than the rules that examined have been told of; see [`Network::overlaps`].
    pub fn has_more_overlaps(&self) -> bool {
        self.network.has_more_overlaps()
    }

    /// Whether a rule looks at all overlaps of roads. Finding them takes longer than any other rule, and the first caller
    /// keeps the others waiting.
    pub fn needs_overlaps(&self, check: usize) -> bool {
        let listed = self.rules.lists.network.get(check);
        listed.is_some_and(|listed| matches!(listed.applied.rule.check, Check::Overlaps(_)))
    }

    /// Does a check, by its number: from 0 on, and below [`Whole::checks`]. Others find nothing.
    pub fn examine(&self, check: usize) -> Examined {
        let checks = &self.rules.lists.network;
        let Some(listed) = checks.get(check) else {
            let is_last = check == checks.len();
            return if is_last { self.examine_joints() } else { Examined::default() };
        };
        let mut examiner = Examiner::with(&self.rules);
        examiner.apply(&self.rules, listed, &[], |sink| (listed.check)(&self.network, sink));
        Examined(examiner.found)
    }

    /// Applies the rules on links of lanes: what a link touches is found once for all of them.
    fn examine_joints(&self) -> Examined {
        let (rules, network) = (&self.rules, &self.network);
        let mut found: Vec<_> = rules.lists.joints.iter().map(|_| (0, Vec::new())).collect();
        let with_sinks = rules.lists.joints.iter().zip(&mut found);
        let mut looking: Vec<_> = with_sinks
            .map(|(listed, (count, out))| (listed.check, listed.sink(rules, &[], count, out)))
            .collect();
        network.each_lane_joint(|joint| {
            for (check, sink) in &mut looking {
                (check.lane)(network, joint, sink);
            }
        });
        for (check, sink) in &mut looking {
            (check.rest)(network, sink);
        }
        Examined(found.into_iter().flat_map(|(_, out)| out).collect())
    }
}
