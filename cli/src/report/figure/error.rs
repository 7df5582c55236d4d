//! What can go wrong while drawing a figure.

/// Reasons a figure cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum FigureError {
    /// A given axis range is empty, not finite, or not positive on a log axis.
    #[error("axis \"{axis}\" cannot span {low} to {high}")]
    Range {
        /// Label of the axis.
        axis: String,
        /// Lower end asked for.
        low: f64,
        /// Upper end asked for.
        high: f64,
    },
    /// The canvas is too small to hold a plot or too large to draw.
    #[error("a figure of {width} x {height} pixels cannot be drawn")]
    Size {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
    /// The embedded font was not accepted.
    #[error("the embedded font cannot be read")]
    Font,
    /// The drawing backend failed.
    #[error("drawing failed: {0}")]
    Draw(String),
    /// The PNG could not be encoded.
    #[error("PNG encoding failed: {0}")]
    Png(#[from] png::EncodingError),
}
