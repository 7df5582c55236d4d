"""Reference answers for simulators of friction."""
