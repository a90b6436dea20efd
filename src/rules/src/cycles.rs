//! Which of what is named in pairs leads back to itself.

use std::collections::HashMap;

/// Not visited yet, or of no component yet.
const NONE: usize = usize::MAX;

/// Of each pair, from and to, whether a way along pairs leads from the second back to the first. By Tarjan's strong components, with a stack of its own: each
/// pair is followed once.
pub(crate) fn on_cycles(pairs: &[(&str, &str)]) -> Vec<bool> {
    let mut numbers: HashMap<&str, usize> = HashMap::new();
    let mut number = |name| {
        let next = numbers.len();
        *numbers.entry(name).or_insert(next)
    };
    let pairs: Vec<[usize; 2]> =
        pairs.iter().map(|(from, to)| [*from, *to].map(&mut number)).collect();
    let components = components(numbers.len(), &pairs);
    pairs.iter().map(|[from, to]| components.get(*from) == components.get(*to)).collect()
}

/// The strong component of each of so many nodes.
fn components(nodes: usize, pairs: &[[usize; 2]]) -> Vec<usize> {
    let mut next: Vec<Vec<usize>> = vec![Vec::new(); nodes];
    for [from, to] in pairs {
        if let Some(next) = next.get_mut(*from) {
            next.push(*to);
        }
    }
    let (mut index, mut low, mut component) =
        (vec![NONE; nodes], vec![NONE; nodes], vec![NONE; nodes]);
    let (mut visited, mut open, mut path) = (0, Vec::new(), Vec::new());
    for root in 0..nodes {
        if index[root] == NONE {
            path.push((root, 0));
        }
        while let Some((node, followed)) = path.pop() {
            if followed == 0 {
                (index[node], low[node]) = (visited, visited);
                visited += 1;
                open.push(node);
            }
            if let Some(to) = next[node].get(followed).copied() {
                path.push((node, followed + 1));
                if index[to] == NONE {
                    path.push((to, 0));
                } else if component[to] == NONE {
                    low[node] = low[node].min(index[to]);
                }
                continue;
            }
            if let Some((before, _)) = path.last() {
                low[*before] = low[*before].min(low[node]);
            }
            if low[node] == index[node] {
                while let Some(member) = open.pop() {
                    component[member] = node;
                    if member == node {
                        break;
                    }
                }
            }
        }
    }
    component
}

#[cfg(test)]
mod tests {
    use super::on_cycles;
    use std::collections::BTreeSet;

    /// From each pair all ways are followed.
    fn looked_for(pairs: &[(&str, &str)]) -> Vec<bool> {
        let leads_back = |(from, to): &(&str, &str)| {
            let (mut open, mut seen) = (vec![*to], BTreeSet::new());
            while let Some(name) = open.pop() {
                if name == *from {
                    return true;
                }
                if seen.insert(name) {
                    open.extend(pairs.iter().filter(|(of, _)| *of == name).map(|(_, to)| to));
                }
            }
            false
        };
        pairs.iter().map(leads_back).collect()
    }

    /// Of all graphs of three and of some of five nodes.
    #[test]
    fn pairs_on_cycles_are_those_that_a_search_finds() {
        const NAMES: [&str; 5] = ["a", "b", "c", "d", "e"];
        let all = |count: usize| -> Vec<(&str, &str)> {
            let names = &NAMES[..count];
            names.iter().flat_map(|from| names.iter().map(move |to| (*from, *to))).collect()
        };
        let check = |all: &[(&'static str, &'static str)], bits: u64| {
            let is_in = |i: usize| bits & (1 << i) != 0;
            let pairs: Vec<_> =
                all.iter().enumerate().filter(|(i, _)| is_in(*i)).map(|(_, pair)| *pair).collect();
            assert_eq!(on_cycles(&pairs), looked_for(&pairs), "{pairs:?}");
        };
        (0..1 << 9).for_each(|bits| check(&all(3), bits));
        let mut bits = 1_u64;
        for _ in 0..2000 {
            // A generator of random numbers: multiplier and increment of Knuth's MMIX.
            bits = bits
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            check(&all(5), (bits >> 20) & (bits >> 33) & ((1 << 25) - 1));
        }
    }
}
