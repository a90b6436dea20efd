//! The graph that all motor vehicles together may use, and distances over it from one place to all.
//!
//! Most places are entered from one other alone: ways through a junction, each from its incoming lane, and later sections of a
//! lane. Such a place follows the other: its distance is the other's and the way between. So only places where ways join are
//! searched. A search backwards has places of its own that follow.

use super::motor_edges::{Edge, Places, Sparse, Weight, edges};
use mapd_archive::{NONE, Rows};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A place that follows another of its tree.
struct Follower {
    place: u32,
    /// The number, within the tree, of the place that it follows; 0 is the tree's root.
    after: u32,
    weight: Weight,
}

/// An edge from a place of a tree to a root.
struct Exit {
    /// The place's number within the tree.
    from: u32,
    /// The root's number.
    to: u32,
    weight: Weight,
}

/// Where the followers and exits of a tree begin.
#[derive(Clone, Copy)]
struct Tree {
    root: u32,
    followers: u32,
    exits: u32,
}

/// The graph of motor vehicles as trees: a root, where ways join or begin, with all that follows it.
pub(super) struct MotorWays {
    /// By number, and one behind the last.
    trees: Vec<Tree>,
    /// Tree by tree; each behind the one that it follows.
    followers: Vec<Follower>,
    exits: Vec<Exit>,
    /// By place the number of its tree, and its own in there.
    in_trees: Vec<InTree>,
}

/// Where a place is.
#[derive(Clone, Copy)]
struct InTree {
    tree: u32,
    /// 0 for the root; those that follow count from 1.
    number: u32,
}

/// What a search works in. The next one uses the same memory: of a large map it is too much to be taken from the system each time.
#[derive(Default)]
pub(super) struct Room {
    /// Distances of roots.
    roots: Vec<f64>,
    /// Roots that are reached, the nearest first.
    open: BinaryHeap<Reverse<(u64, u32)>>,
    /// Distances of the places of a tree.
    own: Vec<f64>,
}

/// The graph forward and backward.
pub(super) fn both_ways(rows: &Rows, places: &Places) -> [MotorWays; 2] {
    let edges = edges(rows, places);
    let edges = || edges.iter().copied();
    let (ahead, behind) = rayon::join(
        || MotorWays::of(&Sparse::of(edges(), places.count)),
        || MotorWays::of(&Sparse::of(edges().map(Edge::turned), places.count)),
    );
    [ahead, behind]
}

impl MotorWays {
    fn of(edges: &Sparse) -> Self {
        let count = edges.places();
        let mut entered = vec![0u32; count];
        for (to, _) in &edges.targets {
            entered[*to as usize] = entered[*to as usize].saturating_add(1);
        }
        let not_yet = InTree { tree: NONE, number: 0 };
        let mut ways = Self {
            trees: Vec::new(),
            followers: Vec::new(),
            exits: Vec::with_capacity(edges.targets.len()),
            in_trees: vec![not_yet; count],
        };
        for place in (0..count as u32).filter(|place| entered[*place as usize] != 1) {
            ways.grow(place, edges, &entered);
        }
        // What is left are rings that nothing enters: each gets a root that is one of it.
        for place in 0..count as u32 {
            if ways.in_trees[place as usize].tree == NONE {
                entered[place as usize] = 0;
                ways.grow(place, edges, &entered);
            }
        }
        let (followers, exits) = (ways.followers.len() as u32, ways.exits.len() as u32);
        ways.trees.push(Tree { root: NONE, followers, exits });
        for exit in &mut ways.exits {
            exit.to = ways.in_trees[exit.to as usize].tree;
        }
        ways
    }

