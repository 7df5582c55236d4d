//! Elimination order, fronts and costs of a sparse matrix with a nearly symmetric pattern.
//!
//! Nodes are ordered by approximate minimum degree (Amestoy, Davis and Duff, ACM TOMS 30 (2004) 381). Nodes
//! that follow each other and have nearly the same neighbours are eliminated together, as one dense *front*
//! (Duff and Reid, ACM TOMS 9 (1983) 302). All of it depends on the pattern alone, and is done once.

use super::blocks::Blocks;

/// One dense front: the unknowns that it eliminates and those that it updates.
#[derive(Clone, Debug, Default)]
pub(super) struct Front {
    /// Nodes: first those eliminated here, in their order, then the others.
    nodes: Vec<usize>,
    /// Number of nodes eliminated here.
    eliminated: usize,
    /// The unknowns of all nodes of the front.
    pub unknowns: Vec<usize>,
    /// Number of unknowns eliminated here.
    pub pivots: usize,
    /// Fronts whose updates are added to this one.
    pub children: Vec<usize>,
    /// Place of each updated unknown in the parent's front.
    pub in_parent: Vec<usize>,
    /// Blocks of the matrix that enter here: number, and place of the first row and column.
    pub entries: Vec<(usize, usize, usize)>,
}

/// Everything about a factorisation that the pattern decides.
#[derive(Clone, Debug, Default)]
pub(super) struct Symbolic {
    /// Fronts, children before their parents.
    pub fronts: Vec<Front>,
    /// Multiplications of a factorisation.
    pub cost: f64,
}

/// Two fronts are merged if together they eliminate at most so many unknowns …
const SMALL: usize = 16;
/// … or if at most this part of the entries becomes zeros that are stored.
const WASTE: f64 = 0.1;

impl Symbolic {
    pub fn new(matrix: &Blocks) -> Self {
        let neighbours = neighbours(matrix);
        let order = postorder(&neighbours, &minimum_degree(&neighbours));
        let mut fronts = fronts(&neighbours, &order, &matrix.first);
        place(&mut fronts, matrix, &order);
        let cost = fronts.iter().map(cost).sum();
        Self { fronts, cost }
    }
}

/// Multiplications of a front: Σ (n − k)² over its pivots k of n unknowns.
fn cost(front: &Front) -> f64 {
    let (size, pivots) = (front.unknowns.len() as f64, front.pivots as f64);
    let rest = size - pivots;
    (size * size * size - rest * rest * rest) / 3.0
}

/// Nodes that share a block with each node, in either direction, without the node itself.
fn neighbours(matrix: &Blocks) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new(); matrix.nodes()];
    for row in 0..matrix.nodes() {
        for &column in &matrix.columns[matrix.row(row)] {
            if column != row {
                all[row].push(column);
                all[column].push(row);
            }
        }
    }
    for list in &mut all {
        list.sort_unstable();
        list.dedup();
    }
    all
}

/// Nodes in the order of approximate minimum degree.
fn minimum_degree(neighbours: &[Vec<usize>]) -> Vec<usize> {
    let nodes = neighbours.len();
    let mut starts = vec![0_usize];
    let mut columns = Vec::new();
    for (node, list) in neighbours.iter().enumerate() {
        columns.extend_from_slice(list);
        // The crate expects a diagonal.
        columns.push(node);
        starts.push(columns.len());
    }
    match amd::order(nodes, &starts, &columns, &amd::Control::default()) {
        Ok((order, _, _)) => order,
        // Cannot happen with a valid pattern; any order is right.
        Err(_) => (0..nodes).collect(),
    }
}

/// Parent of each place of an order in the elimination tree (Liu, SIAM J. Matrix Anal. Appl. 11 (1990) 134).
fn tree(neighbours: &[Vec<usize>], order: &[usize]) -> Vec<Option<usize>> {
    let place = inverse(order);
    let mut parent = vec![None; order.len()];
    let mut ancestor: Vec<Option<usize>> = vec![None; order.len()];
    for (at, &node) in order.iter().enumerate() {
        for &other in &neighbours[node] {
            let mut below = place[other];
            // Climb to the root of what has been eliminated, and shorten the path.
            while below < at {
                let next = ancestor[below].replace(at);
                match next {
                    None => {
                        parent[below] = Some(at);
                        break;
                    }
                    Some(next) => below = next,
                }
            }
        }
    }
    parent
}

fn inverse(order: &[usize]) -> Vec<usize> {
    let mut place = vec![0; order.len()];
    for (at, &node) in order.iter().enumerate() {
        place[node] = at;
    }
    place
}

