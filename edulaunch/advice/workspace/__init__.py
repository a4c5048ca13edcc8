"""Work on a student's packages: make new ones (`new_package`), name missing dependencies (`dependencies`), and find the mistakes
that a build or a launch would stumble over (`mistakes`). Nothing of a package is run.
"""

from __future__ import annotations
