"""Everything that edugrade writes as JSON is as the published schema says."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from edugrade.cli import main
from edugrade.document import document
from edugrade.report_schema import SCHEMA
from made_report import BROKE, FAILED, NOT_RUN, PASSED, report

jsonschema = pytest.importorskip('jsonschema', reason='it comes with JupyterLab')
SOLUTION = Path(__file__).parents[2] / 'solutions' / 'static_frame.launch.py'


@pytest.fixture(scope='module')
def schema() -> Any:
    found = json.loads(Path(SCHEMA).read_text('utf-8'))
    jsonschema.Draft202012Validator.check_schema(found)
    return jsonschema.Draft202012Validator(found)


def test_one_report_and_several(schema: Any, tmp_path: Path) -> None:
    main([str(SOLUTION), '--json', str(tmp_path / 'one')])
    main([str(SOLUTION), 'nowhere.launch.py', '--json', str(tmp_path / 'two')])
    for name in ('one', 'two'):
        schema.validate(json.loads((tmp_path / name).read_text()))


def test_the_results_of_a_batch(schema: Any, tmp_path: Path) -> None:
    (tmp_path / 'class' / 'anna').mkdir(parents=True)
    shutil.copy(SOLUTION, tmp_path / 'class' / 'anna')
    (tmp_path / 'class' / 'bert').mkdir()
    (tmp_path / 'class' / 'bert' / 'static_frame.launch.py').write_text('import nothing')
    (tmp_path / 'class' / 'carl').mkdir()
    main(['batch', str(tmp_path / 'class')])
    main(['batch', str(tmp_path / 'class'), '--only', 'laser_is_on_tf'])
    found = sorted(tmp_path.glob('class.results/**/*.json'))
    assert len(found) == 3
    for path in found:
        schema.validate(json.loads(path.read_text()))


def made() -> dict[str, Any]:
    """A report that was made by hand, with the hashes that it lacks."""
    found = document(report(PASSED, FAILED, NOT_RUN, BROKE))
    found['submission']['sha256'] = '0' * 64
    found['receipt'].update(submission='0' * 64, rubric='0' * 64)
    return found


def test_every_kind_of_check(schema: Any) -> None:
    schema.validate(made())


@pytest.mark.parametrize(
    'spoilt', [('verdict', 'fine'), ('points', {'earned': -1, 'possible': 3}), ('checks', []), ('receipt', {})]
)
def test_what_is_no_report_is_found(schema: Any, spoilt: tuple[str, Any]) -> None:
    with pytest.raises(jsonschema.ValidationError):
        schema.validate({**made(), spoilt[0]: spoilt[1]})


def test_the_command_prints_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['schema']) == 0
    assert json.loads(capsys.readouterr().out)['$id'] == 'urn:edugrade:report:2'
