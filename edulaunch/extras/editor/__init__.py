"""Help for writing launch files: a language server, a plug-in of pylsp, and integrations for JupyterLab and VS Code.

All of them show the findings of `edulaunch.advice.texts.check`. `server.py` is the language server, which needs pygls. The
functions of the other modules work on the file, without a protocol. While the student types, no part of a file is executed. When
the student saves a file, `saving.py` performs a dry run in a confined child process.
"""
