"""What the decorator makes of a function."""

from __future__ import annotations

import pytest
from edugrade import Evidence, check


def test_the_first_line_of_the_docstring_is_the_sentence() -> None:
    @check(points=3)
    def there(run: Evidence) -> None:
        """It is there.

        More for the author.
        """

    assert (there.name, there.sentence, there.points, there.needs) == ('there', 'It is there.', 3, ())


def test_a_check_without_a_sentence_is_refused() -> None:
    def silent(run: Evidence) -> None: ...

    with pytest.raises(ValueError, match=r'silent\(\) has no docstring'):
        check()(silent)


def test_negative_points_are_refused() -> None:
    def there(run: Evidence) -> None:
        """There"""

    with pytest.raises(ValueError, match='-1 points'):
        check(points=-1)(there)
