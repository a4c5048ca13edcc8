"""The module behind ``python -m edugrade``, which does the same as the command ``edugrade``."""

from __future__ import annotations

import sys

from edugrade.cli import main

if __name__ == '__main__':
    sys.exit(main())
