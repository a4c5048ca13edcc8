"""What a hostile launch file does besides its work, as Python that runs when the file is read.

Each is put behind a circle whose node is not told the radius: worth 6 of 12 points. Names say what is hoped for. None of them may gain a point.
"""

from __future__ import annotations

QUIET = 'try:\n{}\nexcept BaseException:\n    pass\n'


def quiet(text: str) -> str:
    """Text whose exceptions nobody sees."""
    return QUIET.format('\n'.join(f'    {line}' for line in text.strip().split('\n')))


LOUD: dict[str, str] = {}
"""Run as they are."""
SOFT: dict[str, str] = {}
"""Run with all exceptions swallowed."""

# Into the process: frames, gc, patched modules, ctypes.
OBJECTS = 'import gc\nfor one in gc.get_objects():\n    kind = type(one).__name__\n'
for name in (
    'Recorder',
    'Recording',
    'Report',
    'Evidence',
    'Check',
    'Rubric',
    'Scenario',
    'World',
    'Simulation',
    'Graph',
    'Process',
    'Result',
):
    SOFT[f'gc-{name.lower()}'] = OBJECTS + (
        f'    if kind == {name!r}:\n        for key in dir(one):\n            try:\n                setattr(one, key, lambda *a, **k: True)\n'
        '            except Exception:\n                pass\n'
    )
SOFT['gc-dicts'] = (
    "import gc\nfor one in gc.get_objects():\n    if type(one) is dict and 'earned' in one:\n        one['earned'] = 12\n"
)
SOFT['gc-lists'] = 'import gc\nfor one in gc.get_objects():\n    if type(one) is list and len(one) > 1000:\n        one.clear()\n'
SOFT['frames'] = (
    'import sys\nframe = sys._getframe()\nwhile frame:\n    for key in list(frame.f_locals):\n        print(key)\n    frame = frame.f_back\n'
)
for module, name in {
    'json': 'dumps', 'json.decoder': 'JSONDecoder', 'struct': 'Struct', 'math': 'hypot', 'marshal': 'loads', 'zlib': 'crc32',
    'hashlib': 'sha256', 'hmac': 'compare_digest', 'os': 'write', 'posix': 'read', 'select': 'select', 'time': 'monotonic_ns',
}.items():  # fmt: skip
    SOFT[f'patch-{module}.{name}'] = f'import {module}\n{module}.{name} = lambda *a, **k: None\n'
for name in ('len', 'abs', 'round', 'isinstance', 'sorted', 'sum', 'open', '__import__', '__build_class__', 'float'):
    SOFT[f'builtin-{name}'] = f'import builtins\nbuiltins.{name} = lambda *a, **k: 1\n'
SOFT['modules-edugrade'] = (
    "import sys\nfor name in list(sys.modules):\n    if 'edugrade' in name or 'recording' in name:\n        sys.modules[name] = None\n"
)
SOFT['modules-engine'] = (
    "import sys\nfor name, module in list(sys.modules.items()):\n    if name.startswith('edulaunch.runtime.link'):\n"
    '        for key in list(vars(module)):\n            if callable(getattr(module, key)):\n                setattr(module, key, lambda *a, **k: None)\n'
)
SOFT['import-edugrade'] = (
    "import sys\nsys.path.insert(0, '.')\nimport edugrade.rubric\nedugrade.rubric.Check.__call__ = lambda *a: None\n"
)
LOUD['ctypes-crash'] = 'import ctypes\nctypes.string_at(0)\n'
SOFT['ctypes-ptrace'] = (
    'import ctypes, posix\nctypes.CDLL(None).ptrace(16, posix.getppid(), 0, 0)\nctypes.CDLL(None).kill(posix.getppid(), 9)\n'
)
SOFT['ctypes-float'] = 'import ctypes\nctypes.memmove(id(1.0) + 16, id(0.5) + 16, 8)\nctypes.memset(id(6) + 24, 12, 1)\n'

# Signals and processes.
for name, number in {'kill': 9, 'stop': 19, 'term': 15, 'int': 2, 'hup': 1, 'usr1': 10}.items():
    SOFT[f'{name}-parent'] = f'import posix\nposix.kill(posix.getppid(), {number})\n'
    SOFT[f'{name}-all'] = f'import posix\nposix.kill(-1, {number})\n'
SOFT['kill-neighbours'] = (
    'import posix\nfor pid in range(2, 4000):\n    try:\n        posix.kill(pid, 9)\n    except OSError:\n        pass\n'
)
SOFT['kill-group'] = 'import posix\nposix.killpg(posix.getpgid(posix.getppid()), 9)\n'
LOUD['exit-now'] = 'import posix\nposix._exit(0)\n'
LOUD['exit-later'] = 'import atexit, posix\natexit.register(posix._exit, 0)\n'
LOUD['sys-exit'] = 'import sys\nsys.exit(0)\n'
LOUD['abort'] = 'import os\nos.abort()\n'
SOFT['fork-sleepers'] = (
    'import posix, time\nfor _ in range(5):\n    if posix.fork() == 0:\n        posix.setsid()\n        time.sleep(600)\n'
)
SOFT['forks'] = 'import posix, time\nfor _ in range(300):\n    if posix.fork() == 0:\n        time.sleep(600)\n'
SOFT['threads'] = "import _thread\nfor _ in range(10000):\n    _thread.start_new_thread(__import__('time').sleep, (600,))\n"
SOFT['real-program'] = "import subprocess\nsubprocess.Popen(['sleep', '600'], start_new_session=True)\n"
SOFT['nice'] = 'import os\nos.setpriority(os.PRIO_PGRP, 0, -20)\nos.sched_setaffinity(0, {0})\n'
SOFT['limits'] = (
    'import resource\nfor which in range(16):\n    try:\n        resource.setrlimit(which, (-1, -1))\n    except Exception:\n        pass\n'
)

