"""The name under which a notebook loads the magics: `%load_ext edulaunch.jupyter`. The code is in `edulaunch/desk/notebook/`."""

from edulaunch.desk.notebook import load_ipython_extension as load_ipython_extension
