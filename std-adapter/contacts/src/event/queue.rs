//! The events to come, earliest first; events of the past are dropped when they come up.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The partner of an event that is no collision: the sphere leaves its cell.
pub(super) const CELL: u32 = u32::MAX;
/// The queue is swept when it has this many events a sphere, or twice what the last sweep left.
const USUAL: usize = 16;

/// Two spheres collide, or one leaves its cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Event {
    pub time: f64,
    pub a: u32,
    /// The other sphere, or [`CELL`].
    pub b: u32,
    /// Collisions that each had when the event was predicted.
    pub counts: [u32; 2],
}

impl Eq for Event {}

impl Ord for Event {
    /// The earliest is the greatest; spheres decide between equal times, so that the order is total.
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .time
            .total_cmp(&self.time)
            .then(other.a.cmp(&self.a))
            .then(other.b.cmp(&self.b))
    }
}

impl PartialOrd for Event {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A binary heap with lazy deletion.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    heap: BinaryHeap<Event>,
    /// Length at which it is swept.
    full: usize,
    least: usize,
}

impl Queue {
    pub fn new(spheres: usize) -> Self {
        let least = USUAL * spheres.max(1);
        Self {
            heap: BinaryHeap::with_capacity(least),
            full: least,
            least,
        }
    }

    pub fn push(&mut self, event: Event) {
        self.heap.push(event);
    }

    pub fn first(&self) -> Option<&Event> {
        self.heap.peek()
    }

    pub fn pop(&mut self) -> Option<Event> {
        self.heap.pop()
    }

    /// Drops the events of the past if there are many.
    pub fn sweep(&mut self, is_live: impl Fn(&Event) -> bool) {
        if self.heap.len() > self.full {
            self.heap.retain(is_live);
            self.full = self.least.max(2 * self.heap.len());
        }
    }
}
