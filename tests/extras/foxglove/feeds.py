"""A conversation as plain data, and a machine without real time."""

from __future__ import annotations

import json
import struct
from typing import Any

from edulaunch.desk.view import ViewedMachine
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.runtime.session import Session

Heard = dict[str, Any] | bytes


class Machine(ViewedMachine):
    """A session that runs when the test says so."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.time = RealTime(session.sim)


class Spoken:
    """A conversation, and an ordered log of what the client has heard."""

    def __init__(self, conversation: Conversation) -> None:
        self.conversation = conversation
        self.log: list[Heard] = []

    def turn(self) -> list[Heard]:
        """One turn; what came in it."""
        new = [json.loads(one) if isinstance(one, str) else one for one in self.conversation.turn()]
        self.log += new
        return new

    def op(self, operation: str, **fields: Any) -> None:
        """Say something in JSON."""
        self.conversation.take(json.dumps({'op': operation, **fields}))

    def texts(self, operation: str) -> list[dict[str, Any]]:
        """What was heard of one operation."""
        return [one for one in self.log if isinstance(one, dict) and one['op'] == operation]

    def entry(self, operation: str, field: str, name: str) -> dict[str, Any]:
        """The last entry of a name in what was advertised."""
        key = 'topic' if field == 'channels' else 'name'
        return [row for text in self.texts(operation) for row in text[field] if row[key] == name][-1]

    def subscribe(self, topic: str, number: int = 1) -> None:
        """Subscribe to a topic that was advertised."""
        channel = self.entry('advertise', 'channels', topic)['id']
        self.op('subscribe', subscriptions=[{'id': number, 'channelId': channel}])

    def data(self, number: int = 1) -> list[tuple[int, bytes]]:
        """(time in ns, CDR) of all messages of a subscription."""
        rows = [(struct.unpack_from('<IQ', one, 1), one[13:]) for one in self.log if isinstance(one, bytes) and one[0] == 1]
        return [(time_ns, cdr) for (subscription, time_ns), cdr in rows if subscription == number]

    def statuses(self) -> list[str]:
        """The sentences that were heard."""
        return [text['message'] for text in self.texts('status')]