    /// Adds a root with all that follows it. Its exits name places: not all roots have a number yet.
    fn grow(&mut self, root: u32, edges: &Sparse, entered: &[u32]) {
        let tree = self.trees.len() as u32;
        let (first, exits) = (self.followers.len(), self.exits.len());
        self.trees.push(Tree { root, followers: first as u32, exits: exits as u32 });
        self.in_trees[root as usize] = InTree { tree, number: 0 };
        let (mut place, mut number) = (root, 0);
        loop {
            for (to, weight) in edges.leaving(place) {
                if entered[*to as usize] != 1 {
                    self.exits.push(Exit { from: number, to: *to, weight: *weight });
                    continue;
                }
                self.followers.push(Follower { place: *to, after: number, weight: *weight });
                let own = (self.followers.len() - first) as u32;
                self.in_trees[*to as usize] = InTree { tree, number: own };
            }
            let Some(next) = self.followers.get(first + number as usize) else { break };
            (place, number) = (next.place, number + 1);
        }
    }

    /// Number of trees.
    fn len(&self) -> usize {
        self.trees.len() - 1
    }

    fn followers(&self, tree: usize) -> &[Follower] {
        let [from, to] = [tree, tree + 1].map(|tree| self.trees[tree].followers as usize);
        &self.followers[from..to]
    }

    fn exits(&self, tree: usize) -> &[Exit] {
        let [from, to] = [tree, tree + 1].map(|tree| self.trees[tree].exits as usize);
        &self.exits[from..to]
    }

    /// Distances of a tree's places by their numbers, from that of its root; the place of number `start` is where the search
    /// began, if it is in this tree.
    fn spread(
        &self,
        tree: usize,
        root: f64,
        start: Option<u32>,
        weight: impl Fn(&Weight) -> f32,
        distances: &mut Vec<f64>,
    ) {
        distances.clear();
        distances.push(if start == Some(0) { 0.0 } else { root });
        for (own, follower) in (1..).zip(self.followers(tree)) {
            let before = distances[follower.after as usize];
            let there = before + f64::from(weight(&follower.weight));
            distances.push(if start == Some(own) { 0.0 } else { there });
        }
    }

    /// Distances from a place to all (Dijkstra).
    pub(super) fn distances(
        &self,
        from: u32,
        weight: impl Fn(&Weight) -> f32 + Copy,
        Room { roots, open, own }: &mut Room,
    ) -> Reached {
        let start = self.in_trees[from as usize];
        roots.clear();
        roots.resize(self.len(), f64::INFINITY);
        if start.number == 0 {
            roots[start.tree as usize] = 0.0;
        }
        let mut largest = 0.0;
        // The tree where the search begins comes first; if its root is reached from elsewhere, once more.
        let (mut tree, mut distance) = (start.tree as usize, f64::INFINITY);
        loop {
            let here = (tree == start.tree as usize).then_some(start.number);
            self.spread(tree, distance, here, weight, own);
            largest = own.iter().filter(|d| d.is_finite()).copied().fold(largest, f64::max);
            for exit in self.exits(tree) {
                let there = own[exit.from as usize] + f64::from(weight(&exit.weight));
                let known = &mut roots[exit.to as usize];
                if there < *known {
                    *known = there;
                    // Distances are not negative: their bits order as they do.
                    open.push(Reverse((there.to_bits(), exit.to)));
                }
            }
            let next = loop {
                let Some(Reverse((bits, next))) = open.pop() else { break None };
                let there = f64::from_bits(bits);
                if there <= roots[next as usize] {
                    break Some((next as usize, there));
                }
            };
            let Some(next) = next else { break };
            (tree, distance) = next;
        }
        Reached::of(roots, start, largest)
    }

