"""`edulaunch plan`: the plan of a launch file as JSON, for programs; for people there is `edulaunch explain`."""

from __future__ import annotations

import argparse
import sys

from edulaunch.cli import explain


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Those of `edulaunch explain`."""
    explain.add_arguments(parser)


def main(arguments: argparse.Namespace) -> int:
    """With --json the plan, in the plan format 1; else what `edulaunch explain` says."""
    if not arguments.json or arguments.diff:
        print('plan is called explain now: edulaunch explain (plan --json stays)', file=sys.stderr)
        return explain.main(arguments)
    import json

    explanation, _ = explain.explained(arguments)
    print(json.dumps(explanation.plan, indent=1, sort_keys=True))
    return explain.report(explanation)