/// The same elimination with every subtree contiguous, the child with most descendants last.
fn postorder(neighbours: &[Vec<usize>], order: &[usize]) -> Vec<usize> {
    let parent = tree(neighbours, order);
    let mut weight = vec![1_usize; order.len()];
    let mut children = vec![Vec::new(); order.len()];
    let mut roots = Vec::new();
    for at in 0..order.len() {
        match parent[at] {
            Some(parent) => {
                weight[parent] += weight[at];
                children[parent].push(at);
            }
            None => roots.push(at),
        }
    }
    for list in &mut children {
        list.sort_by_key(|&child| weight[child]);
    }
    let mut sorted = Vec::with_capacity(order.len());
    // Each entry: a place, and whether its children have been visited.
    let mut stack: Vec<_> = roots.into_iter().rev().map(|root| (root, false)).collect();
    while let Some((at, seen)) = stack.pop() {
        if seen {
            sorted.push(order[at]);
        } else {
            stack.push((at, true));
            stack.extend(children[at].iter().rev().map(|&child| (child, false)));
        }
    }
    sorted
}

/// Fronts of an order whose subtrees are contiguous.
fn fronts(neighbours: &[Vec<usize>], order: &[usize], first: &[usize]) -> Vec<Front> {
    let place = inverse(order);
    let width = |nodes: &[usize]| -> usize {
        nodes
            .iter()
            .map(|&at| first[order[at] + 1] - first[order[at]])
            .sum()
    };
    // For each front, by places: what it eliminates and what it updates.
    let mut open: Vec<(Vec<usize>, Vec<usize>, Vec<usize>)> = Vec::new();
    let mut done: Vec<Front> = Vec::new();
    let parent = tree(neighbours, order);
    let mut waiting: Vec<Vec<usize>> = vec![Vec::new(); order.len()];
    for at in 0..order.len() {
        // Structure of the column: its own later neighbours and what its children update.
        let mut rest: Vec<usize> = neighbours[order[at]]
            .iter()
            .map(|&node| place[node])
            .filter(|&other| other > at)
            .collect();
        let children = std::mem::take(&mut waiting[at]);
        for &child in &children {
            rest.extend(open[child].1.iter().copied().filter(|&other| other > at));
        }
        rest.sort_unstable();
        rest.dedup();
        // The last child ends right before this node; it takes the node in if little is wasted.
        let last = children.last().copied();
        let joined = last.filter(|&child| {
            let (pivots, old, _) = &open[child];
            let (pivots, own) = (width(pivots), width(&[at]));
            let (old, new) = (width(old), own + width(&rest));
            let wasted = (pivots * (new - old)) as f64;
            pivots + own <= SMALL || wasted <= WASTE * ((pivots + own) * new) as f64
        });
        let front = match joined {
            Some(child) => {
                open[child].0.push(at);
                open[child].1 = rest;
                open[child]
                    .2
                    .extend(children.iter().copied().filter(|&other| other != child));
                child
            }
            None => {
                open.push((vec![at], rest, children));
                open.len() - 1
            }
        };
        if let Some(parent) = parent[at] {
            waiting[parent].push(front);
        }
    }
    // A front that grew stands where its last node was eliminated.
    let mut sequence: Vec<usize> = (0..open.len()).collect();
    sequence.sort_by_key(|&front| open[front].0.last().copied());
    let number = inverse(&sequence);
    for &front in &sequence {
        let (pivots, rest, children) = &open[front];
        let nodes: Vec<usize> = pivots.iter().chain(rest).map(|&at| order[at]).collect();
        done.push(Front {
            eliminated: pivots.len(),
            unknowns: nodes
                .iter()
                .flat_map(|&node| first[node]..first[node + 1])
                .collect(),
            pivots: width(pivots),
            children: children.iter().map(|&child| number[child]).collect(),
            nodes,
            ..Front::default()
        });
    }
    done
}

/// Finds where blocks and updates enter the fronts.
fn place(fronts: &mut [Front], matrix: &Blocks, order: &[usize]) {
    let first = &matrix.first;
    let position = inverse(order);
    // Place of each node in the front at hand, and of each front's blocks.
    let mut offset = vec![0; order.len()];
    let mut home = vec![0; order.len()];
    for (number, front) in fronts.iter().enumerate() {
        for &node in &front.nodes[..front.eliminated] {
            home[node] = number;
        }
    }
    let mut entries = vec![Vec::new(); fronts.len()];
    for row in 0..matrix.nodes() {
        for block in matrix.row(row) {
            let column = matrix.columns[block];
            let earlier = if position[row] < position[column] {
                row
            } else {
                column
            };
            entries[home[earlier]].push((block, row, column));
        }
    }
    for number in 0..fronts.len() {
        let mut at = 0;
        for &node in &fronts[number].nodes {
            offset[node] = at;
            at += first[node + 1] - first[node];
        }
        fronts[number].entries = entries[number]
            .iter()
            .map(|&(block, row, column)| (block, offset[row], offset[column]))
            .collect();
        for child in fronts[number].children.clone() {
            let child = &mut fronts[child];
            child.in_parent = child.nodes[child.eliminated..]
                .iter()
                .flat_map(|&node| offset[node]..offset[node] + first[node + 1] - first[node])
                .collect();
        }
    }
}
