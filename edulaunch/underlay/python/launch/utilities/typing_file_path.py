"""What may be given as a path."""

from __future__ import annotations

import os
from typing import Union

FilePath = Union[bytes, str, 'os.PathLike[str]']
