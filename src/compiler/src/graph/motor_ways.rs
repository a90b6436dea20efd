//! The graph that all motor vehicles together may use, and distances over it from one place to all.
//!
//! Most places are entered from one other alone: ways through a junction, each from its incoming lane, and later sections of a
//! lane. Such a place follows the other: its distance is the other's and the way between. So only places where ways join are
//! searched. A search backwards has places of its own that follow.

use super::motor_edges::{Edge, Places, Sparse, Weight, edges};
use mapd_archive::{NONE, Rows};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// A place of a tree. Its position is its rank among the places of all trees.
struct Member {
    place: u32,
    /// Position of the place that it follows; of a root its own.
    after: u32,
    /// The way between; of a root none.
    weight: Weight,
}

/// An edge from a place of a tree to a root.
struct Exit {
    /// The place's position.
    from: u32,
    /// The root's tree.
    to: u32,
    weight: Weight,
}

/// Where the places and exits of a tree begin.
#[derive(Clone, Copy)]
struct Tree {
    members: u32,
    exits: u32,
}

/// The graph of motor vehicles as trees: a root, where ways join or begin, with all that follows it.
pub(super) struct MotorWays {
    /// By number, and one behind the last.
    trees: Vec<Tree>,
    /// Tree by tree, its root first; each behind the one that it follows.
    members: Vec<Member>,
    exits: Vec<Exit>,
    /// By place where it is.
    in_trees: Vec<InTree>,
}

/// Where a place is.
#[derive(Clone, Copy)]
struct InTree {
    tree: u32,
    position: u32,
}

/// What a search works in. The next one uses the same memory: of a large map it is too much to be taken from the system each time.
#[derive(Default)]
pub(super) struct Room {
    /// Distances of roots.
    roots: Vec<f64>,
    /// Trees whose roots are reached, the nearest first.
    open: BinaryHeap<Reverse<(u64, u32)>>,
    /// Distances of the places of some trees.
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
        let not_yet = InTree { tree: NONE, position: 0 };
        let mut ways = Self {
            trees: Vec::new(),
            members: Vec::with_capacity(count),
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
        let (members, exits) = (ways.members.len() as u32, ways.exits.len() as u32);
        ways.trees.push(Tree { members, exits });
        for exit in &mut ways.exits {
            exit.to = ways.in_trees[exit.to as usize].tree;
        }
        ways
    }

    /// Adds a root with all that follows it. Its exits name places: not all roots have a number yet.
    fn grow(&mut self, root: u32, edges: &Sparse, entered: &[u32]) {
        let tree = self.trees.len() as u32;
        let (mut position, exits) = (self.members.len() as u32, self.exits.len() as u32);
        self.trees.push(Tree { members: position, exits });
        self.in_trees[root as usize] = InTree { tree, position };
        let weight = Weight { length: 0.0, time: 0.0 };
        self.members.push(Member { place: root, after: position, weight });
        while let Some(place) = self.members.get(position as usize).map(|own| own.place) {
            for (to, weight) in edges.leaving(place) {
                if entered[*to as usize] != 1 {
                    self.exits.push(Exit { from: position, to: *to, weight: *weight });
                    continue;
                }
                let own = self.members.len() as u32;
                self.in_trees[*to as usize] = InTree { tree, position: own };
                self.members.push(Member { place: *to, after: position, weight: *weight });
            }
            position += 1;
        }
    }

    /// Number of trees.
    fn len(&self) -> usize {
        self.trees.len() - 1
    }

    /// Positions of the places of some trees.
    fn positions(&self, trees: Range<usize>) -> Range<usize> {
        self.trees[trees.start].members as usize..self.trees[trees.end].members as usize
    }

    fn exits(&self, tree: usize) -> &[Exit] {
        let [from, to] = [tree, tree + 1].map(|tree| self.trees[tree].exits as usize);
        &self.exits[from..to]
    }

