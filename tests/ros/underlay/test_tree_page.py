"""The page that view_frames draws."""

from __future__ import annotations

from tf2_tools.view_frames import _places


def test_parents_stand_over_the_middle_of_their_children_and_leaves_side_by_side() -> None:
    data = {child: {'parent': parent} for child, parent in (('a', 'world'), ('b', 'world'), ('c', 'a'), ('d', 'a'), ('y', 'x'))}
    places, levels = _places(data)
    assert levels == 3
    assert places == {'c': (0, -2), 'd': (1, -2), 'a': (0.5, -1), 'b': (2, -1), 'world': (1.25, 0), 'y': (3, -1), 'x': (3, 0)}
