"""`python -m edulaunch` runs the command `edulaunch`."""

from __future__ import annotations

from edulaunch.desk.commands import edulaunch

raise SystemExit(edulaunch())
