"""The plug-in of the tools for whole classes, which adds verbs to `edugrade`."""

from __future__ import annotations

from edulaunch.runtime.plugins import GradingVerb, Plugin

PLUGIN = Plugin(
    templates={name: f'edugrade.classes.export.templates:{name}' for name in ('classroom', 'gradescope')},
    grading={
        'batch': GradingVerb(
            'edugrade.classes.batch.command:main',
            'batch submissions/ --csv marks.csv',
            'grade a class; --resume continues an interrupted batch',
            'edugrade.classes.batch.batch_options:batch_parser',
        ),
        'classroom': GradingVerb(
            'edugrade.classes.export.classroom:main',
            'classroom circle',
            'write the autograding files for GitHub Classroom',
            'edugrade.classes.export.classroom:classroom_parser',
        ),
        'doctor': GradingVerb(
            'edugrade.classes.sandbox_proof:main', 'doctor', 'show what the sandbox of this computer keeps from a submission'
        ),
        'export': GradingVerb(
            'edugrade.classes.export.platforms:main',
            'export moodle submissions.results --out m.csv',
            'write marks for Moodle or Canvas',
            'edugrade.classes.export.platforms:export_parser',
        ),
        'gradescope': GradingVerb(
            'edugrade.classes.export.gradescope:main',
            'gradescope build circle',
            'build an autograder for Gradescope',
            'edugrade.classes.export.gradescope:gradescope_parser',
        ),
        'sign': GradingVerb(
            'edugrade.classes.verify:sign_command',
            'sign report.json --key key.pem',
            'sign a report',
            'edugrade.classes.verify:sign_parser',
        ),
        'similar': GradingVerb(
            'edugrade.classes.similar:main',
            'similar submissions.results',
            'show submissions that share code, side by side',
            'edugrade.classes.similar:similar_parser',
        ),
        'verify': GradingVerb(
            'edugrade.classes.verify:main',
            'verify report.json',
            'grade again, and report whether the mark is the same',
            'edugrade.classes.verify:verify_parser',
        ),
    },
)
