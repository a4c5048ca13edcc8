"""``python -m edugrade`` does the same as the command."""

from __future__ import annotations

import sys

from edugrade.cli import main

if __name__ == '__main__':
    sys.exit(main())
