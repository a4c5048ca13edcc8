"""The recorded answers of the original launch to small questions (`../shared/probes`), asked here."""

from __future__ import annotations

import asyncio
import json
import re
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

PROBES = Path(__file__).resolve().parents[3] / '..' / 'shared' / 'probes'
OTHER_FOLDERS = re.compile(
    r'\b(PV|PT|N|S|SP|XML|args_of)\(|Node\b|normalize_parameters|prefix_namespace|InPackage|FindPackage|Composable'
)


def _questions() -> list[str]:
    answers = PROBES / 'launch_probes.json'
    if not answers.exists():
        return []
    return [question for question in json.loads(answers.read_text()) if not OTHER_FOLDERS.search(question)]


@pytest.fixture(scope='module')
def names() -> Iterator[dict[str, Any]]:
    """What the probes see: their own functions, and launch."""
    text = (PROBES / 'launch_probes.py').read_text()
    helpers = text[text.index('CONF = {') : text.index('def S(text')] + text[text.index('def C(cond)') : text.index('def XML(')]
    helpers += text[text.index('def visit(') : text.index('def N(')]
    loop = asyncio.new_event_loop()
    known: dict[str, Any] = {'loop': loop, 'HERE': str(PROBES)}
    exec(
        'import launch\nfrom launch import *\nfrom launch.actions import *\nfrom launch.conditions import *\n'
        'from launch.substitutions import *\nfrom launch.launch_description_sources import *\n'
        'from launch.utilities import perform_substitutions, normalize_to_list_of_substitutions\n' + helpers,
        known,
    )
    yield known
    loop.close()


@pytest.mark.skipif(not PROBES.exists(), reason='../shared/probes is not here')
@pytest.mark.parametrize('question', _questions())
def test_answers_as_the_original(question: str, names: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('PROBE_ENV', 'probe value')
    monkeypatch.delenv('PROBE_MISSING', raising=False)
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        try:
            answer = names['norm'](eval(question, names))
        except Exception as error:
            answer = f'raises {type(error).__name__}: {names["norm"](str(error))}'
    assert answer == json.loads((PROBES / 'launch_probes.json').read_text())[question]
