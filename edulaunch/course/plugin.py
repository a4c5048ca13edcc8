"""What the course adds: the verb `edulaunch course`."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

ABOUT = 'Copy the course, see how far you are, or make a course of your own'
PLUGIN = Plugin(verbs={'course': Verb(ABOUT, 'edulaunch.course.verb')})
