"""Tools for a student's packages: create new packages (`new_package`), and find missing dependencies (`dependencies`).

No code of a package is executed.
"""

from __future__ import annotations