    /// Hands over the places that are reached with their distances, tree by tree.
    pub(super) fn visit(
        &self,
        reached: &Reached,
        weight: impl Fn(&Weight) -> f32 + Copy,
        mut found: impl FnMut(u32, f64),
    ) {
        let start = reached.start;
        let mut own = Vec::new();
        let mut visit = |tree: usize, root: f64, start: Option<u32>| {
            self.spread(tree, root, start, weight, &mut own);
            let mut found = |place: u32, distance: f64| {
                if distance.is_finite() {
                    found(place, distance);
                }
            };
            let Some((root, others)) = own.split_first() else { return };
            found(self.trees[tree].root, *root);
            for (follower, distance) in self.followers(tree).iter().zip(others) {
                found(follower.place, *distance);
            }
        };
        for (tree, root) in (reached.first..).zip(&reached.roots) {
            if root.is_finite() && tree != start.tree as usize {
                visit(tree, *root, None);
            }
        }
        let root = (start.tree as usize).checked_sub(reached.first);
        let root = root.and_then(|at| reached.roots.get(at)).copied().unwrap_or(f64::INFINITY);
        visit(start.tree as usize, root, Some(start.number));
    }
}

/// Distances of roots, but for the unreached ones before the first that is reached and behind the last: of a map whose parts
/// are not joined, as tiles side by side, most are.
pub(super) struct Reached {
    first: usize,
    roots: Vec<f64>,
    /// Where the search began.
    start: InTree,
    /// The largest distance of any place that is reached.
    pub(super) largest: f64,
}

impl Reached {
    fn of(all: &[f64], start: InTree, largest: f64) -> Self {
        let is_reached = |distance: &f64| distance.is_finite();
        let first = all.iter().position(is_reached).unwrap_or(all.len());
        let end = all.iter().rposition(is_reached).map_or(first, |last| last + 1);
        Self { first, roots: all.get(first..end).unwrap_or_default().to_vec(), start, largest }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(from: u32, to: u32, length: f32) -> Edge {
        Edge { from, to, weight: Weight { length, time: 1.0 } }
    }

    /// Distances by relaxing all edges until nothing changes.
    fn expected(edges: &[Edge], count: usize, start: u32) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; count];
        distances[start as usize] = 0.0;
        for _ in 0..count {
            for edge in edges {
                let there = distances[edge.from as usize] + f64::from(edge.weight.length);
                let known = &mut distances[edge.to as usize];
                *known = known.min(there);
            }
        }
        distances
    }

    /// Compares the distances from each place with the expected ones, bit by bit.
    fn check(edges: &[Edge], count: usize) {
        let ways = MotorWays::of(&Sparse::of(edges.iter().copied(), count));
        let length = |weight: &Weight| weight.length;
        let mut room = Room::default();
        for start in 0..count as u32 {
            let reached = ways.distances(start, length, &mut room);
            let mut found = vec![f64::INFINITY; count];
            ways.visit(&reached, length, |place, distance| found[place as usize] = distance);
            let expected = expected(edges, count, start);
            assert_eq!(found, expected, "from {start}");
            let finite = expected.iter().copied().filter(|distance| distance.is_finite());
            assert_eq!(reached.largest, finite.fold(0.0, f64::max), "from {start}");
        }
    }

    #[test]
    fn followers_and_joins_have_the_distances_of_a_plain_search() {
        let ring = [edge(0, 1, 0.1), edge(1, 2, 0.7), edge(2, 0, 0.3)];
        let left = [edge(3, 1, 0.2), edge(2, 4, 0.5), edge(4, 5, 0.0), edge(4, 6, 1e9)];
        check(&[], 2);
        check(&[edge(0, 0, 1.0)], 1);
        check(&[edge(0, 1, 1.0), edge(0, 1, 0.5)], 2);
        // A ring that nothing enters; the same with ways into it and out of it.
        check(&ring, 3);
        check(&[&ring[..], &left].concat(), 7);
        check(&[&ring[..], &left, &[edge(6, 3, 0.6)]].concat(), 7);
        let mut random = 1u32;
        let mut below = |most: u32| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 8) % most
        };
        for _ in 0..200 {
            let count = 2 + below(30);
            let edges: Vec<Edge> = (0..below(2 * count))
                .map(|_| edge(below(count), below(count), below(1000) as f32 * 0.37))
                .collect();
            check(&edges, count as usize);
        }
    }
}
