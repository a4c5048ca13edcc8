"""What lies in a share folder."""

from __future__ import annotations

import os

_KINDS = ('msg', 'srv', 'action')


def interface_packages(prefix: str, packages: list[str]) -> list[str]:
    """Those of `packages` whose share folder has msg/, srv/ or action/."""
    return [
        package for package in packages if any(os.path.isdir(os.path.join(prefix, 'share', package, kind)) for kind in _KINDS)
    ]