    /// Distances of the places of some trees by their positions, from those of their roots.
    fn spread(
        &self,
        first: usize,
        roots: &[f64],
        start: InTree,
        weight: impl Fn(&Weight) -> f32 + Copy,
        distances: &mut Vec<f64>,
    ) {
        let trees = first..first + roots.len();
        let Range { start: base, end } = self.positions(trees.clone());
        distances.resize(end - base, f64::INFINITY);
        for (tree, root) in self.trees[trees].iter().zip(roots) {
            distances[tree.members as usize - base] = *root;
        }
        let pass = |from: usize, to: usize, distances: &mut [f64]| {
            for (i, own) in (from - base..).zip(&self.members[from..to]) {
                let before = distances[own.after as usize - base];
                distances[i] = before + f64::from(weight(&own.weight));
            }
        };
        let start = start.position as usize;
        if !(base..end).contains(&start) {
            return pass(base, end, distances);
        }
        // The place where the search began follows nothing.
        pass(base, start, distances);
        distances[start - base] = 0.0;
        pass(start + 1, end, distances);
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
        // The tree where the search begins comes first; if its root is reached from elsewhere, once more.
        let (mut tree, mut distance) = (start.tree as usize, f64::INFINITY);
        loop {
            self.spread(tree, &[distance], start, weight, own);
            let base = self.trees[tree].members;
            for exit in self.exits(tree) {
                let there = own[(exit.from - base) as usize] + f64::from(weight(&exit.weight));
                let known = &mut roots[exit.to as usize];
                if there < *known {
                    *known = there;
                    // Distances are not negative: their bits order as they do.
                    open.push(Reverse((there.to_bits(), exit.to)));
                }
            }
            let taken = std::iter::from_fn(|| open.pop());
            let mut taken =
                taken.map(|Reverse((bits, tree))| (tree as usize, f64::from_bits(bits)));
            let Some(next) = taken.find(|(tree, there)| *there <= roots[*tree]) else { break };
            (tree, distance) = next;
        }
        let mut reached = Reached::of(roots, start);
        self.spread(reached.first, &reached.roots, start, weight, own);
        let finite = own.iter().copied().filter(|distance| distance.is_finite());
        reached.largest = finite.fold(0.0, f64::max);
        reached
    }

    /// The places of trees that are reached, with the distances that the last search in this room found.
    pub(super) fn found<'a>(
        &'a self,
        reached: &Reached,
        room: &'a Room,
    ) -> impl Iterator<Item = (u32, f64)> + use<'a> {
        let positions = self.positions(reached.trees());
        let places = self.members[positions].iter().map(|member| member.place);
        places.zip(room.own.iter().copied()).filter(|(_, distance)| distance.is_finite())
    }

    /// Hands over the places that are reached with their distances, found once more.
    pub(super) fn visit(
        &self,
        reached: &Reached,
        weight: impl Fn(&Weight) -> f32 + Copy,
        room: &mut Room,
        mut found: impl FnMut(u32, f64),
    ) {
        self.spread(reached.first, &reached.roots, reached.start, weight, &mut room.own);
        self.found(reached, room).for_each(|(place, distance)| found(place, distance));
    }
}

/// Distances of roots, but for the unreached ones before the first that is reached and behind the last: of a map whose parts
/// are not joined, as tiles side by side, most are. The tree where the search began is among them in any case.
pub(super) struct Reached {
    first: usize,
    roots: Vec<f64>,
    /// Where the search began.
    start: InTree,
    /// The largest distance of any place that is reached.
    pub(super) largest: f64,
}

impl Reached {
    fn of(all: &[f64], start: InTree) -> Self {
        let is_reached = |distance: &f64| distance.is_finite();
        let own = start.tree as usize;
        let first = all.iter().position(is_reached).map_or(own, |first| first.min(own));
        let last = all.iter().rposition(is_reached).map_or(own, |last| last.max(own));
        let roots = all.get(first..=last).unwrap_or_default().to_vec();
        Self { first, roots, start, largest: 0.0 }
    }

    fn trees(&self) -> Range<usize> {
        self.first..self.first + self.roots.len()
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
            ways.visit(&reached, length, &mut room, |place, distance| {
                found[place as usize] = distance;
            });
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
