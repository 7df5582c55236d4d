//! The tribos command: friction laws, final motion, runs and reports.
