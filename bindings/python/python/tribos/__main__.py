"""The command ``tribos`` as ``python -m tribos``."""

from tribos._command import main

main()
