"""Neovim without a window: the lines of docs/editor.md start the server, and a quick fix changes the buffer."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.house import ROOT

pytestmark = pytest.mark.processes
STEPS = """
vim.wait(60000, function() return #vim.diagnostic.get(0) > 0 end, 50)
local found = vim.diagnostic.get(0)
print('found ' .. found[1].message:gsub('\\n', ' / '))
vim.api.nvim_win_set_cursor(0, {found[1].lnum + 1, found[1].col})
local client = vim.lsp.get_active_clients()[1]
local params = vim.lsp.util.make_range_params()
params.context = {diagnostics = vim.tbl_map(function(one) return one.user_data.lsp and vim.tbl_extend('force', {
  range = {start = {line = one.lnum, character = one.col}, ['end'] = {line = one.end_lnum, character = one.end_col}},
  message = one.message, source = one.source}, one.user_data.lsp) end, found)}
local answer = client.request_sync('textDocument/codeAction', params, 30000, 0)
vim.lsp.util.apply_workspace_edit(answer.result[1].edit, client.offset_encoding)
print('line ' .. vim.api.nvim_buf_get_lines(0, 0, 1, false)[1])
vim.cmd('qa!')
"""


def test_the_lines_of_the_page_show_a_mistake_and_mend_it(tmp_path: Path) -> None:
    pytest.importorskip('pygls', reason="pygls is not installed: pip install 'edulaunch[editor]'")
    if shutil.which('nvim') is None:
        pytest.skip('no Neovim on this machine: apt-get install neovim')
    page = (ROOT / 'docs/editor.md').read_text(encoding='utf-8')
    lines = re.findall(r'```lua\n(.*?)```', page, re.DOTALL)[0].replace(
        "'edulaunch', 'lsp'", f"'{sys.executable}', '-m', 'edulaunch', 'lsp'"
    )
    (tmp_path / 'init.lua').write_text(lines, encoding='utf-8')
    (tmp_path / 'steps.lua').write_text(STEPS, encoding='utf-8')
    file = tmp_path / 'a.launch.py'
    file.write_text(
        'from launch.actions import LogInof\n\n\ndef generate_launch_description():\n    return []\n', encoding='utf-8'
    )
    words = ['nvim', '--headless', '-u', str(tmp_path / 'init.lua'), str(file), '-c', f'luafile {tmp_path}/steps.lua']
    done = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert 'found launch.actions does not contain LogInof' in done.stderr + done.stdout, done
    assert 'line from launch.actions import LogInfo' in done.stderr + done.stdout
