"""Distinguishes a shell line from a plain command line."""

from __future__ import annotations

SHELLS = ('bash', 'dash', 'sh', 'zsh')
"""Programs whose `-c` is followed by a shell line."""
SIGNS = frozenset('|&;<>()$`\\*?[]#~%\n')
"""Characters with a meaning in a shell, outside quotation marks."""
