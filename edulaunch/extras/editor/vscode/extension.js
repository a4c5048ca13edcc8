// Joins VS Code and `edulaunch lsp`. It speaks the Language Server Protocol itself, so it needs no other package and no build.
'use strict';
const vscode = require('vscode');
const {spawn} = require('child_process');
const fs = require('fs');
const path = require('path');

const SELECTOR = [
  {scheme: 'file', language: 'python'},
  {scheme: 'file', pattern: '**/*.{xml,yaml,yml}'},
];
const SEVERITIES = {1: 0, 2: 1, 3: 2, 4: 3}; // of the protocol -> vscode.DiagnosticSeverity
let server;

class Server {
  constructor(command, folder) {
    this.child = spawn(command[0], command.slice(1), {cwd: folder, stdio: 'pipe'});
    this.waiting = new Map();
    this.handlers = {};
    this.number = 0;
    this.buffer = Buffer.alloc(0);
    this.child.stdout.on('data', data => this.receive(data));
    this.said = '';
    this.child.stderr.on('data', data => { this.said = (this.said + data).slice(-2000); });
    this.child.on('error', error => this.failed(error.message));
    this.child.on('close', code => code && this.failed(this.said.trim() || `exit code ${code}`));
    this.child.stdin.on('error', () => {});
  }

  async failed(reason) {
    if (this.isTold) return;
    this.isTold = true;
    const open = 'Open Settings'; // VS Code hides a message without a button after ten seconds
    const chosen = await vscode.window.showErrorMessage(
      `edulaunch gives no help here: its language server has ended (${reason}). Install it: pip install '.[editor]' in the clone of edulaunch. ` +
      'Or name the command in the setting edulaunch.command. Then reload the window.', open);
    if (chosen === open) vscode.commands.executeCommand('workbench.action.openSettings', 'edulaunch.command');
  }

  send(message) {
    const body = Buffer.from(JSON.stringify({jsonrpc: '2.0', ...message}));
    this.child.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.child.stdin.write(body);
  }

  notify(method, params) { this.send({method, params}); }

  request(method, params) {
    const id = ++this.number;
    return new Promise(resolve => {
      this.waiting.set(id, resolve);
      this.send({id, method, params});
    });
  }

  receive(data) {
    this.buffer = Buffer.concat([this.buffer, data]);
    for (;;) {
      const end = this.buffer.indexOf('\r\n\r\n');
      if (end < 0) return;
      const length = Number(/Content-Length: (\d+)/i.exec(this.buffer.subarray(0, end))[1]);
      if (this.buffer.length < end + 4 + length) return;
      const message = JSON.parse(this.buffer.subarray(end + 4, end + 4 + length));
      this.buffer = this.buffer.subarray(end + 4 + length);
      if (message.method && this.handlers[message.method]) this.handlers[message.method](message.params);
      else if (message.method && message.id !== undefined) this.send({id: message.id, result: null});
      else if (this.waiting.has(message.id)) {
        this.waiting.get(message.id)(message.error ? null : message.result);
        this.waiting.delete(message.id);
      }
    }
  }
}

// The command of the settings; where that is the default, the edulaunch of a trusted folder's own environment comes first.
function commandOf(settings, folder) {
  const [program, ...words] = settings.get('command');
  if (program !== 'edulaunch' || !folder || !vscode.workspace.isTrusted) return [program, ...words];
  const places = [['.venv', 'bin', 'edulaunch'], ['.venv', 'Scripts', 'edulaunch.exe']].map(one => path.join(folder, ...one));
  return [places.find(one => fs.existsSync(one)) || program, ...words];
}

const toRange = range => new vscode.Range(range.start.line, range.start.character, range.end.line, range.end.character);
const at = (document, position) => ({
  textDocument: {uri: document.uri.toString()},
  position: {line: position.line, character: position.character},
});
const toLocation = place => new vscode.Location(vscode.Uri.parse(place.uri), toRange(place.range));

