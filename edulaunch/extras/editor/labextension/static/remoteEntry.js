// Gives cells that begin with `%%writefile NAME.launch.py` to the language server, as documents of their own.
// JupyterLab loads this file as it is. The whole cell is the document, so that lines stay the same and the server sees the name.
(() => {
  const FIRST = /^%%(?:writefile|file)\s+(?:-a\s+)?["']?(\S*?(?:[._]launch\.py|\.launch\.xml|\.launch\.ya?ml|\.py))["']?\s*(?:\n|$)/;
  let shared;

  const extractor = {
    language: 'launch-python',
    fileExtension: 'launch.py',
    standalone: true,
    cellType: ['code'],
    hasForeignCode: code => FIRST.test(code),
    extractForeignCode: code => {
      const lines = code.split('\n');
      const last = lines.length - 1;
      return [{
        hostCode: '',
        foreignCode: code,
        range: {start: {line: 0, column: 0}, end: {line: last, column: lines[last].length}},
        virtualShift: null,
      }];
    },
  };

  function catchUp(manager, cell) {
    // JupyterLab does not tell a server what was typed while the server started; it tells with the next change of the notebook.
    if (cell.language !== extractor.language) return;
    setTimeout(() => manager.adapters.get(cell.root.path)?.updateDocuments(), 500);
  }

  async function load() {
    // A JupyterLab without language servers must start all the same.
    const {ILSPCodeExtractorsManager, ILSPDocumentConnectionManager} = await shared('@jupyterlab/lsp').catch(() => ({}));
    return {
      __esModule: true,
      default: {
        id: 'edulaunch-cells:plugin',
        autoStart: true,
        optional: ILSPCodeExtractorsManager ? [ILSPCodeExtractorsManager, ILSPDocumentConnectionManager] : [],
        activate: (app, extractors, connections) => {
          extractors?.register(extractor, 'python');
          connections?.connected.connect((manager, {virtualDocument}) => catchUp(manager, virtualDocument));
        },
      },
    };
  }

  window._JUPYTERLAB = window._JUPYTERLAB || {};
  window._JUPYTERLAB['edulaunch-cells'] = {
    init: scope => {
      shared = async name => {
        const versions = Object.values(scope[name]);
        return (await versions[versions.length - 1].get())();
      };
    },
    get: async () => {
      const module = await load();
      return () => module;
    },
  };
})();
