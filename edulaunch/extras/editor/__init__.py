"""Help for writing launch files: a language server, a plug-in of pylsp, and integrations for JupyterLab and VS Code.

All of them show the findings of `edulaunch.advice.texts.check`. `server.py` is the language server, which needs pygls. The
other modules are functions over the file, without a protocol. While the student types, no part of a file is executed. On
saving, `saving.py` runs a dry run in a confined child process.
"""
