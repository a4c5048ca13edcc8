"""What a client of Foxglove's protocol costs the machine, without subscriptions and for each channel of 62.5 messages a second.

Without a client the server has no connection to the machine, and costs it nothing.
"""

from __future__ import annotations

import json
import time

from edulaunch.desk.view import ViewedMachine
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.live import LiveFeed
from edulaunch.extras.foxglove.server import EVERY_S
from edulaunch.runtime.session import Session

TURTLES = 8
SECONDS = 20.0
TIMES = 3


class Machine(ViewedMachine):
    """A session without real time."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.time = RealTime(session.sim)


def measure() -> dict[str, float]:
    """The best of three runs of eight turtles for 20 simulated seconds, in turns as the server takes them."""
    runs = [(_run(None), _run(0), _run(TURTLES)) for _ in range(TIMES)]
    alone, idle, busy = (min(run[place] for run in runs) for place in range(3))
    return {
        'the machine alone (% of a core)': alone / SECONDS * 100,
        'a client without subscriptions (% of a core)': (idle - alone) / SECONDS * 100,
        'each channel of 62.5 Hz (% of a core)': (busy - idle) / TURTLES / SECONDS * 100,
        'with eight channels / alone': busy / alone,
    }


def _run(channels: int | None) -> float:
    """Seconds of the processor for the run. A client subscribes to `channels` poses. None means no client."""
    with Session() as session, streams_of_programs():
        for number in range(TURTLES):
            words = ('ros2', 'run', 'turtlesim', 'turtlesim_node', '--ros-args', '-r', f'__ns:=/t{number}')
            session.host.start(ProcessSpec(argv=words, name=f'turtle-{number}'))
        session.run(1.0)
        client = None if channels is None else Conversation(LiveFeed(Machine(session), 1))
        if client is not None:
            _subscribe(client, channels or 0)
        began = time.process_time()
        for _ in range(round(SECONDS / EVERY_S)):
            session.run(EVERY_S)
            if client is not None:
                client.turn()
        return time.process_time() - began


def _subscribe(client: Conversation, count: int) -> None:
    rows = [row for one in client.turn() if isinstance(one, str) for row in json.loads(one).get('channels', ())]
    poses = [row['id'] for row in rows if row['topic'].endswith('/pose')]
    assert len(poses) >= count
    client.take(json.dumps({'op': 'subscribe', 'subscriptions': [{'id': n, 'channelId': n} for n in poses[:count]]}))
