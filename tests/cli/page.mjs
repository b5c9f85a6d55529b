#!/usr/bin/env node
// Opens a local HTML file in Chromium without a window, and does what is asked, in the order that it is asked in.
// usage: page.mjs FILE.html [STEP]...
//   --size WxH       pixels of the window, at first 1280x800
//   --scheme light|dark
//   --media print    or screen
//   --eval JS        prints the value of an expression (of a promise, what it comes to): text as it is, all else as JSON
//   --key KEY        presses a key: a character, or ArrowLeft, Home and the like
//   --drag X,Y,X,Y   with the left button, from one place of the window to another
//   --shot FILE.png  what the window shows
//   --shot-all FILE.png  the page down to its end
// Exit status: 1 where the page threw, wrote an error to its console or asked for anything outside itself, an expression
// threw, or Chromium did not answer; 2 wrong usage.
// Speaks the DevTools protocol over two pipes, with Node's own library alone.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const longest_wait = 60000; // milliseconds, for all of it
const faults = [];

class Browser {
  constructor(program) {
    this.folder = mkdtempSync(join(tmpdir(), 'page-'));
    const flags = ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
      '--disable-dev-shm-usage', '--no-first-run', '--disable-extensions', '--disable-background-networking',
      '--disable-component-update', '--hide-scrollbars', '--mute-audio', '--remote-debugging-pipe',
      `--user-data-dir=${this.folder}`, 'about:blank'];
    this.process = spawn(program, flags, { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], detached: true });
    this.process.on('error', (error) => give_up(`${program}: ${error.message}`));
    this.process.on('exit', (status) => this.is_closing || give_up(`${program} ended with ${status}`));
    this.next_id = 1;
    this.answers = new Map();
    this.listeners = new Map();
    let rest = Buffer.alloc(0);
    this.process.stdio[4].on('data', (data) => {
      rest = Buffer.concat([rest, data]);
      for (let end = rest.indexOf(0); end >= 0; end = rest.indexOf(0)) {
        this.hear(JSON.parse(rest.subarray(0, end).toString()));
        rest = rest.subarray(end + 1);
      }
    });
    this.process.stdio[3].on('error', () => {});
  }
  hear(message) {
    if (message.id === undefined) return this.listeners.get(message.method)?.(message.params);
    const { good, bad } = this.answers.get(message.id);
    this.answers.delete(message.id);
    message.error ? bad(new Error(message.error.message)) : good(message.result);
  }
  call(method, params = {}) {
    const id = this.next_id++;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + '\0');
    return new Promise((good, bad) => this.answers.set(id, { good, bad }));
  }
  on(method, listener) { this.listeners.set(method, listener); }
  // Chromium's own children share its process group.
  close() {
    this.is_closing = true;
    try { process.kill(-this.process.pid, 'SIGKILL'); } catch { /* it has ended */ }
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 10, retryDelay: 100 });
  }
}

let browser = null;
function give_up(text, status = 1) {
  process.stderr.write(`page.mjs: ${text}\n`);
  browser?.close();
  process.exit(status);
}

async function open_page(url) {
  const { targetInfos } = await browser.call('Target.getTargets');
  const { targetId } = targetInfos.find((target) => target.type === 'page') ??
    await browser.call('Target.createTarget', { url: 'about:blank' });
  browser.session = (await browser.call('Target.attachToTarget', { targetId, flatten: true })).sessionId;
  browser.on('Runtime.exceptionThrown', ({ exceptionDetails: e }) => faults.push(e.exception?.description ?? e.text));
  browser.on('Runtime.consoleAPICalled', ({ type, args }) => {
    if (type === 'error' || type === 'assert') faults.push(args.map((a) => a.value ?? a.description).join(' '));
  });
  browser.on('Log.entryAdded', ({ entry }) => { if (entry.level === 'error') faults.push(`${entry.text} ${entry.url ?? ''}`); });
  browser.on('Network.requestWillBeSent', ({ request }) => {
    if (request.url !== url && !/^(data|blob):/.test(request.url)) faults.push(`asks for ${request.url}`);
  });
  for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await browser.call(`${domain}.enable`);
  const loaded = new Promise((done) => browser.on('Page.loadEventFired', done));
  const { errorText } = await browser.call('Page.navigate', { url });
  if (errorText) give_up(`${url}: ${errorText}`);
  await loaded;
}

async function evaluate(expression) {
  const { result, exceptionDetails: e } = await browser.call('Runtime.evaluate',
    { expression, awaitPromise: true, returnByValue: true, userGesture: true });
  if (e) give_up(`${expression}: ${e.exception?.description ?? e.text}`);
  return result.type === 'string' ? result.value : JSON.stringify(result.value ?? null);
}

async function shoot(file, is_whole) {
  await evaluate('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))');
  const { data } = await browser.call('Page.captureScreenshot', { captureBeyondViewport: is_whole, ...(is_whole && {
    clip: { ...(await browser.call('Page.getLayoutMetrics')).cssContentSize, scale: 1 } }) });
  writeFileSync(file, Buffer.from(data, 'base64'));
}

function set_size(text) {
  const [width, height] = text.split('x').map(Number);
  return browser.call('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
}

async function press(key) {
  const named = { Space: ' ' }[key] ?? key, text = named.length === 1 ? { text: named } : {};
  await browser.call('Input.dispatchKeyEvent', { type: 'keyDown', key: named, ...text });
  await browser.call('Input.dispatchKeyEvent', { type: 'keyUp', key: named });
}

async function drag(text) {
  const [from_x, from_y, to_x, to_y] = text.split(',').map(Number);
  const at = (type, share, buttons) => browser.call('Input.dispatchMouseEvent', { type, button: 'left', buttons,
    clickCount: 1, x: from_x + share * (to_x - from_x), y: from_y + share * (to_y - from_y) });
  await at('mousePressed', 0, 1);
  for (const share of [0.25, 0.5, 0.75, 1]) await at('mouseMoved', share, 1);
  await at('mouseReleased', 1, 0);
}

const shown = { media: 'screen', features: [] };
function show_as(change) { return browser.call('Emulation.setEmulatedMedia', Object.assign(shown, change)); }

const steps = {
  '--size': set_size,
  '--scheme': (value) => show_as({ features: [{ name: 'prefers-color-scheme', value }] }),
  '--media': (media) => show_as({ media }),
  '--eval': async (expression) => process.stdout.write(`${await evaluate(expression)}\n`),
  '--key': press,
  '--drag': drag,
  '--shot': (file) => shoot(file, false),
  '--shot-all': (file) => shoot(file, true),
};

const [file, ...asked] = process.argv.slice(2);
if (!file || asked.length % 2 !== 0 || asked.some((name, i) => i % 2 === 0 && !(name in steps))) {
  give_up(`usage: page.mjs FILE.html [${Object.keys(steps).join(' VALUE] [')} VALUE]`, 2);
}
if (!existsSync(file)) give_up(`${file}: expected a file, found nothing`);
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => give_up(`ended by ${signal}`));
setTimeout(() => give_up(`no answer within ${longest_wait / 1000} s`), longest_wait).unref();
browser = new Browser(process.env.CHROMIUM ?? 'chromium');
try {
  await open_page(pathToFileURL(resolve(file)).href);
  await set_size('1280x800');
  for (let i = 0; i < asked.length; i += 2) await steps[asked[i]](asked[i + 1]);
  await evaluate('new Promise((done) => setTimeout(done))'); // what was thrown in the meantime has been heard
} catch (error) {
  give_up(error.message);
}
if (faults.length > 0) give_up(faults.join('\n'));
browser.close();
