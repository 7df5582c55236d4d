//! Which axes are periodic, `p,p,f`.

use std::str::FromStr;

/// Periodic or open along x, y and z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Boundary {
    pub is_periodic: [bool; 3],
}

impl FromStr for Boundary {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let flag = |word: &str| match word.trim() {
            "p" => Some(true),
            "f" => Some(false),
            _ => None,
        };
        let flags: Option<Vec<bool>> = text.split(',').map(flag).collect();
        let is_periodic = flags.and_then(|flags| flags.try_into().ok());
        is_periodic
            .map(|is_periodic| Self { is_periodic })
            .ok_or_else(|| "give p (periodic) or f (open) for x, y and z, such as p,p,f".into())
    }
}
