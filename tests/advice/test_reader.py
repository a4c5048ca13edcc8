"""Places as the reader sees them.

Finished sentences are retold by templates that are read backwards.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

import edulaunch
from edulaunch.advice.reader import Reader, Retelling, reader_of

ROOT = Path(__file__).resolve().parents[2]
LAUNCH = """from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    node = {'package': 'demo_nodes_py', 'executable': 'talker'}
    return LaunchDescription([
        Node(**node), Node(**node)])
"""


def test_paths_below_the_folder_are_short() -> None:
    reader = Reader(folder='/home/me/ws')
    assert reader.place('/home/me/ws/src/a.py', 3) == 'src/a.py:3'
    assert reader.place('/home/me/wss/a.py', None) == '/home/me/wss/a.py'
    assert [reader.short('/home/me/ws/a.py:3'), reader.short('/turtle1/pose')] == ['a.py:3', '/turtle1/pose']
    assert Reader(folder='/').short('/turtle1/pose') == '/turtle1/pose'


@pytest.mark.parametrize(
    ('env', 'language'),
    [
        ({}, 'en'),
        ({'LANG': 'de_DE.UTF-8'}, 'de_DE'),
        ({'LANG': 'de_DE.UTF-8', 'LC_MESSAGES': 'en_GB.UTF-8'}, 'en_GB'),
        ({'LANG': 'en_US.UTF-8', 'LC_MESSAGES': 'en_GB.UTF-8', 'LC_ALL': 'de_AT@euro'}, 'de_AT'),
        ({'LANG': 'fr_FR.UTF-8', 'LANGUAGE': 'tlh:de:en'}, 'de'),
        ({'LANG': 'de_DE.UTF-8', 'LANGUAGE': 'en:de'}, 'en'),
        ({'LANG': 'C.UTF-8', 'LANGUAGE': 'de'}, 'en'),
        ({'LC_ALL': '', 'LANG': 'fr_FR.UTF-8'}, 'en'),
        ({'LC_ALL': 'C', 'LANG': 'de_DE.UTF-8', 'EDULAUNCH_LANG': 'de_DE.UTF-8'}, 'de_DE'),
        ({'LANG': 'de_DE.UTF-8', 'EDULAUNCH_LANG': 'en'}, 'en'),
        ({'LANG': '../../x.UTF-8'}, 'en'),
    ],
)
def test_the_language_is_chosen_as_gettext_does(env: dict[str, str], language: str) -> None:
    assert reader_of(env, '').language == language


@pytest.fixture
def shell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    from IPython.core.interactiveshell import InteractiveShell

    monkeypatch.chdir(tmp_path)
    InteractiveShell.clear_instance()
    shell: Any = InteractiveShell.instance(colors='nocolor')
    yield shell
    shell.history_manager.end_session()
    InteractiveShell.clear_instance()


def test_in_a_notebook_the_line_of_the_cell_is_named_too(shell: Any, capsys: pytest.CaptureFixture[str]) -> None:
    shell.run_cell('import edulaunch', store_history=True)
    shell.run_cell(f'%%writefile two.launch.py\n{LAUNCH}', store_history=True)
    assert shell.run_cell("recording = edulaunch.run('two.launch.py', duration_s=1.0)", store_history=True).success
    assert 'two.launch.py:6 (line 7 of cell [2]), at 0.00 s' in capsys.readouterr().err
    assert isinstance(shell.user_ns['recording'], edulaunch.Recording)


def test_a_file_that_no_cell_wrote_has_its_own_lines(shell: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'two.launch.py').write_text(LAUNCH)
    shell.run_cell('%%writefile other.launch.py\n1\n2\n3\n4\n5\n6', store_history=True)
    shell.run_cell("import edulaunch; edulaunch.run('two.launch.py', duration_s=1.0)", store_history=True)
    assert '(two.launch.py:6, at 0.00 s)' in capsys.readouterr().err


GERMAN = Retelling(
    {
        '{thing} is missing': '{thing} fehlt',
        'the frame {name}': 'das Koordinatensystem {name}',
        '{name} died {when}': '{name} ist {when} abgestürzt',
        'after {seconds:.1f} s in the run with {words}': 'nach {seconds} s, gestartet mit {words},',
        'nothing of the kind': 'nichts dergleichen',
        'write {{}}': 'schreib {{}}',
        '{a}{b} together': '{b}{a}',
    }
)


def test_a_sentence_without_facts_is_looked_up() -> None:
    assert GERMAN('nothing of the kind') == 'nichts dergleichen'
    assert GERMAN('write {}') == 'schreib {}'


def test_facts_go_over_and_are_retold_themselves() -> None:
    assert GERMAN('the frame laser is missing') == 'das Koordinatensystem laser fehlt'
    assert GERMAN('sim-1 died after 2.0 s in the run with a:=1') == 'sim-1 ist nach 2.0 s, gestartet mit a:=1, abgestürzt'


def test_what_is_no_sentence_of_ours_stays() -> None:
    for text in ('', 'Traceback', ' is missing', 'x' * 5000 + ' is missing', 'one two together'):
        assert GERMAN(text) == text


MIXED = Retelling(
    {
        '{what} of {whose}': '{what} von {whose}',
        '{name} is {value}': '{name} ist {value}',
        'where': 'wo',
        'no frames': 'keine Frames',
    }
)


def test_no_sentence_is_half_in_another_language() -> None:
    for text in ('The red of the water is the launch argument red', 'which of the two is earlier, now + ago or now - ago?'):
        assert MIXED(text) == text
    assert MIXED('x of turtle1') == 'x von turtle1'


def test_a_name_in_a_sentence_is_no_label() -> None:
    assert MIXED('where') == 'wo'
    assert MIXED('x of where') == 'x von where'
    assert MIXED('speed is no frames') == 'speed ist keine Frames'


def test_the_sentences_of_the_rubrics_in_yaml_are_whole_in_german() -> None:
    german = Reader('de')
    rubrics = [yaml.safe_load(path.read_text('utf-8')) for path in sorted((ROOT / 'grader' / 'checks').glob('*.yaml'))]
    texts = {text for rubric in rubrics for text in (rubric['title'], *(check.get('say') for check in rubric['checks'])) if text}
    assert len(texts) > 80
    assert {text for text in texts if german.retells(text) == text} == set()


def test_a_hostile_text_is_matched_in_one_go() -> None:
    text = 'after ' + ' s in the run with' * 150 + '!'
    assert GERMAN(text) == text
