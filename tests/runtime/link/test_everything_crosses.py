"""Nothing that the recorder hears of in one process stays behind in the confined peer."""

from __future__ import annotations

from edulaunch.engine.graph.tracer import Tracer
from edulaunch.runtime.link.confined import ConfinedRecorder

NOT_SENT = {'node_leaving': 'its facts are, one by one'}


def test_the_confined_recorder_has_a_way_for_each_thing_that_is_traced() -> None:
    hooks = {name for name in vars(Tracer) if not name.startswith('_')}
    assert hooks - set(vars(ConfinedRecorder)) == set(NOT_SENT), 'send it over the link (see edulaunch/runtime/link/codec.py)'
