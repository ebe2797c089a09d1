# SPDX-License-Identifier: MIT
"""Pages as children draw them, for the detector: characters side by side on a ground line or anywhere, and things around them that are no
characters (shards of dataset.py --source things). Only the characters are truth."""
import json

import cv2
import numpy as np

import dataset
import pages
import tone

# What is drawn where, how often, and how large (longer side relative to the page's shorter one).
SKY, STANDING, GROUND, WRITTEN, ANYWHERE, AROUND = range(6)
PLACES = {
    "sun": (SKY, 20, 0.14, 0.42), "moon": (SKY, 4, 0.08, 0.25), "star": (SKY, 5, 0.06, 0.25), "cloud": (SKY, 9, 0.15, 0.45),
    "rain": (SKY, 3, 0.2, 0.5), "rainbow": (SKY, 4, 0.3, 0.9), "balloon": (SKY, 3, 0.15, 0.4), "heart": (ANYWHERE, 5, 0.06, 0.3),
    "house": (STANDING, 14, 0.25, 0.7), "tree": (STANDING, 9, 0.25, 0.75), "fir": (STANDING, 5, 0.25, 0.6),
    "flower": (STANDING, 8, 0.12, 0.4), "grass line": (GROUND, 16, 0.4, 1.0), "grass tuft": (STANDING, 6, 0.06, 0.2),
    "hill": (GROUND, 5, 0.5, 1.0), "mountain": (STANDING, 3, 0.3, 0.8), "fence": (STANDING, 5, 0.2, 0.7),
    "car": (STANDING, 6, 0.2, 0.5), "boat": (STANDING, 3, 0.2, 0.5), "ball": (ANYWHERE, 4, 0.05, 0.2),
    "table": (STANDING, 5, 0.2, 0.5), "arrow": (ANYWHERE, 3, 0.1, 0.4), "frame": (AROUND, 4, 0.9, 1.0),
    "word": (WRITTEN, 12, 0.1, 0.6), "sentence": (WRITTEN, 6, 0.3, 0.9), "scrawl": (WRITTEN, 6, 0.2, 0.8),
    "signature": (WRITTEN, 3, 0.1, 0.35)}
NAMES = list(PLACES)


class Things:
    """the things of a folder of shards, by species."""

    def __init__(self, folder):
        shards, self.of = dataset.Shards(folder, {"things": 1}).sources["things"], {}
        for images, facts in shards.values():
            for k, (species, *_) in enumerate(facts):
                self.of.setdefault(dataset.THINGS[species], []).append((images, k))
        self.names = [name for name in NAMES if name in self.of]
        weights = np.array([PLACES[name][1] for name in self.names], float)
        self.weights = weights / weights.sum()

    def draw(self, rng):
        """species and ink (h, w) uint8, cut to its box."""
        name = self.names[rng.choice(len(self.names), p=self.weights)]
        images, k = self.of[name][rng.integers(len(self.of[name]))]
        ink = np.asarray(images[k, 0])
        ys, xs = np.nonzero(ink > 40)
        return name, ink[ys.min():ys.max() + 1, xs.min():xs.max() + 1]


class Drawn:
    """whole pages of `doodle --scene`, several folders of them: ink and masks as compose gives them."""

    def __init__(self, folders):
        self.pages = [f"{folder}/{{}}/{json.loads(line)['id']}.png" for folder in folders for line in open(f"{folder}/index.ndjson")]

    def draw(self, rng):
        path = self.pages[rng.integers(len(self.pages))]
        ink = (tone.ink_darkness(cv2.imread(path.format("image"))[:, :, ::-1]) * 255 + 0.5).astype(np.uint8)
        numbers = cv2.imread(path.format("instance"), cv2.IMREAD_GRAYSCALE)
        if rng.random() < 0.5:
            ink, numbers = ink[:, ::-1], numbers[:, ::-1]
        h, w = ink.shape
        if rng.random() < 0.5:                                    # a part of the page that keeps its characters
            ys, xs = np.nonzero(numbers)
            y, x = int(ys.min() * rng.random()), int(xs.min() * rng.random())
            b, a = int(rng.uniform(ys.max() + 1, h + 1)), int(rng.uniform(xs.max() + 1, w + 1))
            ink, numbers = ink[y:b, x:a], numbers[y:b, x:a]
        masks = np.array([numbers == k for k in range(1, numbers.max() + 1)], bool)
        return dataset.as_photographed(np.ascontiguousarray(ink), rng), masks


