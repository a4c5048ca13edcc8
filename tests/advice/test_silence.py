"""The rules say nothing of what is healthy: every remark on it has been looked at, and is true."""

from __future__ import annotations

import pytest

from tests.advice.silence import OPEN, judged, remarks
from tests.test_seeds import SEEDS


@pytest.mark.whole
@pytest.mark.skipif(not SEEDS.is_dir(), reason='the seed tutorials are not beside this repository')
def test_every_remark_has_been_judged() -> None:
    known = judged()
    assert [remark for remark, judgement in known.items() if OPEN in judgement or not judgement.startswith('true')] == []
    said = remarks()
    assert ([remark for remark in said if remark not in known], [remark for remark in known if remark not in said]) == ([], [])
