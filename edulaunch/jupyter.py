"""The module that lessons load for the magics. `%load_ext edulaunch.jupyter` does the same as `%load_ext edulaunch`."""

from edulaunch import load_ipython_extension as load_ipython_extension