async function activate(context) {
  const settings = vscode.workspace.getConfiguration('edulaunch');
  const folder = (vscode.workspace.workspaceFolders || [])[0];
  const home = folder && folder.uri.fsPath;
  server = new Server(commandOf(settings, home), home);
  const found = vscode.languages.createDiagnosticCollection('edulaunch');
  const kept = new Map();
  server.handlers['textDocument/publishDiagnostics'] = params => {
    kept.set(params.uri, params.diagnostics);
    found.set(vscode.Uri.parse(params.uri), params.diagnostics.map(one => {
      const shown = new vscode.Diagnostic(toRange(one.range), one.message, SEVERITIES[one.severity]);
      shown.source = one.source;
      shown.code = one.code;
      return shown;
    }));
  };
  await server.request('initialize', {
    processId: process.pid, rootUri: folder ? folder.uri.toString() : null, capabilities: {},
  });
  server.notify('initialized', {});
  const configure = () => {
    const runs = vscode.workspace.isTrusted && vscode.workspace.getConfiguration('edulaunch').get('runOnSave');
    server.notify('workspace/didChangeConfiguration', {settings: {edulaunch: {runOnSave: Boolean(runs)}}});
  };
  configure();

  const isOurs = document => vscode.languages.match(SELECTOR, document) > 0;
  const open = document => isOurs(document) && server.notify('textDocument/didOpen', {textDocument: {
    uri: document.uri.toString(), languageId: document.languageId, version: document.version, text: document.getText()}});
  vscode.workspace.textDocuments.forEach(open);

  const actions = {provideCodeActions(document, range) {
    const near = (kept.get(document.uri.toString()) || []).filter(one => one.data && toRange(one.range).intersection(range));
    return near.map(one => {
      const action = new vscode.CodeAction(one.data.title, vscode.CodeActionKind.QuickFix);
      action.edit = new vscode.WorkspaceEdit();
      one.data.changes.forEach(change => action.edit.replace(document.uri, toRange(change.range), change.newText));
      action.isPreferred = true;
      return action;
    });
  }};
  const completion = {async provideCompletionItems(document, position) {
    const items = await server.request('textDocument/completion', at(document, position)) || [];
    return items.map(one => {
      const item = new vscode.CompletionItem(one.label, (one.kind || 1) - 1);
      item.detail = one.detail;
      if (one.textEdit) {
        item.range = toRange(one.textEdit.range);
        item.insertText = one.textEdit.newText;
      }
      return item;
    });
  }};
  const hover = {async provideHover(document, position) {
    const result = await server.request('textDocument/hover', at(document, position));
    return result && new vscode.Hover(new vscode.MarkdownString(result.contents.value), result.range && toRange(result.range));
  }};
  const definition = {async provideDefinition(document, position) {
    const place = await server.request('textDocument/definition', at(document, position));
    return place && toLocation(place);
  }};
  const references = {async provideReferences(document, position) {
    const words = {...at(document, position), context: {includeDeclaration: true}};
    return (await server.request('textDocument/references', words) || []).map(toLocation);
  }};
  context.subscriptions.push(
    found,
    vscode.workspace.onDidOpenTextDocument(open),
    vscode.workspace.onDidChangeTextDocument(event => isOurs(event.document) && server.notify('textDocument/didChange', {
      textDocument: {uri: event.document.uri.toString(), version: event.document.version},
      contentChanges: [{text: event.document.getText()}]})),
    vscode.workspace.onDidSaveTextDocument(document => isOurs(document) && server.notify('textDocument/didSave', {
      textDocument: {uri: document.uri.toString()}})),
    vscode.workspace.onDidCloseTextDocument(document => isOurs(document) && server.notify('textDocument/didClose', {
      textDocument: {uri: document.uri.toString()}})),
    vscode.workspace.onDidChangeConfiguration(event => event.affectsConfiguration('edulaunch') && configure()),
    vscode.workspace.onDidGrantWorkspaceTrust(configure),
    vscode.languages.registerCodeActionsProvider(SELECTOR, actions, {providedCodeActionKinds: [vscode.CodeActionKind.QuickFix]}),
    vscode.languages.registerCompletionItemProvider(SELECTOR, completion, '\'', '"', '(', '<', '/', '.'),
    vscode.languages.registerHoverProvider(SELECTOR, hover),
    vscode.languages.registerDefinitionProvider(SELECTOR, definition),
    vscode.languages.registerReferenceProvider(SELECTOR, references),
  );
}

async function deactivate() {
  if (!server) return;
  await server.request('shutdown', null);
  server.notify('exit', null);
}

module.exports = {activate, deactivate};
