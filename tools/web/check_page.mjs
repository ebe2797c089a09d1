// SPDX-License-Identifier: MIT
// Checks a page of `pantin explain` in headless Chromium, from the file system, without a network: nothing is asked for, nothing fails, every
// chapter's picture can be seen, sliders, clicks and keys do what the chapters say; in light and dark, on a desk and on a phone, with
// and without scripts. Prints a line a check; exit code 1 when one fails.
// usage: node check_page.mjs INDEX.html [FOLDER_FOR_SCREENSHOTS]. Needs playwright-core beside it and Debian's chromium.
import {mkdirSync, statSync} from 'node:fs';
import {resolve} from 'node:path';
import {chromium} from 'playwright-core';

const [file, shots] = process.argv.slice(2);
if (!file) {
    console.error('usage: check_page.mjs INDEX.html [FOLDER_FOR_SCREENSHOTS]');
    process.exit(2);
}
const address = 'file://' + resolve(file);
if (shots) mkdirSync(shots, {recursive: true});

let passed = 0, failed = 0;
const check = (what, ok, detail = '') => {
    ok ? ++passed : ++failed;
    if (!ok || process.env.VERBOSE) console.log(`${ok ? 'ok    ' : 'FAILED'} ${what}${detail === '' ? '' : ': ' + detail}`);
};

const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
        '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

// A page that keeps what goes wrong on it.
const open = async (name, options) => {
    const context = await browser.newContext({offline: true, viewport: {width: 1100, height: 900}, ...options});
    const page = await context.newPage();
    page.troubles = [];
    page.on('console', m => ['error', 'warning'].includes(m.type()) && page.troubles.push(m.text()));
    page.on('pageerror', e => page.troubles.push(e.message));
    // Blobs are memory of the page itself: the viewer unpacks its textures through them.
    page.on('request', r => !/^(data|blob):/.test(r.url()) && r.url() !== address && page.troubles.push('asked for ' + r.url().slice(0, 100)));
    await page.goto(address);
    page.done = async () => {
        const real = page.troubles.filter(t => !/GPU stall|GL Driver Message|willReadFrequently/.test(t)); // of software GL, and of these checks' own reading
        check(`${name}: no error, no warning, no request`, real.length === 0, real.slice(0, 3).join(' | '));
        await context.close();
    };
    return page;
};

const chapter_ids = page => page.$$eval('article.chapter', all => all.map(a => a.id));
const ready = (page, id) => page.waitForFunction(i => document.getElementById(i).dataset.ready === 'yes', id, {timeout: 120000});
const go_to = async (page, id) => {
    await page.evaluate(i => document.getElementById(i).scrollIntoView(), id);
    if (await page.$(`#${id}[data-widget] .controls, #${id}[data-widget] script.data`)) await ready(page, id);
    if (await page.$(`#${id} .viewer`)) await runs(page, id);
};
// All widgets but the viewers have started.
const pass_by = async page => {
    for (const id of await chapter_ids(page)) {
        await page.evaluate(i => document.getElementById(i).scrollIntoView(), id);
        if (!/-(motion|solid)$/.test(id) && await page.$(`#${id} .controls, #${id} script.data`)) await ready(page, id);
    }
};
// The viewer has taken the film's place.
const runs = async (page, id) => {
    await page.locator(`#${id} .viewer`).scrollIntoViewIfNeeded();
    await page.waitForFunction(i => document.querySelector(`#${i} .viewer`).dataset.running === 'yes', id, {timeout: 120000});
};

// Whether what an element shows has more than one colour.
const is_painted = async (page, locator) => {
    const picture = (await locator.screenshot()).toString('base64');
    return page.evaluate(async data => {
        const image = new Image();
        image.src = 'data:image/png;base64,' + data;
        await image.decode();
        const canvas = document.createElement('canvas');
        canvas.width = image.width;
        canvas.height = image.height;
        const context = canvas.getContext('2d');
        context.drawImage(image, 0, 0);
        const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data, colours = new Set();
        for (let i = 0; i < pixels.length && colours.size < 8; i += 4) colours.add(pixels[i] << 16 | pixels[i + 1] << 8 | pixels[i + 2]);
        return colours.size >= 4;
    }, picture);
};

