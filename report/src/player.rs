//! Films in a web page: one element with its data, and a script that plays every such element.
//!
//! Nothing is loaded: a page opens from a file, without a network.

mod pack;
mod path;
mod solid;

pub use path::{PathBody, Row, path_film};
pub use solid::{MovieError, PART_COLORS, solid_film};

use super::html::escape;
use serde_json::Value;

/// The player in the order its parts build on each other.
const SCRIPT: [&str; 9] = [
    include_str!("../assets/player/film.js"),
    include_str!("../assets/player/camera.js"),
    include_str!("../assets/player/gl.js"),
    include_str!("../assets/player/shapes.js"),
    include_str!("../assets/player/paints.js"),
    include_str!("../assets/player/solid.js"),
    include_str!("../assets/player/ink.js"),
    include_str!("../assets/player/plane.js"),
    include_str!("../assets/player/player.js"),
];
/// Its look.
const STYLE: &str = include_str!("../assets/player/player.css");

/// A film ready for a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Metadata for the player.
    meta: Value,
    /// Places, speeds and contacts of all frames, compressed, as base64; of solid films only.
    data: Option<String>,
}

impl Film {
    /// The same film that begins with one of the player's looks, by the name of its button.
    #[must_use]
    pub fn beginning_as(mut self, look: &str) -> Self {
        self.meta["look"] = look.into();
        self
    }

    /// The same film with another title.
    #[must_use]
    pub fn titled(mut self, title: &str) -> Self {
        self.meta["title"] = title.into();
        self
    }

    /// The film's element, for any page that has [`style`] and, after the last film, [`script`].
    pub fn fragment(&self) -> String {
        // A closing tag within the text would end it.
        let meta = self.meta.to_string().replace("</", "<\\/");
        let data = self.data.as_ref().map(|data| {
            format!("<script type=\"text/plain\" class=\"data\">\n{data}\n</script>\n")
        });
        format!(
            "<div class=\"tribos-player\">\n\
             <noscript>This film needs scripts, which are switched off.</noscript>\n\
             <script type=\"application/json\" class=\"meta\">{meta}</script>\n{}</div>\n",
            data.unwrap_or_default()
        )
    }

    /// A page with this film alone.
    pub fn page(&self) -> String {
        let title = escape(self.meta["title"].as_str().unwrap_or_default());
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n{}\
             <style>body{{margin:0;background:#fbfbfa}}</style>\n</head>\n\
             <body class=\"film\">\n{}{}</body>\n</html>\n",
            style(),
            self.fragment(),
            script()
        )
    }
}

/// The look of all films of a page, for its head.
pub fn style() -> String {
    format!("<style>\n{STYLE}</style>\n")
}

/// The player of all films of a page, to stand behind the last of them.
pub fn script() -> String {
    let parts = SCRIPT.concat();
    format!("<script>\n(() => {{\n\"use strict\";\n{parts}}})();\n</script>\n")
}
