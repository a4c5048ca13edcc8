"""Help where launch files are written: a language server for editors, a plug-in of pylsp, and faces for JupyterLab and VS Code.

All of them show what `edulaunch.advice.texts.check` finds. `server.py` is the language server, which needs pygls. The other
modules are functions over the file, without a protocol. While the student types, nothing of a file is executed. On
saving, `saving.py` runs a dry run in a confined child process.
"""
