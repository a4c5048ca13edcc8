"""The secret of a course, from which runs are chosen that nobody can know beforehand."""

from __future__ import annotations

import hmac

from edulaunch.errors import UnusableInput

from .regular_file import read_regular

LEAST_BYTES, MOST_BYTES = 16, 4096


class CourseSecret:
    """Read from a file, never from an environment variable or the command line, where other programs can see it.

    :raises UnusableInput: when the file cannot be read, or is too short to be a secret.
    """

    def __init__(self, path: str) -> None:
        try:
            self._key = read_regular(path, MOST_BYTES).strip()
        except (OSError, ValueError) as error:
            raise UnusableInput(f'the course secret {path} cannot be read: {getattr(error, "strerror", None) or error}') from None
        if len(self._key) < LEAST_BYTES:
            raise UnusableInput(
                f'the course secret {path} is shorter than {LEAST_BYTES} bytes', help='make one: openssl rand -hex 32 > secret'
            )

    @classmethod
    def of(cls, key: bytes) -> CourseSecret:
        """A secret that is no file: for trying things out."""
        found = cls.__new__(cls)
        found._key = key
        return found

    @property
    def name(self) -> str:
        """Which secret it was, without giving it away."""
        return hmac.digest(self._key, b'edugrade: which secret', 'sha256').hex()[:16]

    def number(self, *words: str) -> int:
        """A number that only this secret and these words give."""
        message = '\0'.join(('edugrade: variant', *words)).encode('utf-8', 'surrogateescape')
        return int.from_bytes(hmac.digest(self._key, message, 'sha256')[:8], 'big')

    def seed(self, exercise: str, student: str, sha256: str) -> int:
        """The number from which the runs of a submission are chosen: another one for each student and each text."""
        message = '\0'.join((exercise, student, sha256)).encode('utf-8', 'surrogateescape')
        return int.from_bytes(hmac.digest(self._key, message, 'sha256')[:4], 'big')
