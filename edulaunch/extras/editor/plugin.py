"""The plug-in for editors, which adds `edulaunch lsp` and the files of a VS Code extension for a course."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

PLUGIN = Plugin(
    verbs={'lsp': Verb('run the language server that editors start', 'edulaunch.extras.editor.verb')},
    templates={'vscode': 'edulaunch.extras.editor.templates:vscode'},
)
