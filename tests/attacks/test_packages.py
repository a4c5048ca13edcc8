"""Packages that are paid for nothing: copies of a solution in which one file only looks as if it did the work."""

from __future__ import annotations

import shutil

import pytest
from edugrade.grading import grade, plan_work
from edugrade.results import Report
from edugrade.submission import Submission

from tests.house import ROOT

pytestmark = pytest.mark.attacks

COUNTER, SEA = 'two_channels/counter.py', 'launch/sea.launch.py'
COUNTING = """            self.create_subscription(String, topic, self.on_message, 10)

    def on_message(self, message):
        self.count += 1
        self.get_logger().info(f'messages: {self.count}')
"""
BY_CLOCK = """            self.create_subscription(String, topic, lambda message: None, 10)
        self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        for _ in range(2):
            self.count += 1
            self.get_logger().info(f'messages: {self.count}')
"""
TWO_FOR_ONE = """            self.create_subscription(String, topic, self.on_message, 10)

    def on_message(self, message, heard=[]):
        heard.append(message)
        for _ in range(2 * (len(heard) % 2)):
            self.count += 1
            self.get_logger().info(f'messages: {self.count}')
"""
GIVEN = 'parameters=[config, {'
FORGED = {
    'a counter that counts by the clock': (COUNTER, COUNTING, BY_CLOCK, 5),
    'a counter that counts each first message twice': (COUNTER, COUNTING, TWO_FOR_ONE, 5),
    'colours in place of the file': (SEA, GIVEN, "parameters=[{'background_r': 20, 'background_g': 60, ", 6),
    'colours behind the file': (SEA, GIVEN, "parameters=[config, {'background_r': 20, 'background_g': 60, ", 6),
}
RIGHT = {
    'a counter that keeps the messages': (COUNTER, 'self.count += 1', 'self.count = sum([self.count, 1])', 12),
    'the file as an argument': (SEA, GIVEN, "ros_arguments=['--params-file', config], parameters=[{", 12),
}
CASES = FORGED | RIGHT


@pytest.fixture(scope='module')
def graded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Report]:
    works = []
    for file, before, after, _ in CASES.values():
        exercise = 'two_channels' if file == COUNTER else 'two_seas'
        package = tmp_path_factory.mktemp('packages') / exercise
        shutil.copytree(ROOT / 'solutions' / exercise, package)
        text = (package / file).read_text()
        assert before in text
        (package / file).write_text(text.replace(before, after))
        works.append(plan_work(Submission(str(package))))
    return dict(zip(CASES, grade(works), strict=True))


@pytest.mark.parametrize('name', CASES)
def test_what_is_not_done_is_not_paid(graded: dict[str, Report], name: str) -> None:
    told = [f'{result.name}: {result.status} {result.earned} {result.reason}' for result in graded[name].results]
    assert graded[name].earned == CASES[name][3], told
