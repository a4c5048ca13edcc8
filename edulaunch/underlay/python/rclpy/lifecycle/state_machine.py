"""The states of a managed node and the transitions between them."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple


class TransitionCallbackReturnType(Enum):
    """What a transition's callback returns; students know it as `TransitionCallbackReturn`."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99


TransitionCallbackReturn = TransitionCallbackReturnType


class LifecycleState(NamedTuple):
    """A state, as callbacks are told of it."""

    label: str
    state_id: int


class Transition(NamedTuple):
    """A transition: what starts it (`label`), where from, through which state, and what its callback is called."""

    number: int
    label: str
    start: str
    during: str
    callback: str


STATES = {
    label: LifecycleState(label, number)
    for label, number in (
        ('unknown', 0),
        ('unconfigured', 1),
        ('inactive', 2),
        ('active', 3),
        ('finalized', 4),
        ('configuring', 10),
        ('cleaningup', 11),
        ('shuttingdown', 12),
        ('activating', 13),
        ('deactivating', 14),
        ('errorprocessing', 15),
    )
}

TRANSITIONS = (
    Transition(1, 'configure', 'unconfigured', 'configuring', 'on_configure'),
    Transition(2, 'cleanup', 'inactive', 'cleaningup', 'on_cleanup'),
    Transition(3, 'activate', 'inactive', 'activating', 'on_activate'),
    Transition(4, 'deactivate', 'active', 'deactivating', 'on_deactivate'),
    Transition(5, 'shutdown', 'unconfigured', 'shuttingdown', 'on_shutdown'),
    Transition(6, 'shutdown', 'inactive', 'shuttingdown', 'on_shutdown'),
    Transition(7, 'shutdown', 'active', 'shuttingdown', 'on_shutdown'),
)


class Outcome(NamedTuple):
    """How a state of passage ends: its number, its label, and the state that follows."""

    number: int
    label: str
    goal: str


def _outcomes(first: int, success: str, failure: str, error: str = 'errorprocessing') -> dict[TransitionCallbackReturn, Outcome]:
    return {
        TransitionCallbackReturn.SUCCESS: Outcome(first, 'transition_success', success),
        TransitionCallbackReturn.FAILURE: Outcome(first + 1, 'transition_failure', failure),
        TransitionCallbackReturn.ERROR: Outcome(first + 2, 'transition_error', error),
    }


OUTCOMES = {
    'configuring': _outcomes(10, 'inactive', 'unconfigured'),
    'cleaningup': _outcomes(20, 'unconfigured', 'inactive'),
    'activating': _outcomes(30, 'active', 'inactive'),
    'deactivating': _outcomes(40, 'inactive', 'active'),
    'shuttingdown': _outcomes(50, 'finalized', 'finalized'),
    'errorprocessing': _outcomes(60, 'unconfigured', 'finalized', 'finalized'),
}


def transition_from(state: str, wanted: int | str) -> Transition | None:
    """The transition of that number or label which starts in a state, or None."""
    for transition in TRANSITIONS:
        if transition.start == state and wanted in (transition.number, transition.label):
            return transition
    return None


def all_transitions() -> list[tuple[int, str, str, str]]:
    """(number, label, start, goal) of all transitions, each followed by those that end its state of passage."""
    found = []
    for state, outcomes in OUTCOMES.items():
        found += [(one.number, one.label, one.start, one.during) for one in TRANSITIONS if one.during == state]
        found += [(outcome.number, outcome.label, state, outcome.goal) for outcome in outcomes.values()]
    return found