async function check_pictures(page, name) {
    for (const id of await chapter_ids(page)) {
        await go_to(page, id);
        const pictures = page.locator(`#${id} svg.picture:visible, #${id} canvas:visible, #${id} img:visible, #${id} table.matrix:visible`);
        const count = await pictures.count();
        check(`${name}: ${id} shows something`, count > 0);
        if (count > 0) check(`${name}: ${id}: its picture is visible`, await is_painted(page, pictures.first()));
        if (shots) await page.locator('#' + id).screenshot({path: `${shots}/${name}-${id}.png`});
    }
}

async function check_voronoi(page, id) {
    await go_to(page, id);
    const slider = page.locator(`#${id} input[type=range]`), output = page.locator(`#${id} output`);
    const kept = async () => +(/: (\d+) of/.exec(await output.textContent()) || [])[1];
    const drawn = () => page.$$eval(`#${id} .edges path`, paths => paths.slice(1).reduce((n, p) => n + (p.getAttribute('d').match(/M/g) || []).length, 0));
    const counts = [];
    for (const share of [0, 0.25, 0.5, 1]) {
        await slider.evaluate((s, v) => {
            s.value = v * s.max;
            s.dispatchEvent(new Event('input'));
        }, share);
        counts.push(await kept());
        check(`${id}: as many edges are drawn as are counted`, await drawn() === counts.at(-1), `${await drawn()} of ${counts.at(-1)}`);
    }
    check(`${id}: a larger threshold keeps fewer`, counts.every((c, i) => i === 0 || c <= counts[i - 1]) && counts[0] > counts[3], counts.join(' '));
    await slider.focus();
    const before = await slider.inputValue();
    await page.keyboard.press('ArrowLeft');
    check(`${id}: the slider answers keys`, await slider.inputValue() !== before);
}

async function check_thinning(page, id) {
    await go_to(page, id);
    const root = page.locator('#' + id), slider = root.locator('input[type=range]'), canvas = root.locator('canvas'), judgement = root.locator('.judgement');
    await root.locator('select').selectOption('silhouette');
    await page.waitForFunction(i => +document.querySelector(`#${i} input[type=range]`).max > 1, id);
    const black = () => canvas.evaluate(c => {
        const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
        let n = 0;
        for (let i = 0; i < d.length; i += 4) n += d[i] < 40 && d[i + 1] < 40 && d[i + 2] < 40;
        return n;
    });
    const at_start = await black(), last = +(await slider.getAttribute('max'));
    await slider.evaluate(s => {
        s.value = s.max;
        s.dispatchEvent(new Event('input'));
    });
    check(`${id}: thinning takes pixels away`, await black() < at_start / 2, `${at_start} to ${await black()} in ${last}`);
    // The verdict about a pixel is what the data say of it: orange ones go in the next sub-iteration, black ones stay.
    await slider.evaluate(s => {
        s.value = 0;
        s.dispatchEvent(new Event('input'));
    });
    const places = await canvas.evaluate(c => {
        const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, found = {}, zoom = +c.dataset.zoom;
        const middle = v => (Math.floor(v / zoom) + 0.5) * zoom; // of a pixel of the drawing
        for (let i = 0; i < d.length; i += 4 * 7) {
            const [r, g, b] = [d[i], d[i + 1], d[i + 2]], x = (i / 4) % c.width, y = Math.floor(i / 4 / c.width), at = [middle(x) / c.width, middle(y) / c.height];
            if (r > 200 && g > 80 && g < 110 && b < 20) (found.goes ||= []).push(at);
            if (r < 40 && g < 40 && b < 40) (found.stays ||= []).push(at);
        }
        const some = list => [0.1, 0.35, 0.6, 0.85].map(share => list[Math.floor(share * list.length)]);
        return {goes: some(found.goes), stays: some(found.stays)};
    });
    for (const verdict of ['goes', 'stays'])
        for (const [x, y] of places[verdict]) {
            const [width, height] = await canvas.evaluate(c => [c.clientWidth, c.clientHeight]);
            await canvas.click({position: {x: x * width, y: y * height}});
            const text = await judgement.textContent();
            check(`${id}: a pixel that ${verdict} is said to`, text.includes(`It ${verdict} in sub-iteration 1`), text.slice(0, 160));
        }
    await canvas.focus();
    const before = await judgement.textContent();
    await page.keyboard.press('ArrowRight');
    check(`${id}: arrow keys choose another pixel`, await judgement.textContent() !== before);
    await root.locator('button.play').click();
    await page.waitForFunction(i => +document.querySelector(`#${i} input[type=range]`).value > 0, id, {timeout: 60000});
    check(`${id}: play plays`, true);
}

