//! The graph that all motor vehicles together may use, and distances over it from one place to all.
//!
//! Most places are entered from one other alone: ways through a junction, each from its incoming lane, and later sections of a
//! lane. Such a place follows the other: its distance is the other's and the way between. So only places where ways join are
//! searched. A search backwards has places of its own that follow.

use super::motor_edges::{Edge, Places, Sparse, Weight, edges};
use mapd_archive::{NONE, Rows, prefetch};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// A place of a tree. Its position is its rank among the places of all trees.
struct Member {
    place: u32,
    /// Position of the place that it follows; of a root its own.
    after: u32,
    /// The way between; of a root none, at no distance.
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
    /// Trees whose roots are reached, the nearest first.
    open: BinaryHeap<Reverse<OpenTree>>,
    /// Distances by position; those of places that were not reached are infinite.
    distances: Vec<f64>,
    /// Where places may have been reached.
    used: Range<usize>,
}

impl Room {
    /// Forgets all distances, of so many positions.
    fn clear(&mut self, positions: usize) {
        if let Some(used) = self.distances.get_mut(self.used.clone()) {
            used.fill(f64::INFINITY);
        }
        self.distances.resize(positions, f64::INFINITY);
        self.used = 0..0;
    }
}

/// A tree whose root is reached, by the root's distance then: one number, which is compared at once.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct OpenTree(u128);

impl OpenTree {
    /// Distances are not negative: their bits order as they do.
    fn new(tree: u32, distance: f64) -> Self {
        Self(u128::from(distance.to_bits()) << u32::BITS | u128::from(tree))
    }

    fn tree(self) -> usize {
        self.0 as u32 as usize
    }

    fn distance(self) -> f64 {
        f64::from_bits((self.0 >> u32::BITS) as u64)
    }
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

    /// Positions of the places of some trees.
    fn positions(&self, trees: Range<usize>) -> Range<usize> {
        self.trees[trees.start].members as usize..self.trees[trees.end].members as usize
    }

    fn exits(&self, tree: usize) -> &[Exit] {
        let [from, to] = [tree, tree + 1].map(|tree| self.trees[tree].exits as usize);
        &self.exits[from..to]
    }

    /// Passes on the distances of roots to all places at some positions. The place where the search began has its own.
    fn spread(
        &self,
        Range { start: first, end }: Range<usize>,
        start: InTree,
        weight: impl Fn(&Weight) -> f32 + Copy,
        distances: &mut [f64],
    ) {
        let mut pass = |from: usize, to: usize| {
            for (i, own) in (from..).zip(&self.members[from..to]) {
                // A root follows itself, at no distance.
                distances[i] = distances[own.after as usize] + f64::from(weight(&own.weight));
            }
        };
        let start = start.position as usize;
        if (first..end).contains(&start) {
            pass(first, start);
            pass(start + 1, end);
        } else {
            pass(first, end);
        }
    }

    /// Distances from a place to all (Dijkstra).
    pub(super) fn distances(
        &self,
        from: u32,
        weight: impl Fn(&Weight) -> f32 + Copy,
        room: &mut Room,
    ) -> Reached {
        let start = self.in_trees[from as usize];
        room.clear(self.members.len());
        let Room { open, distances, used } = room;
        distances[start.position as usize] = 0.0;
        // The tree where the search begins comes first; if its root is reached from elsewhere, once more.
        let mut tree = start.tree as usize;
        let (mut first, mut last) = (tree, tree);
        loop {
            (first, last) = (first.min(tree), last.max(tree));
            self.spread(self.positions(tree..tree + 1), start, weight, distances);
            for exit in self.exits(tree) {
                let there = distances[exit.from as usize] + f64::from(weight(&exit.weight));
                let known = &mut distances[self.trees[exit.to as usize].members as usize];
                if there < *known {
                    *known = there;
                    // It is read when its turn comes, and by then it is at hand.
                    let to = self.trees[exit.to as usize];
                    self.members.get(to.members as usize).into_iter().for_each(prefetch);
                    self.exits.get(to.exits as usize).into_iter().for_each(prefetch);
                    open.push(Reverse(OpenTree::new(exit.to, there)));
                }
            }
            let root = |tree: usize| distances[self.trees[tree].members as usize];
            let mut taken = std::iter::from_fn(|| open.pop()).map(|Reverse(open)| open);
            let Some(next) = taken.find(|open| open.distance() <= root(open.tree())) else { break };
            tree = next.tree();
        }
        *used = self.positions(first..last + 1);
        let roots = self.trees[first..=last].iter();
        let roots = roots.map(|tree| distances[tree.members as usize]).collect();
        let finite =
            distances[used.clone()].iter().copied().filter(|distance| distance.is_finite());
        Reached { first, roots, start, largest: finite.fold(0.0, f64::max) }
    }

    /// The places that are reached, with the distances that the last search in this room found.
    pub(super) fn found<'a>(
        &'a self,
        room: &'a Room,
    ) -> impl Iterator<Item = (u32, f64)> + use<'a> {
        let places = self.members[room.used.clone()].iter().map(|member| member.place);
        let distances = room.distances[room.used.clone()].iter().copied();
        places.zip(distances).filter(|(_, distance)| distance.is_finite())
    }

    /// Hands over the places that are reached with their distances, found once more.
    pub(super) fn visit(
        &self,
        reached: &Reached,
        weight: impl Fn(&Weight) -> f32 + Copy,
        room: &mut Room,
        mut found: impl FnMut(u32, f64),
    ) {
        room.clear(self.members.len());
        let trees = reached.first..reached.first + reached.roots.len();
        room.used = self.positions(trees.clone());
        for (tree, root) in self.trees[trees].iter().zip(&reached.roots) {
            room.distances[tree.members as usize] = *root;
        }
        room.distances[reached.start.position as usize] = 0.0;
        self.spread(room.used.clone(), reached.start, weight, &mut room.distances);
        self.found(room).for_each(|(place, distance)| found(place, distance));
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
