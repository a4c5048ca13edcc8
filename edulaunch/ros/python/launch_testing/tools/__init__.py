"""Functions that compare strings."""

from typing import TYPE_CHECKING

from launch._late import late_names

from .._absent import ABSENT
from .text import build_text_match as build_text_match

if not TYPE_CHECKING:
    __all__, __getattr__, __dir__ = late_names(__name__, {}, eager=('build_text_match',), absent=ABSENT['tools'])