async function check_paths(page, id) {
    await go_to(page, id);
    const root = page.locator('#' + id);
    if (await root.locator('.similarity td').count() === 0) return;
    const state = () => root.evaluate(r => [...r.querySelectorAll('.curves path, .track')].map(p => p.getAttribute('d')).join('|') + r.querySelector('.bijection').textContent);
    const cells = root.locator('.similarity td:not(.chosen)');
    const before = await state();
    await cells.first().focus();
    await page.keyboard.press('Enter');
    const after = await state();
    check(`${id}: a cell opens its bijection, by keyboard`, after !== before);
    const inner = root.locator('.bijection td:not(.looked)');
    if (await inner.count()) {
        await inner.last().click();
        check(`${id}: a cell of it shows its two paths`, await state() !== after);
    }
    const [chosen, cost] = await root.evaluate(r => [[...r.querySelectorAll('.bijection td.chosen')].map(td => +td.dataset.i + ',' + td.dataset.j), r.querySelector('.similarity td.chosen').textContent]);
    check(`${id}: the bijection keeps the order`, chosen.every((c, i) => i === 0 || (+c.split(',')[0] > +chosen[i - 1].split(',')[0] && +c.split(',')[1] > +chosen[i - 1].split(',')[1])), chosen.join(' '));
    check(`${id}: its cost is the table's`, (await root.locator('.bijection .pair').textContent()).includes(String(+cost).slice(0, 4)), cost);
}

async function check_weights(page, id) {
    await go_to(page, id);
    const fills = () => page.$$eval(`#${id} .faces path`, paths => paths.map(p => p.getAttribute('fill')));
    const mixed = await fills(), select = page.locator(`#${id} select`);
    const values = await select.locator('option').evaluateAll(all => all.map(o => o.value));
    await select.selectOption(values[1]);
    const one = await fills();
    await select.selectOption(values.at(-1));
    const other = await fills();
    check(`${id}: every bone has a heat map of its own`, String(one) !== String(mixed) && String(other) !== String(one));
    await select.selectOption('');
    check(`${id}: and back to all`, String(await fills()) === String(mixed));
}

async function check_viewer(page, id) {
    await go_to(page, id);
    const root = page.locator('#' + id), canvas = root.locator('canvas');
    const screenshot = async () => (await canvas.screenshot()).toString('base64');
    const moves = async () => {
        const first = await screenshot();
        await page.waitForTimeout(400);
        return first !== await screenshot();
    };
    await root.locator('.turn').setChecked(false);
    check(`${id}: the character is there`, await is_painted(page, canvas));
    check(`${id}: it moves`, await moves());
    await root.locator('button.play').click();
    await page.waitForTimeout(300);
    check(`${id}: pause stops it`, !await moves());
    const still = await screenshot();
    await root.locator('.bones').check();
    await page.waitForTimeout(300);
    const with_bones = await screenshot();
    check(`${id}: bones are drawn`, with_bones !== still);
    await root.locator('.mesh').check();
    await page.waitForTimeout(300);
    check(`${id}: the mesh is drawn`, await screenshot() !== with_bones);
    await canvas.focus();
    const flat = await screenshot();
    await page.keyboard.press('ArrowRight');
    await page.waitForTimeout(300);
    check(`${id}: arrow keys turn it`, await screenshot() !== flat);
    await root.locator('button.play').click();
    await root.locator('.speed').evaluate(s => {
        s.value = 0;
        s.dispatchEvent(new Event('input'));
    });
    await page.waitForTimeout(300);
    check(`${id}: speed 0 stands still`, !await moves());
}

