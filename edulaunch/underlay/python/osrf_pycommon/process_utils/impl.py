"""Finding programs."""

from __future__ import annotations


def which(cmd: str, mode: int = 1, path: str | None = None, **kwargs: object) -> str | None:
    """As `shutil.which`: the path of a program on `path` (default: the PATH of the running process), or None."""
    import shutil

    from edulaunch.processes import current_process

    return shutil.which(cmd, mode, current_process().env.get('PATH') if path is None else path)