def resized(ink, height, width):
    shrink = min(height / ink.shape[0], width / ink.shape[1])
    if shrink < 0.6:                                              # thin lines survive: blurred before they shrink
        ink = cv2.GaussianBlur(ink, (0, 0), 0.35 / shrink)
    return cv2.resize(ink, (max(2, int(width)), max(2, int(height))), interpolation=cv2.INTER_LINEAR)


def coloured(ink, labels, rng):
    """the drawing filled in, part by part or whole, from pale to darker than the pen; at times without its lines."""
    lines = ink if rng.random() < 0.8 else np.zeros_like(ink)
    whole, fill = rng.uniform(0.12, 1.0), np.zeros(ink.shape, np.float32)
    for part in np.unique(labels[labels > 0]):
        if lines is not ink or rng.random() < 0.8:
            fill[labels == part] = whole if rng.random() < 0.4 else rng.uniform(0.12, 1.0)
    if rng.random() < 0.5:                                        # the crayon's strokes
        y, x = np.mgrid[:ink.shape[0], :ink.shape[1]]
        angle, period = rng.uniform(0, np.pi), rng.uniform(3, 9)
        fill *= np.clip(0.75 + 0.5 * np.sin((x * np.cos(angle) + y * np.sin(angle)) * 2 * np.pi / period), 0, 1)
    return np.maximum(lines, np.clip(255 * cv2.GaussianBlur(fill, (0, 0), 1.0), 0, 255).astype(np.uint8))


def character(shards, rng):
    """ink and mask of one drawing, cut to its box; a third is filled in."""
    ink, labels, *_ = shards.draw(rng)
    labels = np.asarray(labels)
    return pages.cut(coloured(np.asarray(ink), labels, rng) if rng.random() < 0.35 else ink, labels > 0)


class Scene:
    """a page on the way: ink, where characters are, where anything is."""

    def __init__(self, h, w):
        self.page, self.masks = np.zeros((h, w), np.uint8), []
        self.characters, self.taken = np.zeros((h, w), bool), np.zeros((h, w), bool)

    def window(self, ink, y, x):
        """the slices of page and ink where ink at (y, x) lies on the page."""
        h, w = self.page.shape
        a, b = ink.shape
        y0, x0, y1, x1 = max(0, y), max(0, x), min(h, y + a), min(w, x + b)
        if y1 <= y0 or x1 <= x0:
            return None
        return np.s_[y0:y1, x0:x1], np.s_[y0 - y:y1 - y, x0 - x:x1 - x]

    def add_character(self, ink, mask, y, x):
        """False where it would meet another one."""
        place = self.window(ink, y, x)
        if place is None:
            return False
        there, here = place
        around = cv2.dilate(self.characters.astype(np.uint8), np.ones((5, 5), np.uint8))[there] > 0
        if (around & (mask | (ink > 40))[here]).any() or mask[here].sum() < 0.7 * mask.sum():
            return False
        self.page[there] = np.maximum(self.page[there], ink[here])
        whole = np.zeros(self.page.shape, bool)
        whole[there] = mask[here]
        self.masks.append(whole)
        self.characters |= whole
        self.taken[there] |= mask[here] | (ink[here] > 40)
        return True

    def add_thing(self, ink, y, x, through=False):
        """behind the characters, or, like a line of grass, through them."""
        place = self.window(ink, y, x)
        if place is None:
            return
        there, here = place
        shown = ink[here] if through else np.where(self.characters[there], 0, ink[here])
        self.page[there] = np.maximum(self.page[there], shown)
        self.taken[there] |= ink[here] > 40

    def meets(self, ink, y, x):
        place = self.window(ink, y, x)
        if place is None:
            return False
        there, here = place
        return bool((self.taken[there] & (cv2.dilate(ink[here], np.ones((7, 7), np.uint8)) > 40)).any())

    def feet(self, rng):
        """a height at which one of the characters stands, or any."""
        if self.masks and rng.random() < 0.8:
            return int(np.nonzero(self.masks[rng.integers(len(self.masks))].any(1))[0].max())
        return int(rng.uniform(0.5, 1.0) * self.page.shape[0])


def place_row(scene, shards, rng):
    """characters side by side, upright, nearly on one line."""
    h, w = scene.page.shape
    count = int(rng.choice([1, 2, 3, 4, 5], p=[0.15, 0.25, 0.25, 0.2, 0.15]))
    ground, cell = h * rng.uniform(0.6, 0.98), w * rng.uniform(0.7, 1.0) / count
    left = rng.uniform(0, w - cell * count)
    for k in range(count):
        side = h * rng.uniform(0.25, 0.75)
        drawing = pages.fitting(*character(shards, rng), side, rng.normal(0, 5), int(cell), int(min(ground, 0.9 * h)), rng)
        if drawing is not None:
            a, b = drawing[1].shape
            foot = ground + h * rng.normal(0, 0.015)
            scene.add_character(*drawing, int(min(foot, h)) - a, int(left + k * cell + rng.uniform(0, max(1, cell - b))))