// WCAG 2: 4.5 for text. Of every element with text of its own, against the nearest background.
const low_contrasts = page => page.evaluate(() => {
    const parse = c => (c.match(/[\d.]+/g) || []).map(Number);
    const light = ([r, g, b]) => {
        const f = v => (v /= 255) <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
        return 0.2126 * f(r) + 0.7152 * f(g) + 0.0722 * f(b);
    };
    const bad = [];
    for (const e of document.querySelectorAll('main *, header *, nav *, footer *')) {
        if (e.closest('svg') || !e.offsetParent || ![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim())) continue;
        let back = e;
        while (back && (parse(getComputedStyle(back).backgroundColor)[3] ?? 1) === 0) back = back.parentElement;
        if (['BUTTON', 'SELECT', 'OPTION'].includes(e.tagName)) continue; // the browser's own
        const a = light(parse(getComputedStyle(e).color)), b = light(parse(back ? getComputedStyle(back).backgroundColor : 'rgb(255,255,255)'));
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (ratio < 4.5) bad.push(`${e.tagName.toLowerCase()} "${e.textContent.trim().slice(0, 20)}" ${ratio.toFixed(1)}`);
    }
    return bad;
});

const size = statSync(file).size;
check('the page is smaller than 15 MB', size < 15e6, (size / 1e6).toFixed(1) + ' MB');

try {
    // On a desk, light.
    const page = await open('desk', {});
    const times = await page.evaluate(() => performance.timing.domInteractive - performance.timing.navigationStart);
    const until = await page.evaluate(() => performance.now());
    check('the page answers within 2 s', times < 2000 && until < 4000, `interactive after ${times} ms`);
    console.log(`${file}: ${(size / 1e6).toFixed(1)} MB, interactive after ${times} ms`);
    await check_pictures(page, 'desk');
    for (const id of await chapter_ids(page)) {
        if (id.endsWith('-voronoi')) await check_voronoi(page, id);
        if (id.endsWith('-thinning')) await check_thinning(page, id);
        if (id.endsWith('-paths')) await check_paths(page, id);
        if (id.endsWith('-weights')) await check_weights(page, id);
        if (id.endsWith('-motion') || id.endsWith('-solid')) await check_viewer(page, id);
    }
    const unnamed = await page.evaluate(() => [...document.querySelectorAll('input, select, button, canvas, img, svg.picture, svg.icon')]
        .filter(e => !(e.closest('label')?.textContent.trim() || e.getAttribute('aria-label') || e.getAttribute('alt') || e.textContent.trim())).map(e => e.outerHTML.slice(0, 80)));
    check('every control and picture has a name', unnamed.length === 0, unnamed.join(' '));
    await page.done();

    for (const name of ['dark', 'light']) {
        const p = await open(name, {colorScheme: name});
        await pass_by(p);
        await p.evaluate(() => document.querySelectorAll('details').forEach(d => (d.open = true)));
        const low = await low_contrasts(p);
        check(`${name}: text is readable (contrast of 4.5)`, low.length === 0, low.slice(0, 5).join('; '));
        if (shots) await p.screenshot({path: `${shots}/${name}.png`});
        await p.done();
    }

    const phone = await open('phone', {viewport: {width: 360, height: 740}, isMobile: true, hasTouch: true});
    await pass_by(phone);
    const wide = await phone.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    check('phone: nothing is wider than the window', wide <= 0, wide + ' pixels');
    if (shots) await phone.screenshot({path: `${shots}/phone.png`});
    await phone.done();

    const plain = await open('without scripts', {javaScriptEnabled: false});
    const controls = await plain.locator('.controls:visible').count();
    check('without scripts: no control that does nothing', controls === 0);
    for (const id of (await plain.locator('article.chapter').evaluateAll(all => all.map(a => a.id)).catch(() => []))) {
        const picture = plain.locator(`#${id} svg.picture, #${id} img, #${id} table.matrix`).first();
        check(`without scripts: ${id} shows something`, await picture.isVisible());
    }
    await plain.done();
} finally {
    await browser.close();
}
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);
