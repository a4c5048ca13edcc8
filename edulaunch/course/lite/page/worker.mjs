// Python in a worker: a program that never ends does not stop the page, and can be stopped.
import { loadPyodide } from './pyodide/pyodide.mjs';

const COURSE = '/home/pyodide/course';
const say = (text) => postMessage({ said: text });
let page;

async function get(name) {
    const answer = await fetch(new URL(name, self.location.href));
    if (!answer.ok) throw new Error(`${name} is missing on this server`);
    return answer;
}

async function begin() {
    if (!('Suspending' in WebAssembly)) {
        postMessage({ state: 'This browser cannot switch between tasks (JSPI). Chrome and Edge can, from version 137 on.' });
        return;
    }
    const began = performance.now();
    const python = await loadPyodide({
        indexURL: new URL('./pyodide/', self.location.href).href,
        stdout: (line) => say(`${line}\n`),
        stderr: (line) => say(`${line}\n`),
    });
    const site = await (await get('site.json')).json();
    if (site.packages.length) await python.loadPackage(site.packages, { messageCallback: () => {} });
    const packages = python.runPython('import sysconfig; sysconfig.get_path("purelib")');
    python.unpackArchive(await (await get('edulaunch.zip')).arrayBuffer(), 'zip', { extractDir: packages });
    python.unpackArchive(await (await get('course.zip')).arrayBuffer(), 'zip', { extractDir: COURSE });
    python.FS.chdir(COURSE);
    page = python.pyimport('edulaunch.course.lite.in_browser');
    postMessage({ files: JSON.parse(page.contents(COURSE)), ready: true, state: `ready after ${seconds(began)} s` });
}

const seconds = (began) => ((performance.now() - began) / 1000).toFixed(1);

self.onmessage = async ({ data }) => {
    const began = performance.now();
    const path = `${COURSE}/exercises/${data.name}`;
    const answer = data.what === 'launch'
        ? await page.launch.callPromising(path, data.text, data.words, data.seconds, say)
        : await page.check.callPromising(path, data.text);
    postMessage({ answer: JSON.parse(answer), ready: true, state: `done after ${seconds(began)} s` });
};

begin();
