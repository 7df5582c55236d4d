//! The network of normal forces as lines, the far ones first.

use super::{Contact, Packing, PackingError};
use crate::figure::Color;
use crate::solid::svg_canvas::{Anchor, SvgCanvas, mixed, width};
use crate::solid::view::{Frame, Point, View};

/// Colours of compression and of tension: vermilion and blue of the line colours.
const COMPRESSION: Color = Color(213, 94, 0);
const TENSION: Color = Color(0, 114, 178);
/// Share of white in the colour of the farthest lines.
const HAZE: f64 = 0.45;
/// Width of the line of the full force, in radii of the largest sphere.
const FULL_WIDTH: f64 = 1.0;
/// Thinner lines are not seen, px.
const UNSEEN: f64 = 0.02;
/// Height of the legend, its text size, length and width of its samples, gap beside them, px.
const STRIP: f64 = 24.0;
const TEXT: f64 = 12.0;
const SAMPLE: f64 = 22.0;
const BOLD: f64 = 5.0;
const GAP: f64 = 6.0;

/// Lines, each with a force.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Network {
    lines: Vec<Line>,
    largest_radius: f64,
    full: f64,
    unit: String,
}

// A line and the force along it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Line {
    ends: [Point; 2],
    force: f64,
}

impl Network {
    /// Lines of all contacts that carry a force. A contact across a border of the periodic box is
    /// two halves, each from a centre inside the box to the point of contact.
    pub fn new(packing: &Packing, contacts: &[Contact]) -> Result<Self, PackingError> {
        packing.check(contacts)?;
        let mut lines = Vec::new();
        let carrying = contacts
            .iter()
            .filter(|contact| contact.normal_force.is_finite() && contact.normal_force != 0.0);
        for contact in carrying {
            let force = contact.normal_force;
            let start = packing.centre(contact.a);
            let Some(b) = contact.b else {
                let ends = [start, plus(start, packing.branch_to_plate(contact.a), 1.0)];
                lines.push(Line { ends, force });
                continue;
            };
            let (end, branch) = (packing.centre(b), packing.branch(contact.a, b));
            let reached = plus(start, branch, 1.0);
            if across(reached, end) {
                let share =
                    packing.radii[contact.a] / (packing.radii[contact.a] + packing.radii[b]);
                let first = [start, plus(start, branch, share)];
                let second = [plus(end, branch, share - 1.0), end];
                lines.extend([first, second].map(|ends| Line { ends, force }));
            } else {
                let ends = [start, end];
                lines.push(Line { ends, force });
            }
        }
        let full = lines
            .iter()
            .map(|line| line.force.abs())
            .fold(0.0, f64::max);
        Ok(Self {
            lines,
            largest_radius: packing.radii.iter().copied().fold(0.0, f64::max),
            full,
            unit: String::new(),
        })
    }

    /// Sets the force of the full width and its unit.
    pub fn full_force(&mut self, force: f64, unit: String) {
        if force > 0.0 && force.is_finite() {
            self.full = force;
        }
        self.unit = unit;
    }

    /// Writes the meaning of colours and width at the bottom; returns the rest of the frame.
    pub fn legend(&self, paper: &mut SvgCanvas, [left, top, right, bottom]: Frame) -> Frame {
        let full = format!(
            "width of a sphere's radius: {} {}",
            short(self.full),
            self.unit
        );
        let entries = [("compression", COMPRESSION), ("tension", TENSION)];
        let wide = |text: &str| SAMPLE + GAP + width(text, TEXT) + 2.0 * GAP;
        let colors: f64 = entries.iter().map(|(text, _)| wide(text)).sum();
        let y = bottom - 1.5 * STRIP;
        let mut x = (left + right - colors) / 2.0;
        for (text, color) in entries {
            paper.line(&[(x, y), (x + SAMPLE, y)], color, BOLD);
            paper.text((x + SAMPLE + GAP, y), text, TEXT, Anchor::Start);
            x += wide(text);
        }
        let middle = ((left + right) / 2.0, bottom - STRIP / 2.0);
        paper.text(middle, full.trim_end(), TEXT, Anchor::Middle);
        [left, top, right, bottom - 2.0 * STRIP]
    }

    /// Draws the lines; far ones are paler.
    pub fn draw(&self, paper: &mut SvgCanvas, view: &View) {
        let near = |line: &Line| view.nearness(plus(line.ends[0], line.ends[1], 1.0));
        let mut order: Vec<&Line> = self.lines.iter().collect();
        order.sort_by(|a, b| near(a).total_cmp(&near(b)));
        let farthest = order.first().map_or(0.0, |line| near(line));
        let nearest = order.last().map_or(0.0, |line| near(line));
        let full = FULL_WIDTH * self.largest_radius * view.scale();
        for line in order {
            let wide = full * line.force.abs() / self.full;
            if wide < UNSEEN {
                continue;
            }
            let depth = (nearest - near(line)) / (nearest - farthest).max(f64::MIN_POSITIVE);
            let color = if line.force > 0.0 {
                COMPRESSION
            } else {
                TENSION
            };
            let color = mixed(color, Color(255, 255, 255), HAZE * depth);
            paper.line(&line.ends.map(|end| view.place(end)), color, wide);
        }
    }
}

// Whether the nearest image of a centre is another than the one in the box.
fn across(reached: Point, end: Point) -> bool {
    // Images stand a whole side apart, rounding errors far less.
    const ROUNDING: f64 = 1e-6;
    let apart = |axis: usize| (reached[axis] - end[axis]).abs();
    let size = reached
        .iter()
        .chain(&end)
        .fold(0.0_f64, |size, part| size.max(part.abs()));
    apart(0).max(apart(1)) > ROUNDING * size
}

// A point moved by a multiple of a vector.
fn plus(point: Point, by: Point, times: f64) -> Point {
    std::array::from_fn(|axis| point[axis] + times * by[axis])
}

// Three significant digits.
fn short(value: f64) -> String {
    let places = (2.0 - value.abs().max(f64::MIN_POSITIVE).log10().floor()).clamp(0.0, 3.0);
    if value == 0.0 || (1e-2..1e5).contains(&value) {
        let text = format!("{value:.0$}", places as usize);
        return text.parse().map_or(text, |number: f64| number.to_string());
    }
    format!("{value:.2e}")
}
