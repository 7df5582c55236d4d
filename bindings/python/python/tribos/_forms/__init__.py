"""Friction in operations of array libraries: one text for JAX and PyTorch, on every device."""
