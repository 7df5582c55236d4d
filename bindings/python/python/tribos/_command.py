"""The command ``tribos``."""

import signal
import sys

from tribos import _native


def main() -> None:
    """Run the command with this process' arguments and end with its exit code."""
    # The command has its own way to end on Ctrl-C: its results stay, and it says how to go on.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(_native.command(["tribos", *sys.argv[1:]]))
