// The page: a file to edit, its launch and its check in a worker, and what comes of them.
const $ = (name) => document.getElementById(name);
const KEPT = 'edulaunch:';
let files = [], worker, isReady = false;

const chosen = () => files[$('files').selectedIndex];
const tell = (text) => { $('state').textContent = text; };
const log = (text) => { $('log').textContent += text; $('log').scrollTop = $('log').scrollHeight; };

function allow(ready) {
    isReady = ready;
    $('launch').disabled = !ready;
    $('check').disabled = !ready || !chosen()?.exercise;
    $('stop').disabled = ready;
}

function begin() {
    worker = new Worker('worker.mjs', { type: 'module' });
    worker.onmessage = ({ data }) => {
        if (data.files) show(data.files);
        if (data.said) log(data.said);
        if (data.state) tell(data.state);
        if (data.answer) answered(data.answer);
        if (data.ready) allow(true);
    };
    worker.onerror = (event) => { tell('It broke. Load this page again.'); log(`${event.message}\n`); };
}

function answered(answer) {
    if (answer.error) log(`${answer.error}\n`);
    if (answer.said) log(answer.said);
    if (answer.page) $('page').srcdoc = answer.page;
}

function show(found) {
    if (files.length) return;
    files = found;
    for (const file of files) $('files').add(new Option(file.exercise ? file.title : `${file.title} (${file.name})`));
    choose();
}

function choose() {
    const file = chosen();
    $('text').value = localStorage.getItem(KEPT + file.name) ?? file.text;
    if (isReady) allow(true);
}

function ask(what) {
    $('log').textContent = '';
    allow(false);
    tell(what === 'launch' ? 'launching' : 'checking');
    const file = chosen();
    worker.postMessage({ what, name: file.name, text: $('text').value, words: $('words').value, seconds: Number($('seconds').value) });
}

$('files').onchange = choose;
$('text').oninput = () => localStorage.setItem(KEPT + chosen().name, $('text').value);
$('text').onkeydown = (event) => {
    if (event.key !== 'Tab' || event.shiftKey || event.ctrlKey) return;
    event.preventDefault();
    document.execCommand('insertText', false, '    ');
};
$('launch').onclick = () => ask('launch');
$('check').onclick = () => ask('check');
$('stop').onclick = () => { worker.terminate(); log('\nstopped\n'); allow(false); tell('loading Python again'); begin(); };
$('again').onclick = () => { localStorage.removeItem(KEPT + chosen().name); choose(); };
begin();
