"""What a mark was made from: with the same, the same mark comes out again (`verify.py` tries it)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.version import __version__

if TYPE_CHECKING:
    from .grading import Work
    from .results import Report


def receipt(made: Work | Report) -> dict[str, Any]:
    """Hashes of the submission's and the rubric's texts, the engine's version, the seed, which course secret chose it."""
    return {
        'submission': made.sha256,
        'rubric': made.rubric_sha256,
        'edulaunch': __version__,
        'seed': made.seed,
        'secret': made.secret,
    }
