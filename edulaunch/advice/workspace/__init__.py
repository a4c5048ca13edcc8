"""Tools for a student's packages: create new ones (`new_package`), and find missing dependencies (`dependencies`).

No code of a package runs.
"""

from __future__ import annotations
