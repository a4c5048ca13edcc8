"""The VS Code extension: a replacement of VS Code loads it, shows a diagnostic of the real server, and applies its fix."""

from __future__ import annotations

import json
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
  window: {showWarningMessage: text => { console.log('WARNING ' + text); process.exit(1); }},
  workspace: {
    isTrusted: true, workspaceFolders: [{uri: uri(process.argv[5])}], textDocuments: [document],
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


@pytest.mark.processes
def test_a_stand_in_of_vs_code_shows_the_diagnostic_and_its_fix(tmp_path: Path) -> None:
    pytest.importorskip('pygls', reason="pygls is not installed: pip install 'edulaunch[editor]'")
    node = shutil.which('node')
    if node is None:
        pytest.skip('no Node.js on this machine: apt-get install nodejs')
    (tmp_path / 'stand_in.js').write_text(STAND_IN, encoding='utf-8')
    extension = ROOT / 'edulaunch/extras/editor/vscode/extension.js'
    file = (tmp_path / 'a.launch.py').as_uri()
    text = 'from launch.actions import LogInof\n\n\ndef generate_launch_description():\n    return []\n'
    command = json.dumps([sys.executable, '-m', 'edulaunch', 'lsp'])
    words = [node, str(tmp_path / 'stand_in.js'), str(extension), file, text, f'file://{tmp_path}', command]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads(done.stdout.splitlines()[-1])
    assert (found['where'], [one['code'] for one in found['list']]) == (file, ['launch.import-name'])
    assert found['fixes'] == [["replace 'LogInof' by 'LogInfo'", [[found['list'][0]['range'], 'LogInfo']]]]
