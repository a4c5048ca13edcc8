"""The grader as a plug-in of edulaunch. It adds `edulaunch.check`, completion of `edugrade`, and the verbs of `edugrade`
itself.
"""

from __future__ import annotations

from edulaunch.runtime.plugins import GradingVerb, Plugin

PLUGIN = Plugin(
    grading={
        'course': GradingVerb(
            'edugrade.course_check:main',
            'course',
            'check that exercises, solutions and rubrics belong together',
            'edugrade.course_check:course_parser',
        ),
        'decoys': GradingVerb(
            'edugrade.decoys.command:main',
            'decoys',
            'list points that rubrics pay for names without behaviour',
            'edugrade.decoys.command:decoys_parser',
        ),
        'schema': GradingVerb('edugrade.cli:schema_command', 'schema', 'print the JSON schema of reports'),
    },
    parsers={'edugrade': 'edugrade.options:edugrade_parser'},
    functions={'check': 'edugrade.notebook:check'},
)
