"""`python -m edulaunch` is the command `edulaunch`."""

from __future__ import annotations

from edulaunch.desk.cli.main import main

raise SystemExit(main())
