//! A limit surface in a web page, to be turned and read.
//!
//! Nothing is loaded: the page opens from a file, without a network.

use super::html::escape;
use super::solid::{ramp, svg_canvas::hex};
use serde_json::json;

const STYLE: &str = include_str!("../assets/limit_surface/surface.css");
const SCRIPT: [&str; 2] = [
    include_str!("../assets/player/camera.js"),
    include_str!("../assets/limit_surface/surface.js"),
];
/// Colours from sliding to spinning.
const SHADES: usize = 64;

/// A limit surface as a grid of points, and pushes beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitSurfacePage {
    /// Heading and title of the window.
    pub title: String,
    /// Largest force in N and largest torque in N m.
    pub limits: [f64; 2],
    /// Rows of equal share of spin, from −1 to 1; each point has force x and y, torque, and the motion there:
    /// velocity x and y, and spin. Directions run counterclockwise along a row.
    pub grid: Vec<Vec<[f64; 6]>>,
    /// Further wrenches: force x, force y, torque.
    pub pushes: Vec<[f64; 3]>,
}

impl LimitSurfacePage {
    /// The page.
    pub fn html(&self) -> String {
        let shade = |at: usize| hex(ramp::color(at as f64 / (SHADES - 1) as f64));
        let colors: Vec<String> = (0..SHADES).map(shade).collect();
        let [force, torque] = self.limits;
        let data = json!({
            "limits": { "force": force, "torque": torque },
            "rows": self.grid.len(),
            "columns": self.grid.first().map_or(0, Vec::len),
            "points": self.grid.concat().iter().map(|point| point.map(short)).collect::<Vec<_>>(),
            "pushes": self.pushes.iter().map(|push| push.map(short)).collect::<Vec<_>>(),
            "ramp": colors,
        });
        let title = escape(&self.title);
        let gradient = colors.join(",");
        let pushes = if self.pushes.is_empty() {
            String::new()
        } else {
            " <span class=\"push\">●</span> given pushes, pale behind the surface.".to_owned()
        };
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n{STYLE}</style>\n\
             </head>\n<body>\n<main>\n<h1>{title}</h1>\n\
             <p>Friction holds every push inside of the surface. A push on it moves the body along the \
             normal there.</p>\n\
             <div class=\"stage\" tabindex=\"0\" role=\"img\" aria-label=\"{title}\"><canvas></canvas></div>\n\
             <p class=\"read\" aria-live=\"polite\">Point at the surface to read a push and the motion that it causes.</p>\n\
             <p>The body slides <span class=\"ramp\" style=\"background:linear-gradient(90deg,{gradient})\"></span> \
             it spins.{pushes}</p>\n\
             <p class=\"help\">Drag or arrow keys: turn. Wheel or + and −: zoom. 0: back.</p>\n\
             <noscript>The picture needs scripts, which are switched off.</noscript>\n</main>\n\
             <script type=\"application/json\" class=\"data\">{data}</script>\n\
             <script>\n(() => {{\n\"use strict\";\n{script}}})();\n</script>\n</body>\n</html>\n",
            data = data.to_string().replace("</", "<\\/"),
            script = SCRIPT.concat(),
        )
    }
}

/// As many digits as a picture needs.
fn short(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}
