"""What the tools for whole classes add: verbs of `edugrade`."""

from __future__ import annotations

from edulaunch.runtime.plugins import GradingVerb, Plugin

PLUGIN = Plugin(
    templates={name: f'edugrade.classes.export.templates:{name}' for name in ('classroom', 'gradescope')},
    grading={
        'batch': GradingVerb(
            'edugrade.classes.batch.command:main',
            'batch submissions/ --csv marks.csv',
            'a class; --resume goes on where it was stopped',
        ),
        'classroom': GradingVerb(
            'edugrade.classes.export.classroom:main', 'classroom circle', 'autograding for GitHub Classroom'
        ),
        'doctor': GradingVerb('edugrade.classes.doctor:main', 'doctor', 'what a submission on this machine is kept from'),
        'export': GradingVerb(
            'edugrade.classes.export.platforms:main',
            'export moodle submissions.results --out m.csv',
            'marks for Moodle or Canvas',
        ),
        'gradescope': GradingVerb(
            'edugrade.classes.export.gradescope:main', 'gradescope build circle', 'an autograder for Gradescope'
        ),
        'sign': GradingVerb('edugrade.classes.verify:sign_command', 'sign report.json --key key.pem', 'sign a report'),
        'similar': GradingVerb(
            'edugrade.classes.similar:main', 'similar submissions.results', 'who has code in common, side by side'
        ),
        'verify': GradingVerb(
            'edugrade.classes.verify:main', 'verify report.json', 'make a mark again, and say whether it holds'
        ),
    },
)
