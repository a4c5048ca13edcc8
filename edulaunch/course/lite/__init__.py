"""The browser edition, which `edulaunch course lite` creates: the engine in Pyodide, a page for it, and the exercises of a
course.

`site.py` collects the files, the page calls `in_browser.py`, and `page/` is the page. `page/greenlet.py` replaces
greenlet, which does not exist in Pyodide: tasks switch by suspending WebAssembly (JSPI). docs/in_the_browser.md has figures.
"""