def place_anywhere(scene, shards, rng):
    h, w = scene.page.shape
    count = int(rng.choice([0, 1, 2, 3, 4, 5], p=[0.08, 0.3, 0.24, 0.2, 0.1, 0.08]))
    for _ in range(count):
        side = min(w, h) * rng.uniform(0.22, 1.1 if count == 1 else 0.6)
        drawing = pages.fitting(*character(shards, rng), side, pages.random_angle(rng), w, h, rng)
        for _ in range(12):
            if drawing is not None and scene.add_character(*drawing, int(rng.integers(0, h - drawing[1].shape[0])),
                                                           int(rng.integers(0, w - drawing[1].shape[1]))):
                break


def strip(scene, ink, size, rng):
    """a line of grass or a hill across the page, at somebody's feet, in front of them at times."""
    h, w = scene.page.shape
    width = w * size
    height = min(width * ink.shape[0] / ink.shape[1] * rng.uniform(0.7, 2.0), 0.4 * h)
    ink = resized(ink, height, width)
    y = scene.feet(rng) - int(ink.shape[0] * rng.uniform(0.0, 1.1)) + int(rng.normal(0, 0.02) * h)
    scene.add_thing(ink, y, int(rng.uniform(-0.05, 1.05 - size) * w), rng.random() < 0.4)


def corner_of(place, scene, ink, rng):
    """where the upper left corner of a thing goes."""
    h, w = scene.page.shape
    a, b = ink.shape
    x = int(rng.uniform(-0.1 * b, w - 0.9 * b))
    if place == SKY:
        if rng.random() < 0.35:                                   # in a corner that cuts it
            return -int(a * rng.uniform(0.1, 0.6)), int(-b * rng.uniform(0.1, 0.6)) if rng.random() < 0.5 else w - int(b * rng.uniform(0.4, 0.9))
        return int(rng.uniform(0, 0.35) * h), x
    if place == STANDING:
        return scene.feet(rng) - a + int(rng.normal(0, 0.02) * h), x
    if place == WRITTEN and rng.random() < 0.6:
        return int(h * (rng.uniform(0.0, 0.1) if rng.random() < 0.5 else rng.uniform(0.85, 0.97)) - 0.5 * a), x
    return int(rng.uniform(0, max(1, h - a))), x


def add_things(scene, things, rng):
    h, w = scene.page.shape
    for _ in range(int(rng.integers(1, 7))):
        name, ink = things.draw(rng)
        place, _, least, most = PLACES[name]
        size = rng.uniform(least, most)
        ink = (ink * rng.uniform(0.35, 1.0)).astype(np.uint8)     # paler than the pen of the characters, or as dark
        if place != WRITTEN and rng.random() < 0.5:
            ink = ink[:, ::-1]
        if place == AROUND:
            ink = resized(ink, size * h, size * w)
            scene.add_thing(ink, (h - ink.shape[0]) // 2, (w - ink.shape[1]) // 2)
        elif place == GROUND:
            strip(scene, ink, size, rng)
        else:
            scale = size * min(w, h) / max(ink.shape)
            ink = resized(ink, scale * ink.shape[0], scale * ink.shape[1])
            apart = rng.random() < 0.75
            for _ in range(15):
                y, x = corner_of(place, scene, ink, rng)
                if not apart or not scene.meets(ink, y, x):
                    scene.add_thing(ink, y, x, rng.random() < 0.1)
                    break


def compose(shards, things, rng, longer=pages.LONGER):
    """ink (h, w) float32 in [0, 1] and masks (n, h, w) bool, as pages.compose."""
    shorter = int(longer * rng.uniform(0.6, 1.0))
    w, h = (longer, shorter) if rng.random() < 0.75 else (shorter, longer)
    scene = Scene(h, w)
    (place_row if rng.random() < 0.55 else place_anywhere)(scene, shards, rng)
    add_things(scene, things, rng)
    page = scene.page
    if rng.random() < 0.3:
        page = pages.stray_marks(page, cv2.dilate(scene.taken.astype(np.uint8), np.ones((9, 9), np.uint8)) == 0, rng)
    return dataset.as_photographed(page, rng), np.array(scene.masks, bool).reshape(-1, h, w)