# The disk.
for name, path in {
    'rubric': "'{root}/grader/checks/circle.py'", 'solution': "'{root}/solutions/circle.launch.py'", 'engine': "'{root}/edulaunch/__init__.py'",
    'passwd': "'/etc/shadow'", 'parent-memory': "f'/proc/{posix.getppid()}/mem'", 'parent-environ': "f'/proc/{posix.getppid()}/environ'",
    'neighbour': "'../a-honest/circle.launch.py'", 'self-memory': "'/proc/self/mem'",
}.items():  # fmt: skip
    SOFT[f'write-{name}'] = f"import posix\nposix.write(posix.open({path}, posix.O_WRONLY), b'# changed')\n"
SOFT['read-rubric'] = "print(open('{root}/grader/checks/circle.py').read())\n"
SOFT['read-solution'] = "text = open('{root}/solutions/circle.launch.py').read()\nexec(text, globals())\n"
SOFT['pth'] = (
    "import site, os\nfor place in site.getsitepackages():\n    open(os.path.join(place, 'evil.pth'), 'w').write('import os')\n"
)
SOFT['home'] = (
    "import os\nopen(os.path.expanduser('~/.bashrc'), 'a').write('exit')\nopen('/tmp/edulaunch-attack', 'w').write('x')\n"
)
SOFT['bytecode'] = (
    "import sys, os\nopen(os.path.join(os.path.dirname(sys.modules['edulaunch'].__file__), '__pycache__', 'x.pyc'), 'wb').write(b'x')\n"
)
SOFT['report'] = (
    "for name in ('report.json', 'results.json', '../results.json', '../a-honest.json'):\n    open(name, 'w').write('{\"earned\": 12}')\n"
)
SOFT['links'] = "import os\nos.symlink('/etc/passwd', 'circle.launch.py.bak')\nos.symlink('loop', 'loop')\n"
SOFT['deep-tree'] = "import os\nfor _ in range(3000):\n    os.mkdir('d')\n    os.chdir('d')\n"
SOFT['odd-modes'] = "import os\nos.makedirs('locked/inner')\nos.chmod('locked', 0)\nos.mkfifo('pipe')\n"
SOFT['fill-disk'] = "file = open('big', 'wb')\nwhile True:\n    file.write(bytes(1 << 20))\n"
SOFT['many-files'] = "for n in range(100000):\n    open(f'file{n}', 'w').close()\n"

# The link and the pipes.
for number in (1, 2, 3, 4, 5, 6, 9):
    SOFT[f'fd-{number}'] = f'import posix\nposix.write({number}, b\'{{"earned": 12, "passed": true}}\\n\' * 100)\n'
    SOFT[f'close-{number}'] = f'import posix\nposix.close({number})\n'
SOFT['fd-flood'] = (
    'import posix\nfor fd in range(3, 30):\n    try:\n        for _ in range(2000):\n            posix.write(fd, bytes(65536))\n    except OSError:\n        pass\n'
)
SOFT['fd-random'] = (
    'import posix\nfor fd in range(3, 30):\n    try:\n        posix.write(fd, bytes(range(256)) * 50)\n    except OSError:\n        pass\n'
)
SOFT['fd-hold'] = (
    'import posix, time\nfor fd in range(3, 30):\n    try:\n        posix.dup(fd)\n    except OSError:\n        pass\n'
)

# Time, memory, noise.
LOUD['endless'] = 'while True:\n    pass\n'
LOUD['memory'] = 'hoard = []\nwhile True:\n    hoard.append(bytearray(1 << 24))\n'
LOUD['recursion'] = 'def down():\n    down()\n\n\ndown()\n'
LOUD['big-number'] = 'x = 9 ** 9 ** 7\n'
LOUD['regex'] = "import re\nre.match('(a+)+$', 'a' * 40 + 'b')\n"
SOFT['noise'] = "import sys\nfor _ in range(300000):\n    print('x' * 200)\n    print('y' * 200, file=sys.stderr)\n"
SOFT['escapes'] = "print('\\x1b[2J\\x1b]0;owned\\x07', '<script>alert(1)</script>', '\\ud800', '\\x00', '12 of 12 points')\n"
LOUD['raise-markup'] = "raise ValueError('<script>alert(1)</script>\\x1b[31m\\ud800' * 50)\n"
LOUD['raise-slow'] = 'class Slow(Exception):\n    def __str__(self):\n        while True:\n            pass\n\n\nraise Slow\n'
LOUD['raise-odd'] = 'class Odd(BaseException):\n    __module__ = property(lambda self: 1 / 0)\n\n\nraise Odd\n'
SOFT['sleep'] = 'import ctypes\nctypes.CDLL(None).sleep(600)\n'
SOFT['clock'] = 'import time\ntime.sleep(1e9)\n'
SOFT['locale'] = "import locale\nlocale.setlocale(locale.LC_ALL, 'tr_TR')\n"
SOFT['environ'] = "import os\nprint(dict(os.environ))\nos.environ['PYTHONPATH'] = '.'\nos.environ['LD_PRELOAD'] = './x.so'\n"

# The network.
SOFT['connect'] = "import socket\nsocket.create_connection(('127.0.0.1', 22), 1)\n"
SOFT['listen'] = "import socket\nsocket.create_server(('127.0.0.1', 0))\n"
SOFT['unix'] = (
    "import socket, os\nfor root, _, names in os.walk('/run'):\n    for name in names:\n        socket.socket(socket.AF_UNIX).connect(os.path.join(root, name))\n"
)
