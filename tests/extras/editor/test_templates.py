"""The VS Code extension: a replacement of VS Code loads it, shows a diagnostic of the real server, and applies its fix."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.course.templates import write_template
from edulaunch.extras.editor.templates import PLACE, vscode
from tests.house import ROOT

STAND_IN = """
const Module = require('module');
class Range { constructor(a, b, c, d) { Object.assign(this, {start: {line: a, character: b}, end: {line: c, character: d}}); } intersection() { return this; } }
class Diagnostic { constructor(range, message, severity) { Object.assign(this, {range, message, severity}); } }
class CodeAction { constructor(title, kind) { Object.assign(this, {title, kind}); } }
class WorkspaceEdit { constructor() { this.made = []; } replace(uri, range, text) { this.made.push([range, text]); } }
const events = {}, providers = {};
const on = name => callback => { events[name] = callback; return {dispose() {}}; };
const register = name => (selector, provider) => { providers[name] = provider; return {dispose() {}}; };
const uri = text => ({toString: () => text, fsPath: text.replace('file://', '')});
const document = {uri: uri(process.argv[3]), languageId: 'python', version: 1, getText: () => process.argv[4]};
const shown = new Map();
const vscode = {
  Range, Diagnostic, CodeAction, WorkspaceEdit, CodeActionKind: {QuickFix: 'quickfix'},
  Location: class {}, Hover: class {}, MarkdownString: class {}, CompletionItem: class { constructor(label) { this.label = label; } },
  Uri: {parse: uri},
  window: {showErrorMessage: async (text, button) => { console.log(text + ' [' + button + ']'); return button; }},
  commands: {executeCommand: (...words) => { console.log(words.join(' ')); process.exit(3); }},
  workspace: {
    isTrusted: process.argv[7] !== 'not trusted', workspaceFolders: [{uri: uri(process.argv[5])}], textDocuments: [document],
    getConfiguration: () => ({get: name => name === 'command' ? JSON.parse(process.argv[6]) : true}),
    onDidOpenTextDocument: on('open'), onDidChangeTextDocument: on('change'), onDidSaveTextDocument: on('save'),
    onDidCloseTextDocument: on('close'), onDidChangeConfiguration: on('settings'), onDidGrantWorkspaceTrust: on('trust'),
  },
  languages: {
    match: () => 10,
    createDiagnosticCollection: () => ({set: async (where, list) => {
      const fixes = providers.actions ? providers.actions.provideCodeActions(document, new Range(0, 0, 0, 0)) : [];
      const items = await providers.completion.provideCompletionItems(document, {line: 0, character: 5});
      console.log(JSON.stringify({where: where.toString(), list, fixes: fixes.map(one => [one.title, one.edit.made]), items: items.length}));
      await extension.deactivate();
      process.exit(0);
    }}),
    registerCodeActionsProvider: register('actions'), registerCompletionItemProvider: register('completion'),
    registerHoverProvider: register('hover'), registerDefinitionProvider: register('definition'), registerReferenceProvider: register('references'),
  },
};
const load = Module._load;
Module._load = (name, ...rest) => name === 'vscode' ? vscode : load(name, ...rest);
const extension = require(process.argv[2]);
extension.activate({subscriptions: []});
"""


def test_the_template_brings_the_extension(tmp_path: Path) -> None:
    shutil.copytree(ROOT / 'edulaunch/course/starter', tmp_path / 'mine')
    written = write_template('vscode', str(tmp_path / 'mine'))
    assert set(written) == set(vscode('', [])) == {f'{PLACE}/extension.js', f'{PLACE}/package.json'}
    about = json.loads((tmp_path / 'mine' / PLACE / 'package.json').read_text(encoding='utf-8'))
    assert (tmp_path / 'mine' / PLACE / about['main']).is_file()


def played(folder: Path, command: list[str], trust: str = 'trusted') -> subprocess.CompletedProcess[str]:
    """Play the extension in a folder with a mistake in a file, with the command of its setting."""
    node = shutil.which('node')
    if node is None:
        pytest.skip('no Node.js on this machine: apt-get install nodejs')
    (folder / 'stand_in.js').write_text(STAND_IN, encoding='utf-8')
    extension = ROOT / 'edulaunch/extras/editor/vscode/extension.js'
    text = 'from launch.actions import LogInof\n\n\ndef generate_launch_description():\n    return []\n'
    words = [(folder / 'a.launch.py').as_uri(), text, f'file://{folder}', json.dumps(command), trust]
    return subprocess.run(
        [node, str(folder / 'stand_in.js'), str(extension), *words], capture_output=True, text=True, timeout=120
    )


@pytest.mark.processes
def test_a_stand_in_of_vs_code_shows_the_diagnostic_and_its_fix(tmp_path: Path) -> None:
    pytest.importorskip('pygls', reason="pygls is not installed: pip install 'edulaunch[editor]'")
    done = played(tmp_path, [sys.executable, '-m', 'edulaunch', 'lsp'])
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads(done.stdout.splitlines()[-1])
    assert (found['where'], [one['code'] for one in found['list']]) == (
        (tmp_path / 'a.launch.py').as_uri(),
        ['launch.import-name'],
    )
    assert found['fixes'] == [["replace 'LogInof' by 'LogInfo'", [[found['list'][0]['range'], 'LogInfo']]]]


@pytest.mark.processes
@pytest.mark.parametrize(
    ('command', 'reason'),
    [
        (['/nowhere/edulaunch', 'lsp'], 'spawn /nowhere/edulaunch ENOENT'),
        ([sys.executable, '-c', "raise SystemExit('pygls is not installed')"], 'pygls is not installed'),
        ([sys.executable, '-c', 'raise SystemExit(7)'], 'exit code 7'),
    ],
)
def test_a_server_that_does_not_start_is_told_with_its_reason_and_the_setting(
    tmp_path: Path, command: list[str], reason: str
) -> None:
    done = played(tmp_path, command)
    told, opened = done.stdout.splitlines()
    assert told.startswith(f'edulaunch gives no help here: its language server has ended ({reason}). Install it: ')
    assert told.endswith('[Open Settings]')
    assert (opened, done.returncode) == ('workbench.action.openSettings edulaunch.command', 3)


@pytest.mark.processes
@pytest.mark.parametrize(('trust', 'is_own'), [('trusted', True), ('not trusted', False)])
def test_the_environment_of_a_trusted_folder_comes_before_the_path(tmp_path: Path, trust: str, is_own: bool) -> None:
    own = tmp_path / '.venv' / 'bin' / 'edulaunch'
    own.parent.mkdir(parents=True)
    own.write_text(f'#!{sys.executable}\nraise SystemExit("the own one")\n', encoding='utf-8')
    own.chmod(0o755)
    other = tmp_path / 'path' / 'edulaunch'
    other.parent.mkdir()
    other.write_text(f'#!{sys.executable}\nraise SystemExit("the one of the path")\n', encoding='utf-8')
    other.chmod(0o755)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv('PATH', str(other.parent), prepend=os.pathsep)
        told = played(tmp_path, ['edulaunch', 'lsp'], trust).stdout
    assert ('(the own one)' in told, '(the one of the path)' in told) == (is_own, not is_own)
