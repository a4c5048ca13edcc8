"""The published schema of the JSON report (JSON Schema 2020-12): ``edugrade schema`` prints it."""

from __future__ import annotations

import os
from collections.abc import Sequence

SCHEMA = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'report.schema.json')


def main(words: Sequence[str]) -> int:
    """The command ``edugrade schema``."""
    import argparse

    argparse.ArgumentParser(prog='edugrade schema', description='Print the JSON schema of reports and results.').parse_args(words)
    with open(SCHEMA, encoding='utf-8') as file:
        print(file.read(), end='')
    return 0
