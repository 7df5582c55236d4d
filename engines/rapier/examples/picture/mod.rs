//! Paths seen from above as an SVG picture, where one is asked for.

// No example needs all of it.
#![allow(dead_code)]

use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

/// A rectangle of the floor with what moved on it; x to the right, z down, in metres.
pub struct Picture {
    /// Two opposite corners.
    corners: [[f32; 2]; 2],
    body: String,
}

/// Colours of paths, for white paper and colour-blind eyes.
pub const COLOURS: [&str; 6] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00",
];

impl Picture {
    pub fn new(corners: [[f32; 2]; 2]) -> Self {
        let body = String::new();
        Self { corners, body }
    }

    /// The thickness of lines.
    fn line(&self) -> f32 {
        let [[left, top], [right, bottom]] = self.corners;
        (right - left).max(bottom - top) / 400.0
    }

    pub fn path(&mut self, colour: &str, points: &[[f32; 2]]) {
        let width = self.line();
        let points: Vec<_> = points
            .iter()
            .map(|[x, z]| format!("{x:.4},{z:.4}"))
            .collect();
        let points = points.join(" ");
        let _ = writeln!(
            self.body,
            "<polyline fill='none' stroke='{colour}' stroke-width='{width}' points='{points}'/>"
        );
    }

    pub fn circle(&mut self, colour: &str, [x, z]: [f32; 2], radius: f32) {
        let width = self.line();
        let _ = writeln!(
            self.body,
            "<circle cx='{x:.4}' cy='{z:.4}' r='{radius}' fill='none' stroke='{colour}' stroke-width='{width}'/>"
        );
    }

    pub fn text(&mut self, colour: &str, [x, z]: [f32; 2], text: &str) {
        let size = 10.0 * self.line();
        let _ = writeln!(
            self.body,
            "<text x='{x}' y='{z}' font-family='sans-serif' font-size='{size}' fill='{colour}'>{text}</text>"
        );
    }

    /// Writes the picture where the command line asks for it.
    pub fn save_where_asked(&self) -> Result<(), Box<dyn Error>> {
        let Some(path) = asked_for()? else {
            return Ok(());
        };
        let [[left, top], [right, bottom]] = self.corners;
        let [width, height] = [right - left, bottom - top];
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='{:.0}' \
             viewBox='{left} {top} {width} {height}'>\n\
             <rect x='{left}' y='{top}' width='{width}' height='{height}' fill='white'/>\n{}</svg>\n",
            900.0 * height / width,
            self.body
        );
        std::fs::write(&path, svg).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("\npaths: {}", path.display());
        Ok(())
    }
}

/// The only argument: where the picture goes.
pub fn asked_for() -> Result<Option<PathBuf>, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = match arguments.next() {
        Some(help) if ["-h", "--help"].contains(&help.as_str()) => {
            println!(
                "usage: [PICTURE.svg]\nPrints a table; draws the paths where a file is given."
            );
            std::process::exit(0)
        }
        Some(flag) if flag.starts_with('-') => {
            return Err(
                format!("unknown flag {flag}; the only argument is a picture's path").into(),
            );
        }
        path => path.map(PathBuf::from),
    };
    match arguments.next() {
        Some(more) => Err(format!("one picture at most, what is {more}?").into()),
        None => Ok(path),
    }
}
