"""Puts one check that was graded again into the result that was there."""

from __future__ import annotations

from typing import Any

from ..results import ALL_PASSED, BROKEN_GRADER, GRADER_BROKE, PASSED, SOME_FAILED, UNUSABLE_INPUT, VERDICTS, rounded


def merged(earlier: dict[str, Any], again: dict[str, Any], name: str) -> dict[str, Any]:
    """The earlier result with one check, its points and what follows from them as they are now. The rest stays as it was.

    :param again: the report of the check and of those that it needs.
    """
    new = {check['name']: check for check in again['checks']}
    checks = [new[name] if check['name'] == name else check for check in earlier['checks']]
    if name not in {check['name'] for check in checks}:
        checks.append(new[name])
    statuses = {check['status'] for check in checks}
    exit_code = BROKEN_GRADER if GRADER_BROKE in statuses else ALL_PASSED if statuses == {PASSED} else SOME_FAILED
    if again['exit_code'] == UNUSABLE_INPUT:
        exit_code = UNUSABLE_INPUT
    earned = None if exit_code == BROKEN_GRADER else rounded(sum(check['earned'] for check in checks))
    return {
        **earlier,
        **{key: again[key] for key in ('receipt', 'seed', 'rubric', 'submission', 'scenarios', 'sandbox', 'gaps', 'graph')},
        'verdict': VERDICTS[exit_code],
        'exit_code': exit_code,
        'points': {'earned': earned, 'possible': sum(check['points'] for check in checks)},
        'checks': checks,
        'regraded': sorted({*earlier.get('regraded', ()), name}),
    }
