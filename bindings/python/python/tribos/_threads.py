"""Number of threads of batches and runs."""

from __future__ import annotations

import operator

from tribos import _native


def num_threads() -> int:
    """Number of threads that batches and runs use.

    Results do not depend on it. A process that forks starts threads of its own.
    """
    return _native.num_threads()


def set_num_threads(count: int | None) -> None:
    """Set the number of threads that batches and runs use.

    Parameters
    ----------
    count
        Number of threads, from 1 on; None for as many as ``RAYON_NUM_THREADS`` says, or as there
        are processors.

    Examples
    --------
    >>> import tribos
    >>> tribos.set_num_threads(1)
    >>> tribos.num_threads()
    1
    >>> tribos.set_num_threads(None)
    """
    if count is not None:
        count = operator.index(count)
        if not 1 <= count <= 65536:
            raise ValueError(f"the number of threads must be from 1 to 65536, not {count}")
    _native.set_num_threads(count)
