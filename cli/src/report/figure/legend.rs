//! The legend: which line belongs to which series.

use super::curves;
use super::font;
use super::scene::{Anchor, Color, Point, Rect, Scene, snapped};
use super::series::Series;

// Text size, line height, sample length and gaps in pixels.
const SIZE: f64 = 13.0;
const LINE: f64 = 18.0;
const SAMPLE: f64 = 28.0;
const GAP: f64 = 7.0;
const PAD: f64 = 8.0;

const TEXT: Color = Color(40, 40, 40);

/// Where the legend stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// Outside, at the right of the plot.
    #[default]
    Right,
    /// Outside, in rows under the plot.
    Below,
    /// Inside, in the upper left corner.
    TopLeft,
    /// Inside, in the upper right corner.
    TopRight,
    /// Inside, in the lower left corner.
    BottomLeft,
    /// Inside, in the lower right corner.
    BottomRight,
    /// No legend.
    Hidden,
}

// One legend entry at its place inside the block.
#[derive(Debug, Clone, PartialEq)]
struct Entry {
    at: Point,
    lines: Vec<String>,
    index: usize,
}

/// A legend laid out from its own upper left corner.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Block {
    entries: Vec<Entry>,
    pub width: f64,
    pub height: f64,
}

impl Block {
    /// Entries under each other, texts wrapped to a width.
    pub fn column(series: &[Series], limit: f64) -> Self {
        let mut block = Self::default();
        let room = (limit - SAMPLE - GAP - 2.0 * PAD).max(40.0);
        for (index, label) in labelled(series) {
            let lines = font::wrap(label, SIZE, room);
            let at = (PAD, PAD + block.height);
            block.width = block.width.max(SAMPLE + GAP + widest(&lines));
            block.height += LINE * lines.len() as f64 + 3.0;
            block.entries.push(Entry { at, lines, index });
        }
        block.padded()
    }

    /// Entries side by side in as many rows as needed.
    pub fn rows(series: &[Series], limit: f64) -> Self {
        let mut block = Self::default();
        let (mut x, mut y, mut row) = (0.0, 0.0, 0.0_f64);
        for (index, label) in labelled(series) {
            let lines = font::wrap(label, SIZE, (limit - SAMPLE - GAP - 2.0 * PAD).max(40.0));
            let width = SAMPLE + GAP + widest(&lines);
            if x > 0.0 && x + width > limit - 2.0 * PAD {
                (x, y, row) = (0.0, y + row, 0.0);
            }
            row = row.max(LINE * lines.len() as f64);
            let at = (PAD + x, PAD + y);
            block.entries.push(Entry { at, lines, index });
            block.width = block.width.max(x + width);
            block.height = y + row;
            x += width + 2.5 * GAP;
        }
        block.padded()
    }

    /// Whether there is nothing to show.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Box of the legend in a corner of the plot.
    pub fn corner(&self, legend: Legend, plot: &Rect) -> Rect {
        let inset = 8.0;
        let right = matches!(legend, Legend::TopRight | Legend::BottomRight);
        let bottom = matches!(legend, Legend::BottomLeft | Legend::BottomRight);
        let left = if right {
            plot.right - inset - self.width
        } else {
            plot.left + inset
        };
        let top = if bottom {
            plot.bottom - inset - self.height
        } else {
            plot.top + inset
        };
        let (left, top) = (snapped(left), snapped(top));
        let (right, bottom) = (left + self.width, top + self.height);
        Rect::new(left, top, snapped(right), snapped(bottom))
    }

    /// Draws the entries from an upper left corner on.
    pub fn draw(&self, (left, top): Point, series: &[Series], scene: &mut Scene) {
        for entry in &self.entries {
            let Some(shown) = series.get(entry.index) else {
                continue;
            };
            let (x, y) = (left + entry.at.0, top + entry.at.1);
            sample((x, y + LINE / 2.0), shown, entry.index, scene);
            for (row, line) in entry.lines.iter().enumerate() {
                let baseline = y + LINE * row as f64 + LINE / 2.0 + 0.36 * SIZE;
                let at = (x + SAMPLE + GAP, baseline);
                scene.text(line, at, SIZE, TEXT, Anchor::Start);
            }
        }
    }

    // Adds the border around the entries.
    fn padded(mut self) -> Self {
        if self.is_empty() {
            return Self::default();
        }
        self.width += 2.0 * PAD;
        self.height += 2.0 * PAD;
        self
    }
}

// Series that have a label, with their place.
fn labelled(series: &[Series]) -> impl Iterator<Item = (usize, &str)> {
    let labels = series.iter().map(|series| series.label.trim());
    labels.enumerate().filter(|(_, label)| !label.is_empty())
}

// Width of the longest line.
fn widest(lines: &[String]) -> f64 {
    let widths = lines.iter().map(|line| font::width(line, SIZE));
    widths.fold(0.0, f64::max)
}

// A short piece of the line and its marker.
fn sample((x, y): Point, series: &Series, index: usize, scene: &mut Scene) {
    let color = series.shown_color(index);
    if series.style.has_line() {
        curves::line(&[(x, y), (x + SAMPLE, y)], series.style, color, scene);
    }
    if series.style.has_markers() {
        curves::marker((x + SAMPLE / 2.0, y), index, color, scene);
    }
}
