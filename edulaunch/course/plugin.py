"""What the course adds: the verb `edulaunch course`."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

ABOUT = 'copy the course, show your progress, or create a course of your own'
PLUGIN = Plugin(verbs={'course': Verb(ABOUT, 'edulaunch.course.verb')})
