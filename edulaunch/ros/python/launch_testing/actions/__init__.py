"""The action that starts the tests."""

from typing import TYPE_CHECKING

from launch._late import late_names

from .._absent import ABSENT
from .ready import ReadyToTest as ReadyToTest

if not TYPE_CHECKING:
    __all__, __getattr__, __dir__ = late_names(__name__, {}, eager=('ReadyToTest',), absent=ABSENT['actions'])
