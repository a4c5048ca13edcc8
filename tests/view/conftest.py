"""Recordings made by hand, as the tests of the canvas make them."""

from tests.canvas.conftest import demo, maker, walk

__all__ = ['demo', 'maker', 'walk']
