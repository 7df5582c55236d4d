//! What is promised, checked against independent sources.
