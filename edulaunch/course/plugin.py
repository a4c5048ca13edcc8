"""The plug-in of the course: it adds the verb `edulaunch course`."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

ABOUT = 'copy the course, show your progress, or create your own course'
PLUGIN = Plugin(verbs={'course': Verb(ABOUT, 'edulaunch.course.verb')})
