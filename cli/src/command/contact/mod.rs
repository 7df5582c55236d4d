//! `tribos contact`: contact problems of other programs, solved; methods compared.

mod compare;
mod folder;
mod method;
mod output;
mod plot;
mod profile;
mod solve;
mod solved;

use crate::failure::Failure;

/// Solve contact problems of many bodies, as other programs hand them over: which contacts stick, slip or open,
/// and under which impulses.
///
/// Files are FCLib's HDF5 or text of Siconos; their contents tell which. A problem is either W and q between impulses,
/// u = W r + q, or M, H, f and w between bodies, M v = H r + f and u = H^T v + w; contacts have 2, 3 or 5 components
/// (sliding, and rolling), in HDF5 also torsion and cohesion.
///
/// A solution has both residuals at or below the tolerance: the natural map r - P(r - u~) over the largest of |q|, |r|
/// and |u|, and the same in scaled unknowns; and normal speeds right to a hundred times it. A problem
/// that is not solved leaves its best impulses, and the exit code is 4; where no impulses can solve it, `insoluble` and
/// its `certificate` in summary.json say so.
#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
#[command(after_long_help = EXAMPLES)]
pub struct Arguments {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    solve: solve::Solve,
}

/// What else can be done with problems.
#[derive(Debug, clap::Subcommand)]
enum Action {
    /// Several methods over several problems: times, and their performance profile.
    Compare(compare::Compare),
}

const EXAMPLES: &str = "\
Examples:
  tribos contact rover.dat --out out/rover
  tribos contact rover.dat spheres.dat --tolerance 1e-10 --out out/contacts
  tribos contact spheres.dat --method interior
  tribos contact compare rover.dat spheres.dat --out out/compared
The problem of one step of a powder:
  tribos run compaction-small --set height=20 --out out/powder
  tribos export problem out/powder --step 2 && tribos contact out/powder/problem-2.hdf5
Summaries of all problems in one table:
  jq -r '[.file, .converged, .residual] | @tsv' out/contacts/*/summary.json";

impl Arguments {
    /// Solves, or compares.
    pub fn execute(self) -> Result<(), Failure> {
        match self.action {
            Some(Action::Compare(compare)) => compare.execute(),
            None => self.solve.execute(),
        }
    }
}
