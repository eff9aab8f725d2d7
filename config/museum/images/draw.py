#!/usr/bin/env python3
"""Draws the sample museum's pictures: config/museum/images/draw.py writes one SVG for each exhibit beside itself.

Those that stand in the museum as things have a second one: cut/NAME.svg, without its ground, of what is cut out as a relief, and round/NAME.svg,
of what lies round something turned. The exhibits are invented, and so are their pictures: solids of revolution, slabs and figures built from a few curves, lit from the upper left like
the model of the building, on the house's paper. Standard library only; the same bytes every time.
"""
import math
import pathlib
import random

SIZE = 960
HERE = pathlib.Path(__file__).parent

# Each material: edge, body, light, deep (for incised lines).
MATERIALS = {
    'bronze': ('#2f3f38', '#5f7a63', '#b9cfa6', '#1f2b26'),
    'gold': ('#7a4f12', '#c8922b', '#fbe6a3', '#5d3b0c'),
    'jade': ('#3d6350', '#7fae8f', '#dcf0dc', '#2c4a3b'),
    'clay': ('#7d3f22', '#bd7142', '#eebf8d', '#5a2b16'),
    'pale clay': ('#8d7455', '#cdb28a', '#f4e6c8', '#5f4c34'),
    'stone': ('#6d6658', '#a79d8a', '#ded6c4', '#4a4439'),
    'dark stone': ('#33332f', '#5d5b55', '#96938a', '#232320'),
    'bone': ('#9a8560', '#dccba4', '#fbf4de', '#5e4c31'),
    'glass': ('#2f6f73', '#7fc0bb', '#e8fbf5', '#1e5154'),
    'wood': ('#5b3b20', '#8c6238', '#c89b66', '#3d2614'),
    'glaze': ('#7c4a12', '#c07f25', '#f3cf84', '#3f6b43'),
}


class Picture:
    """An SVG under construction: y grows downward, the ground line is at y = 800."""

    def __init__(self, name, tint='#e7dcc6'):
        self.name, self.body, self.defs, self.count = name, [], [], 0
        self.random = random.Random(name)
        self.defs.append(
            f'<radialGradient id="room" cx=".38" cy=".3" r=".95"><stop offset="0" stop-color="#f8f3e7"/>'
            f'<stop offset=".6" stop-color="{tint}"/><stop offset="1" stop-color="{darker(tint, .72)}"/></radialGradient>'
            '<radialGradient id="shade"><stop offset="0" stop-color="#2a2018" stop-opacity=".55"/>'
            '<stop offset=".55" stop-color="#2a2018" stop-opacity=".22"/><stop offset="1" stop-color="#2a2018" stop-opacity="0"/></radialGradient>'
            '<linearGradient id="table" x1="0" y1="0" x2="0" y2="1"><stop offset="0" stop-color="#fff8e8" stop-opacity=".5"/>'
            '<stop offset="1" stop-color="#fff8e8" stop-opacity="0"/></linearGradient>')
        self.body.append(f'<rect width="{SIZE}" height="{SIZE}" fill="url(#room)"/>'
                         f'<rect y="700" width="{SIZE}" height="260" fill="url(#table)"/>')

    def add(self, text):
        self.body.append(text)

    def unique(self, prefix):
        self.count += 1
        return f'{prefix}{self.count}'

    def shadow(self, x, y, rx, ry=None):
        self.add(f'<ellipse cx="{x + rx * .12:.1f}" cy="{y}" rx="{rx * 1.25:.1f}" ry="{ry or rx * .2:.1f}" fill="url(#shade)"/>')

    def fill(self, material, across=True):
        """A gradient of a material: across for round things, down for flat ones."""
        edge, body, light, _ = MATERIALS[material]
        name = self.unique('m')
        x2, y2 = (1, 0) if across else (.6, 1)
        stops = ((0, darker(body, .85)), (.28, light), (.5, body), (.82, edge), (1, darker(edge, .8))) if across else (
            (0, light), (.45, body), (1, edge))
        inner = ''.join(f'<stop offset="{o}" stop-color="{c}"/>' for o, c in stops)
        self.defs.append(f'<linearGradient id="{name}" x1="0" y1="0" x2="{x2}" y2="{y2}">{inner}</linearGradient>')
        return f'url(#{name})'

    def path(self, d, fill, stroke='none', width=0, opacity=1, extra=''):
        self.add(f'<path d="{d}" fill="{fill}" stroke="{stroke}" stroke-width="{width}" opacity="{opacity}" '
                 f'stroke-linecap="round" stroke-linejoin="round" {extra}/>')

    def clip(self, d):
        name = self.unique('c')
        self.defs.append(f'<clipPath id="{name}"><path d="{d}"/></clipPath>')
        return f'clip-path="url(#{name})"'

    def grain(self, d, material, amount=90):
        """Small worn spots inside an outline, so that nothing looks like plastic."""
        clip, (_, _, light, deep) = self.clip(d), MATERIALS[material]
        dots = ''
        for _ in range(amount):
            x, y, r = self.random.uniform(150, 810), self.random.uniform(120, 810), self.random.uniform(1.5, 7)
            dots += f'<ellipse cx="{x:.0f}" cy="{y:.0f}" rx="{r:.1f}" ry="{r * .6:.1f}" fill="{self.random.choice((light, deep))}"/>'
        self.add(f'<g {clip} opacity=".16">{dots}</g>')

    def cut_out(self):
        """The same without room, table and shadow."""
        body = [part for part in self.body if 'url(#room)' not in part and 'url(#shade)' not in part]
        write(HERE / 'cut' / f'{self.name}.svg', (0, 0, SIZE, SIZE), self.defs, body)

    def save(self, detail='', view=(0, 0, SIZE, SIZE)):
        """The whole picture, or a detail of it: what lies in view, which is x, y, width and height."""
        write(HERE / f'{self.name}{detail}.svg', view, self.defs, self.body)


class Strip(Picture):
    """What lies round something turned: as wide as its girth, its foot below, its middle in front."""

    def __init__(self, name, width, height, ground):
        super().__init__(name)
        self.view = (0, 0, width, height)
        self.body = [f'<rect width="{width}" height="{height}" fill="{ground}"/>']

    def dots(self, colours, amount, largest):
        """Worn spots all over, so that nothing looks like plastic."""
        _, _, width, height = self.view
        dots = ''
        for _ in range(amount):
            x, y, r = self.random.uniform(0, width), self.random.uniform(0, height), self.random.uniform(1.5, largest)
            dots += f'<ellipse cx="{x:.0f}" cy="{y:.0f}" rx="{r:.1f}" ry="{r * .6:.1f}" fill="{self.random.choice(colours)}"/>'
        self.add(f'<g opacity=".16">{dots}</g>')

    def save(self):
        write(HERE / 'round' / f'{self.name}.svg', self.view, self.defs, self.body)


def write(file, view, defs, body):
    x, y, width, height = view
    scale = SIZE / max(width, height)
    file.parent.mkdir(exist_ok=True)
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x} {y} {width} {height}" width="{width * scale:.0f}" height="{height * scale:.0f}">'
                    f'<defs>{"".join(defs)}</defs>\n' + '\n'.join(body) + '\n</svg>\n')


def darker(colour, by):
    return '#' + ''.join(f'{max(0, min(255, int(int(colour[i:i + 2], 16) * by))):02x}' for i in (1, 3, 5))


def smooth(points, closed=False):
    """A path through points (Catmull-Rom as cubic Beziers)."""
    n = len(points)
    at = (lambda i: points[i % n]) if closed else (lambda i: points[max(0, min(n - 1, i))])
    d = f'M{points[0][0]:.1f},{points[0][1]:.1f}'
    for i in range(n if closed else n - 1):
        p0, p1, p2, p3 = at(i - 1), at(i), at(i + 1), at(i + 2)
        d += (f'C{p1[0] + (p2[0] - p0[0]) / 6:.1f},{p1[1] + (p2[1] - p0[1]) / 6:.1f} '
              f'{p2[0] - (p3[0] - p1[0]) / 6:.1f},{p2[1] - (p3[1] - p1[1]) / 6:.1f} {p2[0]:.1f},{p2[1]:.1f}')
    return d + ('Z' if closed else '')


def polygon(points):
    return 'M' + 'L'.join(f'{x:.1f},{y:.1f}' for x, y in points) + 'Z'


def ellipse(cx, cy, rx, ry):
    return f'M{cx - rx:.1f},{cy:.1f}a{rx:.1f},{ry:.1f} 0 1 0 {2 * rx:.1f},0a{rx:.1f},{ry:.1f} 0 1 0 {-2 * rx:.1f},0Z'


def revolved(profile, cx=480, tilt=.16):
    """Outline of a solid of revolution; profile is (y, radius) from top to bottom. Top and foot are ellipses."""
    left, right = [(cx - r, y) for y, r in profile], [(cx + r, y) for y, r in reversed(profile)]
    r = profile[-1][1]
    d = smooth(left) + f'A{r:.1f},{r * tilt:.1f} 0 0 0 {cx + r:.1f},{profile[-1][0]:.1f}'
    return d + smooth(right)[len(f'M{right[0][0]:.1f},{right[0][1]:.1f}'):] + 'Z'


def band(profile, y0, y1, cx=480, tilt=.16, steps=10):
    """The part of a solid of revolution between two heights, curved as the eye sees it."""
    def radius(y):
        for (ya, ra), (yb, rb) in zip(profile, profile[1:]):
            if ya <= y <= yb:
                t = (y - ya) / (yb - ya)
                return ra + (rb - ra) * (3 * t * t - 2 * t ** 3)
        return profile[-1][1]
    front = lambda y: [(cx - radius(y) * math.cos(math.pi * k / steps), y + radius(y) * tilt * math.sin(math.pi * k / steps)) for k in range(steps + 1)]
    return polygon(front(y0) + front(y1)[::-1])


def vessel(p, material, profile, mouth=True, cx=480, tilt=.16):
    d = revolved(profile, cx, tilt)
    p.path(d, p.fill(material))
    p.grain(d, material)
    if mouth:
        y, r = profile[0]
        p.path(ellipse(cx, y, r, r * tilt), MATERIALS[material][1])
        p.path(ellipse(cx, y + 3, r * .86, r * tilt * .8), darker(MATERIALS[material][3], .8))
    return d


def spiral(cx, cy, r, turns=2.4, sense=1, start=0):
    return smooth([(cx + r * (1 - k / 36) * math.cos(start + sense * turns * 2 * math.pi * k / 36),
                    cy + r * (1 - k / 36) * math.sin(start + sense * turns * 2 * math.pi * k / 36)) for k in range(35)])


def meander(x, y, s):
    pts = [(0, 4), (0, 0), (4, 0), (4, 3), (1.6, 3), (1.6, 1.6), (2.6, 1.6)]
    return 'M' + 'L'.join(f'{x + a * s:.1f},{y + b * s:.1f}' for a, b in pts)


def slab(p, material, outline, depth=26):
    """A flat thing with a worn edge: its side first, then its face."""
    edge = MATERIALS[material][0]
    p.path(polygon([(x + depth, y + depth * .4) for x, y in outline]), darker(edge, .8))
    for (xa, ya), (xb, yb) in zip(outline, outline[1:] + outline[:1]):
        p.path(polygon([(xa, ya), (xb, yb), (xb + depth, yb + depth * .4), (xa + depth, ya + depth * .4)]), darker(edge, .85))
    d = polygon(outline)
    p.path(d, p.fill(material, across=False))
    p.grain(d, material, 160)
    return d


def rough(p, x0, y0, x1, y1, jitter=9, per_side=7):
    """A rectangle that time has been at."""
    pts = []
    for (xa, ya), (xb, yb) in (((x0, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x1, y1), (x0, y1)), ((x0, y1), (x0, y0))):
        for k in range(per_side):
            t = k / per_side
            pts.append((xa + (xb - xa) * t + p.random.uniform(-jitter, jitter), ya + (yb - ya) * t + p.random.uniform(-jitter, jitter)))
    return pts


def boundary_stone():
    p = Picture('boundary-stone')
    p.shadow(480, 806, 230)
    out = [(330, 806), (318, 520), (322, 300), (356, 196), (420, 150), (492, 138), (566, 160), (618, 214), (640, 310), (646, 540), (638, 806)]
    d = slab(p, 'stone', out, 34)
    deep = MATERIALS['stone'][3]
    for k, y in enumerate((300, 370, 440)):
        wave = smooth([(368 + 26 * i, y + (14 if i % 2 else -14)) for i in range(10)])
        p.path(wave, 'none', deep, 12, .7)
        p.path(wave, 'none', '#fff8e6', 3, .45, f'transform="translate(3,7)"')
    for row in range(4):
        for col in range(7):
            x, y = 372 + col * 34, 530 + row * 58
            kind = p.random.randrange(4)
            stroke = [f'M{x},{y}v34', f'M{x - 9},{y + 6}l18,22', f'M{x - 9},{y + 17}h20M{x},{y}v34', f'M{x - 8},{y}l8,16l8,-16'][kind]
            p.path(stroke, 'none', deep, 6, .62)
    p.path(d, 'none', '#fff6df', 3, .35)
    p.cut_out()
    p.save()


def standing_king():
    p = Picture('standing-king', '#dfe0cf')
    p.shadow(480, 836, 210)
    p.path(polygon([(330, 800), (630, 800), (656, 846), (310, 846)]), p.fill('dark stone', False))
    robe = [(402, 800), (388, 640), (372, 500), (360, 380), (372, 318), (430, 296), (530, 296), (588, 318), (600, 380), (588, 500), (574, 640), (560, 800)]
    d = smooth(robe, True)
    p.path(d, p.fill('stone'))
    p.grain(d, 'stone', 220)
    deep = MATERIALS['stone'][3]
    for k in range(7):
        x = 420 + k * 20
        p.path(smooth([(x, 560), (x - 4 + k, 660), (x - 8 + 2 * k, 792)]), 'none', deep, 4, .35)
    for side in (-1, 1):  # arms held at the belt
        arm = [(480 + side * 112, 330), (480 + side * 132, 430), (480 + side * 104, 506), (480 + side * 20, 508), (480 + side * 16, 476), (480 + side * 74, 466), (480 + side * 86, 410), (480 + side * 76, 340)]
        p.path(smooth(arm, True), p.fill('stone'), deep, 2, 1)
    p.path('M388,528h184v24h-184z', MATERIALS['stone'][1], deep, 3)
    for k in range(9):
        p.path(meander(394 + k * 20, 531, 4.2), 'none', deep, 2.4, .7)
    p.path(smooth([(420, 250), (424, 180), (480, 150), (536, 180), (540, 250), (520, 296), (480, 306), (440, 296)], True), p.fill('stone'))
    for k in range(9):  # the beard, in ringlets
        x = 436 + k * 11
        p.path(f'M{x},266q6,14 0,28t0,28t0,24', 'none', deep, 5, .55)
    p.path(polygon([(408, 190), (418, 96), (480, 76), (542, 96), (552, 190)]), p.fill('stone'), deep, 2)
    for k in range(6):
        p.path(f'M{424 + k * 22},118v62', 'none', deep, 3, .4)
    p.path('M446,214q14,-10 28,0M488,214q14,-10 28,0', 'none', deep, 5, .8)
    p.path('M452,226q9,8 18,0M492,226q9,8 18,0', deep, deep, 2, .7)
    p.path('M480,216l-8,32h14', 'none', deep, 4, .6)
    p.path('M456,262q26,12 40,-4', 'none', deep, 5, .75)
    p.save()


def painted_jar():
    p = Picture('painted-jar')
    prof = [(236, 96), (262, 84), (296, 92), (360, 190), (450, 252), (540, 246), (640, 190), (740, 118), (800, 96)]
    p.shadow(480, 806, 170)
    d = vessel(p, 'clay', prof)
    clip = p.clip(d)
    dark, white = '#34190f', '#f3e3c4'
    p.add(f'<g {clip}>')
    for y0, y1 in ((300, 312), (322, 328), (596, 608), (620, 625)):
        p.path(band(prof, y0, y1), dark, opacity=.85)
    for k in range(4):
        x, squeeze = 480 + (k - 1.5) * 150, .8 if k in (0, 3) else 1
        p.add(f'<g transform="translate({x:.0f},{478 - abs(k - 1.5) * 10:.0f}) scale({squeeze},1)">')
        p.path(spiral(0, 0, 70, 2.6, 1, math.pi), 'none', dark, 15, .88)
        p.path(ellipse(0, 0, 9, 9), white)
        p.add('</g>')
        p.path(smooth([(x - 75, 478), (x - 90, 420), (x - 40, 372)]), 'none', dark, 8, .7)
    for k in range(24):
        x = 300 + k * 16
        p.path(f'M{x},654l8,34l8,-34', 'none', dark, 4, .55)
    p.add('</g>')
    for side in (-1, 1):
        p.path(smooth([(480 + side * 232, 470), (480 + side * 286, 486), (480 + side * 278, 536), (480 + side * 236, 530)]), 'none', MATERIALS['clay'][0], 20)
        p.path(smooth([(480 + side * 232, 470), (480 + side * 286, 486), (480 + side * 278, 536), (480 + side * 236, 530)]), 'none', MATERIALS['clay'][1], 11)
    p.path(smooth([(330, 400), (296, 470), (318, 560)]), 'none', '#fff', 14, .22)
    p.save()


def painted_jar_round():
    """Spirals that run on round the shoulder, so that they have no beginning."""
    p = Strip('painted-jar', 1200, 620, MATERIALS['clay'][1])
    dark, white = '#34190f', '#f3e3c4'
    p.dots(MATERIALS['clay'][2:], 420, 8)
    for y, width in ((72, 12), (92, 6), (330, 12), (350, 5)):
        p.path(f'M-10,{y}H1210', 'none', dark, width, .85)
    for k in range(6):
        x = 100 + k * 200
        p.add(f'<g transform="translate({x},212)">')
        p.path(spiral(0, 0, 84, 2.6, 1, math.pi), 'none', dark, 17, .88)
        p.path(ellipse(0, 0, 10, 10), white)
        p.add('</g>')
        p.path(smooth([(x - 84, 212), (x - 104, 150), (x - 40, 112)]), 'none', dark, 9, .7)
        p.path(smooth([(x - 84, 212), (x - 116, 262), (x - 140, 300)]), 'none', dark, 9, .7)
    for k in range(48):
        p.path(f'M{4 + k * 25},378l12,44l12,-44', 'none', dark, 5, .55)
    p.save()


def bone_flute():
    p = Picture('bone-flute')
    p.add('<g transform="rotate(-32 480 480)">')
    p.add('<ellipse cx="500" cy="560" rx="400" ry="40" fill="url(#shade)" opacity=".8"/>')
    shaft = [(110, 470), (150, 446), (300, 452), (520, 458), (700, 452), (820, 440), (856, 468), (850, 506), (816, 522), (700, 510), (520, 504), (300, 512), (150, 522), (112, 506)]
    d = smooth(shaft, True)
    p.path(d, p.fill('bone', False))
    p.grain(d, 'bone', 120)
    for x in (250, 322, 394, 474, 546, 620, 694):
        p.path(ellipse(x, 478, 13, 12), MATERIALS['bone'][3])
        p.path(ellipse(x + 2, 481, 12, 10), '#2b2013')
    p.path(ellipse(498, 470, 5, 5), '#2b2013')
    for x in (206, 214, 745, 753):
        p.path(f'M{x},452q6,28 0,58', 'none', MATERIALS['bone'][3], 3, .5)
    p.path(smooth([(140, 460), (400, 464), (800, 456)]), 'none', '#fffdf2', 7, .65)
    p.add('</g>')
    p.save()


def millstone():
    p = Picture('millstone')
    p.shadow(480, 720, 340, 60)
    d = smooth([(140, 560), (180, 470), (330, 424), (520, 420), (700, 450), (800, 520), (824, 610), (770, 690), (560, 726), (330, 716), (180, 664)], True)
    p.path(d, p.fill('stone', False))
    p.grain(d, 'stone', 260)
    p.path(smooth([(230, 548), (330, 490), (520, 476), (680, 500), (730, 556), (640, 608), (450, 622), (290, 604)], True), darker(MATERIALS['stone'][1], .8))
    p.path(smooth([(250, 560), (340, 512), (520, 500), (664, 520), (706, 562), (620, 600), (450, 610), (300, 596)], True), MATERIALS['stone'][2], opacity=.55)
    for k in range(9):
        p.path(smooth([(310 + k * 36, 600), (330 + k * 34, 560), (356 + k * 30, 520)]), 'none', MATERIALS['stone'][3], 3, .25)
    p.path(smooth([(300, 470), (420, 412), (600, 408), (668, 446), (640, 500), (500, 528), (350, 522)], True), p.fill('dark stone', False))
    p.path(smooth([(330, 466), (430, 428), (590, 424)]), 'none', '#fff', 9, .25)
    for _ in range(60):
        x, y = p.random.gauss(520, 120), p.random.gauss(566, 20)
        p.path(ellipse(x, y, 6, 4), p.random.choice(('#d9b25c', '#c59a44', '#e9cf8b')))
    p.save()


def tripod_ding():
    p = Picture('tripod-ding')
    p.shadow(480, 816, 220)
    deep = MATERIALS['bronze'][3]
    for x, lean in ((352, -1), (608, 1), (480, 0)):
        leg = [(x - 34, 560), (x - 28 + lean * 6, 680), (x - 34 + lean * 14, 806), (x + 34 + lean * 14, 806), (x + 28 + lean * 6, 680), (x + 34, 560)]
        p.path(smooth(leg, True), p.fill('bronze'), deep, 2)
    for x in (330, 630):
        p.path(f'M{x - 44},300V190q0,-34 44,-34t44,34V300h-24V206q0,-18 -20,-18t-20,18V300z', p.fill('bronze'), deep, 2)
    prof = [(286, 226), (312, 214), (350, 214), (470, 218), (560, 190), (620, 120), (640, 60)]
    d = vessel(p, 'bronze', prof, tilt=.2)
    p.add(f'<g {p.clip(d)}>')
    for y0, y1 in ((340, 346), (470, 477)):
        p.path(band(prof, y0, y1, tilt=.2), deep, opacity=.75)
    for k in range(14):  # thunder pattern
        a = -1.25 + 2.5 * k / 13
        x, y, w = 480 + 212 * math.sin(a), 362 + 44 * math.cos(a), max(.25, math.cos(a))
        p.add(f'<g transform="translate({x:.0f},{y:.0f}) scale({w:.2f},1)">')
        p.path(meander(-14, 0, 7), 'none', deep, 4, .8)
        p.path(meander(-14, 66, 7), 'none', deep, 4, .8)
        p.add('</g>')
    for side in (-1, 1):  # the face
        p.path(ellipse(480 + side * 74, 456, 26, 19), p.fill('bronze', False), deep, 5)
        p.path(ellipse(480 + side * 70, 458, 10, 9), deep)
        p.path(smooth([(480 + side * 30, 420), (480 + side * 84, 404), (480 + side * 130, 424), (480 + side * 150, 400)]), 'none', deep, 10, .8)
        p.path(smooth([(480 + side * 24, 520), (480 + side * 70, 532), (480 + side * 118, 508)]), 'none', deep, 9, .75)
    p.path('M480,356L494,380L490,520L480,546L470,520L466,380Z', p.fill('bronze'), deep, 3)
    p.add('</g>')
    p.path(smooth([(300, 330), (288, 420), (310, 520)]), 'none', '#f2ffe8', 12, .25)
    p.save()


def chime_bells():
    p = Picture('chime-bells', '#e2d6c0')
    p.shadow(480, 820, 380, 46)
    for x in (130, 830):
        p.path(f'M{x - 20},170h40v640h-40z', p.fill('wood'))
        p.path(polygon([(x - 70, 800), (x + 70, 800), (x + 84, 828), (x - 84, 828)]), p.fill('wood', False))
    for y in (176, 470):
        p.path(f'M84,{y}h792v34h-792z', p.fill('wood', False))
        for k in range(24):
            p.path(meander(100 + k * 32, y + 8, 4.5), 'none', '#c9524a', 3, .8)

    def bell(cx, top, h):
        w, deep = h * .36, MATERIALS['bronze'][3]
        p.path(f'M{cx},{top - h * .22}v{h * .24}', 'none', deep, 8)
        d = (f'M{cx - w * .74},{top}L{cx - w},{top + h}Q{cx},{top + h * .76} {cx + w},{top + h}L{cx + w * .74},{top}'
             f'Q{cx},{top - h * .1} {cx - w * .74},{top}Z')
        p.path(d, p.fill('bronze'), deep, 2)
        for row in range(3):
            for side in (-1, 1):
                for col in range(3):
                    p.path(ellipse(cx + side * w * (.24 + col * .22), top + h * (.16 + row * .17), h * .035, h * .035), MATERIALS['bronze'][2], deep, 1.5)
        p.path(smooth([(cx - w * .5, top + h * .78), (cx, top + h * .66), (cx + w * .5, top + h * .78)]), 'none', deep, 4, .7)
    for k in range(5):
        bell(220 + k * 130, 246, 132 + 10 * k)
    for k in range(4):
        bell(232 + k * 166, 548, 176 + 16 * k)
    p.save()


def owl_vessel():
    p = Picture('owl-vessel')
    p.shadow(490, 812, 210)
    deep = MATERIALS['bronze'][3]
    p.path(smooth([(610, 560), (690, 700), (720, 800), (640, 806), (590, 700)], True), p.fill('bronze'), deep, 2)
    for x in (400, 530):
        p.path(smooth([(x - 30, 660), (x - 26, 760), (x - 54, 808), (x + 40, 808), (x + 26, 750), (x + 36, 660)], True), p.fill('bronze'), deep, 2)
    body = [(320, 470), (340, 360), (430, 300), (540, 300), (640, 380), (670, 500), (630, 620), (540, 696), (420, 700), (345, 620)]
    d = smooth(body, True)
    p.path(d, p.fill('bronze'), deep, 2)
    p.grain(d, 'bronze')
    p.add(f'<g {p.clip(d)}>')
    p.path(spiral(560, 500, 120, 2.2, -1), 'none', deep, 15, .75)
    for row in range(7):
        for col in range(10):
            x, y = 330 + col * 22 + (row % 2) * 11, 380 + row * 40
            if x < 470:
                p.path(f'M{x},{y}q11,26 22,0', 'none', deep, 4, .6)
    p.add('</g>')
    head = smooth([(330, 330), (336, 240), (390, 176), (470, 160), (550, 182), (590, 250), (584, 330), (520, 372), (400, 374)], True)
    p.path(head, p.fill('bronze'), deep, 3)
    for side in (-1, 1):
        p.path(smooth([(456 + side * 60, 196), (456 + side * 96, 110), (456 + side * 118, 190)], True), p.fill('bronze'), deep, 3)
        p.path(ellipse(456 + side * 58, 266, 44, 44), MATERIALS['bronze'][1], deep, 7)
        p.path(ellipse(456 + side * 58, 266, 28, 28), MATERIALS['bronze'][2], deep, 4)
        p.path(ellipse(456 + side * 56, 268, 13, 13), deep)
    p.path(polygon([(438, 290), (476, 290), (458, 352)]), p.fill('bronze'), deep, 3)
    p.path('M340,376Q456,420 590,372', 'none', deep, 6, .6)
    p.cut_out()
    p.save()
    p.save('-head', (286, 90, 360, 300))
    p.save('-wing', (400, 380, 300, 300))
    p.save('-feet', (330, 600, 420, 236))


def oracle_bone():
    p = Picture('oracle-bone')
    p.shadow(480, 780, 250, 60)
    out = smooth([(330, 180), (420, 130), (520, 150), (560, 230), (600, 340), (690, 480), (716, 640), (640, 760), (500, 790), (350, 756), (270, 640), (280, 480), (340, 330)], True)
    p.path(out, darker(MATERIALS['bone'][0], .8), extra='transform="translate(18,12)"')
    p.path(out, p.fill('bone', False))
    p.grain(out, 'bone', 200)
    deep = MATERIALS['bone'][3]
    for col in range(5):
        for row in range(6):
            x, y, s = 350 + col * 62, 392 + row * 58 + col * 4, 20
            strokes = [f'M{x - s},{y}h{2 * s}M{x},{y - s}v{2 * s}', f'M{x - s},{y - s}l{2 * s},{2 * s}M{x + s},{y - s}l{-2 * s},{2 * s}',
                       f'M{x - s},{y + s}V{y - s}H{x + s}V{y + s}M{x - s},{y}H{x + s}', f'M{x},{y - s}v{2 * s}M{x},{y - s}l{-s},{s}M{x},{y - s}l{s},{s}',
                       f'M{x - s},{y - 8}q{s},-16 {2 * s},0M{x - s},{y + 8}q{s},-16 {2 * s},0', f'M{x - 14},{y - 14}h28v28h-28zM{x},{y - 14}v28'][p.random.randrange(6)]
            p.path(strokes, 'none', deep, 4, .72)
    for x, y in ((420, 250), (500, 290), (610, 560), (320, 600)):
        p.path(ellipse(x, y, 20, 26), '#3b2a18', opacity=.75)
        p.path(f'M{x},{y + 20}l6,60M{x + 3},{y + 46}l34,-16', 'none', '#3b2a18', 4, .8)
    p.save()


def clay_letter():
    p = Picture('clay-letter')
    p.shadow(480, 770, 280, 56)
    d = smooth(rough(p, 270, 230, 690, 740, 7, 6), True)
    p.path(d, darker(MATERIALS['pale clay'][0], .8), extra='transform="translate(20,16)"')
    p.path(d, p.fill('pale clay', False))
    p.grain(d, 'pale clay', 200)
    deep = MATERIALS['pale clay'][3]
    for row in range(10):
        y = 280 + row * 43
        p.path(f'M296,{y + 30}H664', 'none', deep, 1.5, .3)
        x = 306
        while x < 640:
            for _ in range(p.random.randint(1, 3)):
                a = p.random.choice((0, math.pi / 2, math.pi / 4))
                c, s = math.cos(a), math.sin(a)
                wedge = [(-9, -7), (-9, 7), (20, 0)]
                p.path(polygon([(x + c * u - s * v, y + 10 + s * u + c * v) for u, v in wedge]), deep, opacity=.8)
                x += p.random.choice((9, 13))
            x += p.random.choice((14, 18, 24))
    shard = smooth([(560, 560), (700, 540), (740, 640), (720, 770), (590, 800), (520, 740)], True)
    p.path(shard, darker(MATERIALS['clay'][0], .8), extra='transform="translate(14,12)"')
    p.path(shard, p.fill('clay', False))
    for k in range(12):
        x, y = 570 + (k % 4) * 38, 610 + (k // 4) * 50
        p.path(polygon([(x - 7, y - 6), (x - 7, y + 6), (x + 15, y)]), MATERIALS['clay'][3], opacity=.8)
    p.save()


def papyrus_account():
    p = Picture('papyrus-account')
    p.add('<ellipse cx="500" cy="800" rx="420" ry="40" fill="url(#shade)"/>')
    out = rough(p, 150, 220, 810, 760, 10, 10)
    d = polygon(out)
    name = p.unique('m')
    p.defs.append(f'<linearGradient id="{name}" x1="0" y1="0" x2="1" y2="1"><stop offset="0" stop-color="#efdcae"/><stop offset=".6" stop-color="#dcc085"/><stop offset="1" stop-color="#b8955a"/></linearGradient>')
    p.path(d, '#7d6236', extra='transform="translate(10,10)"', opacity=.6)
    p.path(d, f'url(#{name})')
    p.add(f'<g {p.clip(d)}>')
    for k in range(60):
        p.path(f'M{150 + k * 11.5},210v560', 'none', '#8a6a36', 2, .13)
        p.path(f'M140,{214 + k * 9.5}h690', 'none', '#fff3cd', 2, .16)
    for row in range(9):
        y = 286 + row * 50
        red = row in (0, 5)
        x = 760
        while x > (430 if row > 5 else 230):
            w = p.random.randint(16, 40)
            p.path(smooth([(x, y), (x - w * .4, y + p.random.randint(-13, 6)), (x - w * .7, y + p.random.randint(0, 14)), (x - w, y - 2)]), 'none', '#a3321f' if red else '#231a12', 5.5, .85)
            x -= w + p.random.randint(8, 20)
    cat = [(262, 690), (256, 640), (270, 610), (262, 588), (278, 596), (296, 594), (310, 584), (306, 612), (330, 650), (336, 700)]
    p.path(smooth(cat), 'none', '#231a12', 5, .85)
    p.path('M336,700q40,-6 44,-46q2,-20 -14,-18M274,612l2,1M296,611l2,1', 'none', '#231a12', 5, .85)
    p.add('</g>')
    p.save()


def seal_stones():
    p = Picture('seal-stones')
    p.shadow(480, 790, 330, 60)
    p.path(polygon([(190, 610), (790, 560), (830, 770), (170, 800)]), p.fill('pale clay', False))
    deep = MATERIALS['pale clay'][3]
    for k in range(4):
        x, y = 250 + k * 140, 690 - k * 8
        p.path(f'M{x},{y + 60}V{y - 30}M{x},{y - 20}q-40,-30 -52,6M{x},{y - 20}q40,-30 52,6M{x},{y - 26}q-20,-44 -44,-26M{x},{y - 26}q20,-44 44,-26', 'none', deep, 6, .6)
        p.path(f'M{x + 48},{y + 56}v-34q0,-16 22,-18h16l10,-22l4,22v20v32M{x + 70},{y + 56}v-26', 'none', deep, 6, .6)
    for cx, cy, h, mat in ((340, 400, 250, 'dark stone'), (520, 360, 300, 'jade'), (700, 420, 210, 'clay')):
        prof = [(cy - h / 2, 58), (cy, 54), (cy + h / 2, 58)]
        p.shadow(cx, cy + h / 2 + 6, 80)
        d = vessel(p, mat, prof, cx=cx, tilt=.24)
        dk = MATERIALS[mat][3]
        p.add(f'<g {p.clip(d)}>')
        p.path(f'M{cx - 20},{cy + h * .3}v{-h * .5}q20,-30 40,0v{h * .5}M{cx - 36},{cy - h * .1}l72,-10M{cx},{cy - h * .26}v-18', 'none', dk, 7, .75)
        p.path(band(prof, cy - h * .42, cy - h * .39, cx, .24), dk, opacity=.7)
        p.path(band(prof, cy + h * .38, cy + h * .41, cx, .24), dk, opacity=.7)
        p.add('</g>')
    p.save()


def glass_flask():
    p = Picture('glass-flask', '#dde4d8')
    p.shadow(480, 806, 180)
    prof = [(150, 58), (172, 40), (300, 36), (400, 52), (470, 138), (570, 196), (680, 190), (770, 126), (800, 96)]
    d = revolved(prof)
    p.path(d, p.fill('glass'), opacity=.72)
    p.path(revolved([(560, 180), (640, 188), (720, 160), (786, 100)]), '#c9837a', opacity=.5)
    p.path(ellipse(480, 562, 184, 26), '#e5b3a8', opacity=.6)
    p.path(ellipse(480, 150, 58, 12), '#d8f3ee', MATERIALS['glass'][0], 3)
    for pts in ([(330, 590), (390, 560), (410, 500), (470, 470), (480, 400)], [(410, 500), (500, 530), (560, 600), (640, 610)], [(500, 530), (520, 640), (480, 740), (500, 796)]):
        p.path(smooth(pts), 'none', MATERIALS['gold'][1], 8)
        p.path(smooth(pts), 'none', MATERIALS['gold'][2], 3)
    p.path(smooth([(370, 500), (320, 580), (340, 680)]), 'none', '#fff', 20, .5)
    p.path('M462,190V380', 'none', '#fff', 9, .5)
    p.path(smooth([(620, 560), (650, 620), (630, 690)]), 'none', '#fff', 7, .35)
    p.save()


def glass_flask_round():
    """Blue-green glass, a reddish bottom and the mends of gold."""
    p = Strip('glass-flask', 960, 640, MATERIALS['glass'][1])
    p.defs.append('<linearGradient id="blown" x1="0" y1="0" x2="0" y2="1"><stop offset="0" stop-color="#a9dbd4"/><stop offset=".45" stop-color="#5aa5a3"/>'
                  '<stop offset=".62" stop-color="#7c9a90"/><stop offset=".72" stop-color="#b07f74"/><stop offset="1" stop-color="#5b4a48"/></linearGradient>')
    p.path('M0,0H960V640H0Z', 'url(#blown)')
    for k in range(70):
        x, y, r = p.random.uniform(0, 960), p.random.uniform(20, 620), p.random.uniform(1.5, 5)
        p.path(ellipse(x, y, r, r * 1.5), MATERIALS['glass'][2], opacity=.5)
    for shift in (0, 430):
        for pts in ([(330, 500), (390, 450), (410, 390), (470, 340), (480, 250), (470, 120)], [(410, 390), (500, 420), (560, 490), (700, 510)], [(500, 420), (520, 520), (480, 600), (500, 640)]):
            pts = [(x + shift - 180, y) for x, y in pts]
            p.path(smooth(pts), 'none', MATERIALS['gold'][1], 11)
            p.path(smooth(pts), 'none', MATERIALS['gold'][2], 4)
    p.save()


def model_granary_round():
    """Its wall with a door in front, the shade under the eaves, and tiles."""
    p = Strip('model-granary', 960, 540, MATERIALS['pale clay'][1])
    deep = MATERIALS['pale clay'][3]
    p.dots(MATERIALS['pale clay'][2:], 260, 6)
    for y in (396, 470):
        p.path(f'M0,{y}H960v7H0Z', deep, opacity=.5)
    p.path('M0,330H960V288H0Z', darker(deep, .9))
    p.path('M0,288H960V0H0Z', MATERIALS['clay'][1])
    for k in range(48):
        p.path(f'M{k * 20},288V40', 'none', MATERIALS['clay'][3], 4, .55)
    for y in (92, 142, 192, 242):
        p.path(f'M0,{y}H960', 'none', MATERIALS['clay'][3], 3, .4)
    p.path('M440,410h76v104h-76z', '#2a1c10')
    p.path('M516,410l38,10v100l-38,-6z', MATERIALS['wood'][1], deep, 3)
    for _ in range(70):
        p.path(ellipse(p.random.gauss(470, 32), p.random.gauss(520, 9), 5, 3), p.random.choice(('#d9b25c', '#c59a44', '#e9cf8b')))
    p.save()


def camel_figure():
    p = Picture('camel-figure')
    p.shadow(490, 830, 300, 50)
    p.path(polygon([(230, 806), (750, 806), (770, 840), (210, 840)]), p.fill('pale clay', False))
    deep = MATERIALS['glaze'][0]
    for x0, x1 in ((350, 330), (430, 424), (600, 604), (670, 690)):
        p.path(smooth([(x0 - 26, 560), (x1 - 17, 690), (x1 - 22, 806), (x1 + 22, 806), (x1 + 15, 690), (x0 + 28, 560)], True), p.fill('glaze'), deep, 2)
    p.path(smooth([(690, 480), (730, 560), (716, 620)]), 'none', deep, 12)
    body = smooth([(320, 520), (330, 440), (390, 400), (430, 320), (480, 390), (540, 392), (600, 316), (650, 400), (706, 470), (690, 570), (560, 600), (400, 596)], True)
    p.path(body, p.fill('glaze', False), deep, 2)
    neck = smooth([(350, 560), (280, 520), (242, 420), (250, 300), (232, 250), (180, 252), (160, 220), (200, 180), (262, 168), (308, 200), (312, 300), (324, 400), (390, 430)], True)
    p.path(neck, p.fill('glaze'), deep, 2)
    p.path(ellipse(240, 206, 8, 8), '#241509')
    p.path('M166,228q24,10 44,2M286,170l14,-30l10,36', 'none', '#241509', 5, .8)
    for k in range(7):
        p.path(f'M{262 + k * 4},{300 + k * 30}q-16,14 -6,28', 'none', deep, 6, .5)
    p.path(smooth([(440, 400), (500, 360), (600, 380), (640, 470), (590, 560), (470, 556), (430, 480)], True), '#3f6b43', '#2c4a2f', 3)
    p.path(smooth([(452, 430), (520, 404), (610, 420)]), 'none', '#e9dcae', 9, .8)
    p.path(smooth([(452, 486), (530, 470), (618, 490)]), 'none', '#b4472f', 9, .8)
    p.path(smooth([(470, 540), (530, 532), (600, 540)]), 'none', '#e9dcae', 7, .7)
    p.path(smooth([(640, 420), (676, 380), (690, 430), (664, 466)], True), '#8c6238', '#3d2614', 3)
    p.path(smooth([(470, 372), (440, 330), (470, 300), (506, 330)], True), '#c9b28a', '#5f4c34', 3)
    for x, y, c in ((400, 470, '#3f6b43'), (560, 590, '#f3e6c4'), (360, 540, '#f3e6c4')):
        p.path(f'M{x},{y}q6,60 -4,90', 'none', c, 12, .5)
    p.cut_out()
    p.save()


def silk_fragment():
    p = Picture('silk-fragment', '#e3d9cb')
    p.add('<ellipse cx="500" cy="812" rx="380" ry="36" fill="url(#shade)"/>')
    d = polygon(rough(p, 190, 160, 780, 780, 15, 12))
    name = p.unique('m')
    p.defs.append(f'<linearGradient id="{name}" x1="0" y1="0" x2="1" y2="1"><stop offset="0" stop-color="#a4433d"/><stop offset=".5" stop-color="#8a2f33"/><stop offset="1" stop-color="#662026"/></linearGradient>')
    p.path(d, '#3a1417', opacity=.4, extra='transform="translate(12,14)"')
    p.path(d, f'url(#{name})')
    p.add(f'<g {p.clip(d)}>')
    gold, blue = '#e0b867', '#56778c'
    for row in range(4):
        for col in range(4):
            x, y = 250 + col * 190 + (95 if row % 2 else 0) - 60, 240 + row * 172
            p.path(ellipse(x, y, 78, 74), 'none', gold, 5, .9)
            for k in range(20):
                a = 2 * math.pi * k / 20
                p.path(ellipse(x + 78 * math.cos(a), y + 74 * math.sin(a), 6, 6), gold)
            deer = [(-46, 8), (-30, -12), (10, -14), (28, -24), (34, -42), (50, -38), (44, -28), (36, -8), (24, 10), (44, 34), (38, 36), (14, 14), (-22, 14), (-48, 38), (-54, 34), (-38, 12)]
            p.path(smooth([(x + a, y + b) for a, b in deer], True), gold if (row + col) % 2 else blue)
            p.path(f'M{x + 40},{y - 42}q-14,-16 -30,-14M{x + 42},{y - 44}q4,-16 -8,-24', 'none', gold if (row + col) % 2 else blue, 4)
    for k in range(80):
        p.path(f'M180,{160 + k * 8}h620', 'none', '#2a0d10', 1.5, .2)
    p.add('</g>')
    for k in range(26):
        x = 200 + k * 23
        p.path(f'M{x},776q{p.random.randint(-8, 8)},16 {p.random.randint(-10, 10)},{p.random.randint(18, 40)}', 'none', '#8a2f33', 2.5, .8)
    p.save()


def coin_hoard():
    p = Picture('coin-hoard')
    p.shadow(480, 780, 330, 66)
    sock = smooth([(610, 330), (720, 300), (800, 380), (790, 560), (740, 680), (600, 740), (470, 720), (500, 620), (590, 560)], True)
    p.path(sock, p.fill('pale clay', False))
    p.add(f'<g {p.clip(sock)}>')
    for k in range(44):
        p.path(f'M{470 + k * 9},280q-14,240 -40,480', 'none', '#5f4c34', 2.5, .35)
        p.path(f'M440,{290 + k * 11}q180,-26 380,0', 'none', '#fff6df', 2, .3)
    p.add('</g>')
    coins = sorted(((p.random.gauss(400, 110), p.random.gauss(660, 62)) for _ in range(64)), key=lambda c: c[1])
    for x, y in coins:
        material = p.random.choice(('gold', 'gold', 'bronze', 'stone'))
        r, squash = p.random.uniform(30, 42), p.random.uniform(.55, .95)
        edge, body, light, deep = MATERIALS[material]
        p.add(f'<g transform="translate({x:.0f},{min(y, 770):.0f}) rotate({p.random.randint(-30, 30)}) scale(1,{squash:.2f})">')
        p.path(ellipse(3, 7, r, r), darker(edge, .7))
        p.path(ellipse(0, 0, r, r), p.fill(material, False), deep, 1.5)
        p.path(ellipse(0, 0, r * .8, r * .8), 'none', deep, 2, .5)
        mark = [f'M-9,-9h18v18h-18z', 'M-4,14q-14,-14 0,-30q16,-2 14,14q-2,12 -14,16', 'M0,-16v32M-14,0h28', 'M-14,8q14,-30 28,0']
        p.path(p.random.choice(mark), 'none', deep, 4, .65)
        p.add('</g>')
    p.save()


def jade_disc():
    p = Picture('jade-disc', '#e4dfcd')
    p.shadow(500, 812, 250, 40)
    p.path('M300,806l30,-60h300l30,60z', p.fill('wood', False))
    ring = ellipse(480, 450, 310, 310) + ellipse(490, 446, 92, 92)
    p.path(ring, darker(MATERIALS['jade'][0], .7), extra='fill-rule="evenodd" transform="translate(14,10)"')
    p.path(ring, p.fill('jade', False), extra='fill-rule="evenodd"')
    deep, light = MATERIALS['jade'][3], MATERIALS['jade'][2]
    for radius, n in ((134, 20), (176, 26), (218, 32), (260, 38)):
        for k in range(n):
            a = 2 * math.pi * (k + (radius // 42 % 2) / 2) / n
            x, y = 482 + radius * math.cos(a), 449 + radius * math.sin(a)
            p.path(ellipse(x + 2, y + 3, 12, 12), deep, opacity=.35)
            p.path(ellipse(x, y, 11, 11), MATERIALS['jade'][1])
            p.path(ellipse(x - 3, y - 4, 4, 4), light, opacity=.9)
    for r in (300, 110):
        p.path(ellipse(482, 449, r, r), 'none', deep, 4, .5)
    cloud = smooth([(300, 620), (380, 560), (420, 660), (520, 640), (620, 700), (560, 740), (420, 730)], True)
    p.add(f'<g {p.clip(ellipse(480, 450, 310, 310))}>')
    p.path(cloud, '#8a5a34', opacity=.22)
    p.add('</g>')
    p.path(smooth([(250, 320), (340, 220), (470, 172)]), 'none', '#fff', 16, .4)
    p.cut_out()
    p.save()


def gold_diadem():
    p = Picture('gold-diadem', '#e3dccf')
    p.shadow(480, 770, 330, 56)
    p.path('M170,560Q480,720 790,560L790,612Q480,776 170,612Z', p.fill('gold'))
    p.path('M170,560Q480,430 790,560', 'none', MATERIALS['gold'][0], 14, .8)
    p.path('M170,572Q480,732 790,572', 'none', MATERIALS['gold'][2], 4, .8)
    leaves = []
    for k in range(15):
        t = k / 14
        leaves.append((190 + 580 * t, 566 + 150 * 4 * t * (1 - t) * .5, -40 + 80 * t, 1))
        if k < 13:
            leaves.append((220 + 520 * t, 500 + 130 * 4 * t * (1 - t) * .45, -30 + 60 * t, .92))
        if k < 12:
            leaves.append((260 + 480 * t, 424 + 90 * 4 * t * (1 - t) * .4, -24 + 50 * t, .84))
    for x, y, turn, s in sorted(leaves, key=lambda l: l[1]):
        turn += p.random.uniform(-16, 16)
        p.add(f'<g transform="translate({x:.0f},{y:.0f}) rotate({turn:.0f}) scale({s * 1.15:.2f})">')
        leaf = 'M0,30C-34,6 -30,-44 0,-74C30,-44 34,6 0,30Z'
        p.path(leaf, darker(MATERIALS['gold'][0], .8), extra='transform="translate(5,5)"', opacity=.5)
        p.path(leaf, p.fill('gold', p.random.random() < .6), MATERIALS['gold'][0], 1.5)
        p.path('M0,30V-62M0,0l-16,-14M0,0l16,-14M0,-24l-13,-12M0,-24l13,-12', 'none', MATERIALS['gold'][0], 2, .6)
        p.add('</g>')
    for k in range(11):
        t = k / 10
        p.path(ellipse(200 + 560 * t, 592 + 4 * 68 * t * (1 - t), 10, 10), '#a3321f' if k % 2 else '#2d6f6b', MATERIALS['gold'][3], 3)
    p.save()


def jade_cicada():
    p = Picture('jade-cicada', '#e4dfcd')
    p.shadow(490, 790, 220, 46)
    deep, light = MATERIALS['jade'][3], MATERIALS['jade'][2]
    body = smooth([(480, 150), (560, 166), (606, 230), (610, 320), (640, 480), (620, 640), (560, 740), (480, 806), (400, 740), (340, 640), (320, 480), (350, 320), (354, 230), (400, 166)], True)
    p.path(body, darker(MATERIALS['jade'][0], .7), extra='transform="translate(16,12)"')
    p.path(body, p.fill('jade', False))
    p.grain(body, 'jade', 50)
    for side in (-1, 1):
        p.path(smooth([(480 + side * 14, 340), (480 + side * 120, 420), (480 + side * 128, 580), (480 + side * 60, 760)]), 'none', deep, 9, .7)
        p.path(smooth([(480 + side * 14, 340), (480 + side * 60, 500), (480 + side * 40, 740)]), 'none', deep, 7, .6)
        p.path(ellipse(480 + side * 96, 216, 34, 40), p.fill('jade', False), deep, 6)
        p.path(ellipse(480 + side * 90, 206, 9, 10), light)
    p.path('M356,316Q480,372 606,316', 'none', deep, 9, .7)
    p.path('M410,176Q480,236 550,176', 'none', deep, 7, .6)
    for k in range(5):
        p.path(f'M{452 - k * 1},{600 + k * 36}q28,16 56,0', 'none', deep, 6, .55)
    p.path(smooth([(370, 380), (352, 500), (380, 640)]), 'none', '#fff', 16, .4)
    p.path(smooth([(420, 190), (450, 176), (480, 174)]), 'none', '#fff', 10, .5)
    p.save()


def tomb_guardian():
    p = Picture('tomb-guardian')
    p.shadow(480, 826, 230)
    m, deep = 'glaze', MATERIALS['glaze'][0]
    p.path(polygon([(320, 790), (640, 790), (668, 836), (292, 836)]), p.fill('pale clay', False))
    for side in (-1, 1):  # antlers and wings
        p.path(smooth([(480 + side * 40, 220), (480 + side * 90, 150), (480 + side * 84, 80)]), 'none', MATERIALS['bone'][0], 17)
        p.path(smooth([(480 + side * 82, 160), (480 + side * 140, 130), (480 + side * 150, 80)]), 'none', MATERIALS['bone'][0], 13)
        p.path(smooth([(480 + side * 88, 120), (480 + side * 48, 90), (480 + side * 44, 60)]), 'none', MATERIALS['bone'][0], 11)
        for k in range(4):
            p.path(smooth([(480 + side * 96, 460 - k * 16), (480 + side * (190 + k * 16), 380 - k * 34), (480 + side * (214 + k * 14), 300 - k * 34), (480 + side * (150 + k * 8), 380 - k * 20)], True), p.fill(m, False), deep, 3)
        p.path(smooth([(480 + side * 120, 560), (480 + side * 150, 680), (480 + side * 110, 792), (480 + side * 40, 792), (480 + side * 60, 640)], True), p.fill(m), deep, 2)
    d = smooth([(380, 420), (480, 380), (580, 420), (600, 540), (560, 660), (540, 792), (420, 792), (400, 660), (360, 540)], True)
    p.path(d, p.fill(m), deep, 2)
    for k in range(5):
        p.path(f'M{424 + k * 4},{470 + k * 56}Q480,{500 + k * 56} {536 - k * 4},{470 + k * 56}', 'none', '#3f6b43', 9, .6)
    head = smooth([(390, 300), (400, 220), (480, 190), (560, 220), (570, 300), (540, 390), (480, 420), (420, 390)], True)
    p.path(head, p.fill('pale clay'), MATERIALS['pale clay'][3], 3)
    for side in (-1, 1):
        p.path(smooth([(480 + side * 84, 270), (480 + side * 128, 240), (480 + side * 112, 310)], True), p.fill('pale clay'), MATERIALS['pale clay'][3], 3)
        p.path(ellipse(480 + side * 40, 288, 22, 17), '#f9f1dd', '#3a2413', 5)
        p.path(ellipse(480 + side * 37, 291, 8, 9), '#3a2413')
        p.path(f'M{480 + side * 16},{262}Q{480 + side * 44},{240} {480 + side * 72},{266}', 'none', '#3a2413', 9)
    p.path('M480,300q-20,34 0,40q20,-6 0,-40', MATERIALS['pale clay'][1], '#3a2413', 4)
    p.path('M444,374q36,-16 72,0', 'none', '#3a2413', 7)
    for k, c in enumerate(('#3f6b43', '#f3e6c4', '#3f6b43')):
        p.path(f'M{410 + k * 56},420q10,120 -6,210', 'none', c, 13, .4)
    p.cut_out()
    p.save()


def painted_portrait():
    p = Picture('painted-portrait', '#dcd2bf')
    p.add('<ellipse cx="500" cy="850" rx="250" ry="30" fill="url(#shade)"/>')
    p.path('M262,120h436v720h-436z', p.fill('wood', False))
    for k in range(14):
        p.path(f'M{270 + k * 32},120q{p.random.randint(-8, 8)},360 {p.random.randint(-8, 8)},720', 'none', '#3d2614', 2, .3)
    panel = 'M296,160h368v640h-368z'
    p.path(panel, '#a9a083')
    p.add(f'<g {p.clip(panel)}>')
    p.path(smooth([(280, 820), (300, 680), (400, 620), (560, 620), (660, 680), (690, 820)]), '#6d2f3a')
    p.path(smooth([(420, 640), (480, 720), (545, 640)]), '#efe4cf', '#d8c8a8', 10)
    p.path(smooth([(430, 520), (428, 640), (480, 676), (536, 640), (530, 520)], True), '#b9825c')
    p.path(smooth([(366, 400), (370, 290), (430, 226), (530, 226), (592, 290), (596, 410), (570, 480), (390, 480)], True), '#2a1c15')
    face = smooth([(386, 390), (392, 310), (440, 268), (520, 268), (566, 310), (574, 390), (554, 480), (510, 550), (480, 562), (448, 550), (406, 480)], True)
    p.path(face, '#cf9a70')
    p.path(smooth([(500, 290), (560, 320), (568, 400), (540, 490), (490, 556), (520, 420)], True), '#a8714b', opacity=.5)
    for x in (436, 522):
        p.path(f'M{x - 34},388q34,-30 66,2q-32,22 -66,-2z', '#f5ead6')
        p.path(ellipse(x + 1, 387, 14, 15), '#33200f')
        p.path(ellipse(x - 4, 381, 4, 4), '#fff')
        p.path(f'M{x - 38},386q36,-36 72,2', 'none', '#22150c', 6)
        p.path(f'M{x - 44},350q40,-26 80,-2', 'none', '#22150c', 8, .9)
    p.path('M482,380q-4,50 -16,72q14,12 32,2', 'none', '#8b5836', 6)
    p.path('M444,498q18,-12 36,-2q18,-10 38,2q-36,30 -74,0z', '#9d4640')
    p.path('M444,498q38,8 74,0', 'none', '#6d2a27', 4)
    for x in (384, 578):
        p.path(ellipse(x, 462, 9, 9), MATERIALS['gold'][1])
        for dx in (-10, 0, 10):
            p.path(f'M{x},{470}l{dx},36', 'none', MATERIALS['gold'][1], 4)
            p.path(ellipse(x + dx, 510, 7, 7), '#f4efe3')
    for k in range(12):
        p.path(ellipse(410 + k * 13, 606 + 26 * math.sin(math.pi * k / 11), 8, 8), '#3c7a5d' if k % 2 else MATERIALS['gold'][1])
    for _ in range(120):
        x, y = p.random.uniform(300, 660), p.random.uniform(165, 800)
        p.path(f'M{x:.0f},{y:.0f}l{p.random.randint(-16, 16)},{p.random.randint(6, 20)}', 'none', p.random.choice(('#fff5dd', '#3b2516')), 2, .13)
    p.add('</g>')
    p.save()


def model_granary():
    p = Picture('model-granary')
    p.shadow(480, 800, 290, 56)
    d = revolved([(420, 226), (560, 236), (700, 240), (786, 236)])
    p.path(d, p.fill('pale clay'))
    p.grain(d, 'pale clay', 160)
    deep = MATERIALS['pale clay'][3]
    roof = smooth([(480, 170), (420, 250), (300, 370), (196, 440), (330, 476), (480, 486), (630, 476), (764, 440), (660, 370), (540, 250)], True)
    p.path(roof, p.fill('clay'))
    for k in range(13):
        a = -1.2 + 2.4 * k / 12
        p.path(smooth([(480 + 10 * a, 190), (480 + 110 * a, 330), (480 + 232 * a, 452 + 24 * math.cos(a))]), 'none', MATERIALS['clay'][3], 5, .55)
    p.path(ellipse(480, 168, 26, 22), p.fill('clay'), MATERIALS['clay'][3], 3)
    for y in (520, 640):
        p.path(band([(420, 226), (560, 236), (700, 240), (786, 236)], y, y + 9), deep, opacity=.5)
    p.path('M430,540h104v130h-104z', '#2a1c10')
    p.path('M534,540l52,14v128l-52,-12z', p.fill('wood', False), deep, 3)
    for _ in range(70):
        p.path(ellipse(p.random.gauss(470, 46), p.random.gauss(676, 16), 6, 4), p.random.choice(('#d9b25c', '#c59a44', '#e9cf8b')))
    p.path(smooth([(560, 690), (580, 668), (612, 672), (622, 692)], True), '#8f7d66', '#4a3d2d', 2)
    p.path('M620,690q30,6 40,-14', 'none', '#4a3d2d', 4)
    p.path(ellipse(572, 672, 8, 8), '#8f7d66', '#4a3d2d', 2)
    p.save()


def amphora():
    p = Picture('amphora', '#d9e0da')
    p.shadow(480, 834, 120)
    prof = [(130, 62), (150, 66), (166, 48), (270, 46), (320, 80), (380, 168), (460, 196), (580, 172), (700, 104), (790, 44), (826, 26)]
    for side in (-1, 1):
        h = smooth([(480 + side * 48, 176), (480 + side * 122, 184), (480 + side * 146, 270), (480 + side * 128, 350)])
        p.path(h, 'none', MATERIALS['clay'][0], 30)
        p.path(h, 'none', MATERIALS['clay'][1], 18)
    d = vessel(p, 'clay', prof)
    p.add(f'<g {p.clip(d)}>')
    for _ in range(130):
        x, y = p.random.uniform(290, 670), p.random.uniform(150, 820)
        r = p.random.uniform(3, 12)
        p.path(ellipse(x, y, r, r * .8), p.random.choice(('#e9e1cf', '#cfc7b2', '#8fa39a')), '#7c7562', 1, .55)
    for x, y in ((400, 480), (560, 600), (520, 400)):
        for k in range(8):
            a = 2 * math.pi * k / 8
            p.path(f'M{x},{y}l{24 * math.cos(a):.0f},{20 * math.sin(a):.0f}', 'none', '#f0e9d8', 5, .55)
    p.add('</g>')
    p.path(smooth([(330, 420), (304, 480), (330, 580)]), 'none', '#fff', 14, .3)
    p.cut_out()
    p.save()


def stone_anchor():
    p = Picture('stone-anchor', '#d9dfdc')
    p.shadow(500, 810, 270, 50)
    out = [(480, 150), (560, 180), (610, 280), (670, 480), (720, 700), (690, 784), (480, 806), (280, 784), (250, 700), (300, 480), (350, 280), (400, 180)]
    d = smooth(out, True)
    p.path(d, darker(MATERIALS['stone'][0], .75), extra='transform="translate(24,14)"')
    p.path(d, p.fill('stone', False))
    p.grain(d, 'stone', 300)
    for x, y, r in ((480, 280, 50), (370, 690, 44), (590, 690, 44)):
        p.path(ellipse(x, y, r, r), darker(MATERIALS['stone'][3], .7))
        p.path(ellipse(x + 7, y + 8, r - 9, r - 9), '#191713')
    p.path('M470,236q-12,-54 6,-86h22q-12,40 2,86z', darker(MATERIALS['stone'][1], .7), opacity=.7)
    rope = smooth([(500, 290), (560, 210), (660, 190), (740, 250), (800, 220), (880, 240)])
    p.path(rope, 'none', '#6b5330', 34)
    p.path(rope, 'none', '#b79a63', 24)
    p.add(f'<path d="{rope}" fill="none" stroke="#6b5330" stroke-width="24" stroke-dasharray="3 13"/>')
    p.cut_out()
    p.save()


def fish_mosaic():
    p = Picture('fish-mosaic', '#dcdcd0')
    p.add('<ellipse cx="500" cy="860" rx="380" ry="30" fill="url(#shade)"/>')
    p.path('M100,100h760v740h-760z', '#57503f')
    fishes = [(300, 300, 130, 46, 14, '#c0573a'), (650, 280, 110, 40, -18, '#cf9a3e'), (470, 480, 190, 84, -6, '#3d6f86'), (270, 650, 120, 42, 20, '#d4b46a'), (690, 640, 140, 46, -10, '#a84a44'), (480, 740, 90, 30, 4, '#6f8f70')]

    def colour(x, y):
        border = min(x - 110, 850 - x, y - 110, 830 - y)
        if border < 34:
            return '#8c3a2d' if (int(x / 34) + int(y / 34)) % 2 else '#e4d6b4'
        if border < 50:
            return '#2e3a3c'
        for cx, cy, a, b, turn, c in fishes:
            t = math.radians(turn)
            u, v = (x - cx) * math.cos(t) + (y - cy) * math.sin(t), -(x - cx) * math.sin(t) + (y - cy) * math.cos(t)
            inside = (u / a) ** 2 + (v / (b * (1 - .25 * u / a))) ** 2
            tail = -a * 1.5 < u < -a * .85 and abs(v) < (-u - a * .75) * .9
            if math.hypot(u - a * .66, v + b * .14) < 11:
                return '#14110c'
            if inside < 1 or tail:
                if inside > .72 and not tail:
                    return darker(c, .6)
                return darker(c, 1.25) if v > b * .2 else (darker(c, .8) if int(u / 17) % 3 == 0 else c)
        wave = math.sin(x * .02 + y * .035) + math.sin(y * .06)
        return '#9fbfb9' if wave > .7 else ('#c9d6c8' if wave > -.4 else '#b3cac2')
    step = 13
    for j in range(int(730 / step)):
        for i in range(int(748 / step)):
            x, y = 108 + i * step + step / 2, 106 + j * step + step / 2
            if p.random.random() < .012:
                continue
            c = darker(colour(x, y), p.random.uniform(.88, 1.1))
            s, dx, dy = step - p.random.uniform(1.6, 3), p.random.uniform(-.8, .8), p.random.uniform(-.8, .8)
            p.add(f'<rect x="{x - s / 2 + dx:.1f}" y="{y - s / 2 + dy:.1f}" width="{s:.1f}" height="{s:.1f}" fill="{c}"/>')
    p.save()


def star_map():
    p = Picture('star-map', '#cfd0cc')
    p.add('<ellipse cx="500" cy="866" rx="380" ry="28" fill="url(#shade)"/>')
    p.path('M96,96h768v752h-768z', p.fill('wood', False))
    p.path('M124,124h712v696h-712z', '#1d2b3f')
    silver = '#d9dbd2'
    for r in (110, 210, 310):
        p.path(ellipse(480, 472, r, r), 'none', silver, 2, .35)
    for k in range(12):
        a = math.pi * k / 6
        p.path(f'M{480 + 110 * math.cos(a):.0f},{472 + 110 * math.sin(a):.0f}L{480 + 310 * math.cos(a):.0f},{472 + 310 * math.sin(a):.0f}', 'none', silver, 1.5, .3)
    p.path(smooth([(150, 700), (300, 560), (470, 520), (640, 400), (810, 220)]), 'none', '#8fa0ad', 90, .16)
    for _ in range(9):  # figures: a chain of stars each
        a, r = p.random.uniform(0, 2 * math.pi), p.random.uniform(90, 290)
        x, y, chain = 480 + r * math.cos(a), 472 + r * math.sin(a), []
        for _ in range(p.random.randint(4, 7)):
            chain.append((x, y))
            a += p.random.uniform(-.9, .9)
            x, y = min(800, max(160, x + 46 * math.cos(a))), min(790, max(150, y + 46 * math.sin(a)))
        p.path('M' + 'L'.join(f'{x:.0f},{y:.0f}' for x, y in chain), 'none', silver, 2, .55)
        for x, y in chain:
            p.path(ellipse(x, y, 7, 7), '#f3f0df')
    for _ in range(150):
        r = p.random.choice((1.6, 2.2, 3.4))
        p.path(ellipse(p.random.uniform(140, 820), p.random.uniform(140, 806), r, r), silver, opacity=.8)
    p.path(ellipse(556, 770, 12, 10), MATERIALS['gold'][1])
    p.save()


def water_clock():
    p = Picture('water-clock', '#d9dfda')
    p.shadow(500, 836, 280, 44)
    deep = MATERIALS['bronze'][3]
    for k, (x, y) in enumerate(((290, 250), (420, 420), (550, 590))):
        p.path(f'M{x - 100},{y + 96}h200v{740 - y}h-200z', p.fill('wood', False))
        prof = [(y - 60, 92), (y - 40, 84), (y + 70, 72), (y + 96, 78)]
        vessel(p, 'bronze', prof, cx=x)
        p.path(band(prof, y - 8, y, x), deep, opacity=.7)
        p.path(smooth([(x + 74, y + 66), (x + 120, y + 70), (x + 128, y + 96)]), 'none', MATERIALS['bronze'][0], 13)
        p.path(f'M{x + 128},{y + 98}V{y + 138}', 'none', '#9fc7cc', 6, .9)
    tall = [(640, 74), (660, 68), (800, 68), (832, 74)]
    vessel(p, 'bronze', tall, cx=692)
    p.path('M686,640V380h12V640z', p.fill('gold', False))
    for k in range(9):
        p.path(f'M698,{400 + 26 * k}h16', 'none', MATERIALS['gold'][0], 4)
    p.path(ellipse(692, 372, 22, 20), p.fill('gold'), MATERIALS['gold'][0], 3)
    p.save()


def rain_scroll():
    p = Picture('rain-scroll', '#ddd6c6')
    p.path('M326,96h308v770h-308z', '#b8a98c')
    p.path('M306,84h348v22h-348zM296,856h368v24h-368z', p.fill('wood', False))
    silk = 'M350,150h260v640h-260z'
    p.path(silk, '#e9e2cf')
    p.add(f'<g {p.clip(silk)}>')
    for k, (base, shade) in enumerate(((340, .16), (420, .26), (520, .42))):
        ridge = [(340 + 34 * i, base + p.random.uniform(-70, 30) - 40 * math.sin(i * .9 + k)) for i in range(9)]
        p.path(smooth(ridge) + 'L630,640L330,640Z', '#4b5350', opacity=shade)
    for _ in range(70):
        x, y = p.random.uniform(340, 640), p.random.uniform(150, 700)
        p.path(f'M{x:.0f},{y:.0f}l-9,44', 'none', '#f4efe2', 3, .75)
    for k in range(3):
        p.path(smooth([(340, 640 + 38 * k), (420, 630 + 38 * k), (520, 648 + 38 * k), (620, 634 + 38 * k)]), 'none', '#59615d', 3, .4)
    p.path('M452,690q34,18 72,0', 'none', '#26241f', 7)
    p.path('M486,688v-22', 'none', '#26241f', 5)
    for x, h in ((392, 90), (410, 120), (580, 100)):
        p.path(smooth([(x, 620), (x + 4, 620 - h * .5), (x - 3, 620 - h)]), 'none', '#2c2b26', 5, .8)
        for k in range(7):
            p.path(ellipse(x + p.random.uniform(-22, 22), 620 - h + p.random.uniform(-14, 30), 13, 8), '#2c2b26', opacity=.5)
    p.path('M576,176h20v20h-20zM576,202h20v20h-20z', '#b23a2a')
    p.add('</g>')
    p.save()


def ink_stone():
    p = Picture('ink-stone', '#e2dccd')
    p.shadow(500, 770, 320, 60)
    out = smooth([(200, 380), (260, 300), (480, 270), (700, 300), (770, 390), (780, 620), (720, 730), (480, 756), (240, 730), (188, 620)], True)
    p.path(out, darker(MATERIALS['dark stone'][0], .7), extra='transform="translate(14,34)"')
    p.path(out, p.fill('dark stone', False))
    p.grain(out, 'dark stone', 160)
    p.path(ellipse(480, 560, 210, 130), darker(MATERIALS['dark stone'][0], .75))
    p.path(ellipse(484, 566, 196, 116), '#191a1c')
    p.path(smooth([(340, 530), (420, 470), (520, 462)]), 'none', '#8c97a3', 7, .5)
    p.path(smooth([(380, 580), (450, 540), (540, 556), (584, 580), (540, 606), (450, 616)], True), '#4c5056', '#7d858c', 3)
    p.path(polygon([(380, 580), (340, 552), (348, 612)]), '#4c5056', '#7d858c', 3)
    for k in range(4):
        p.path(f'M{440 + 28 * k},560q12,20 0,38', 'none', '#868e95', 3, .8)
    p.path(ellipse(556, 574, 6, 6), '#d7dde0')
    for k in range(7):
        x = 270 + 70 * k
        p.path(f'M{x - 26},{352}q26,-34 52,0', 'none', '#8a867c', 5, .55)
    p.path('M640,250l150,-130l26,26l-140,146z', p.fill('wood', False), '#2b2018', 3)
    p.path('M640,250l-40,78l76,-36z', '#1b1a19')
    p.save()


def river_lute():
    p = Picture('river-lute', '#e0d7c4')
    p.add('<g transform="rotate(24 480 480)">')
    p.add('<ellipse cx="520" cy="640" rx="230" ry="280" fill="url(#shade)" opacity=".6"/>')
    p.path(polygon([(448, 80), (512, 80), (524, 420), (436, 420)]), p.fill('wood'))
    body = smooth([(480, 350), (560, 420), (640, 560), (650, 690), (580, 800), (480, 826), (380, 800), (310, 690), (320, 560), (400, 420)], True)
    p.path(body, darker(MATERIALS['wood'][0], .7), extra='transform="translate(16,10)"')
    p.path(body, p.fill('pale clay'), MATERIALS['wood'][0], 7)
    p.path(smooth([(356, 560), (346, 680), (400, 780)]), 'none', '#fff6df', 14, .35)
    for k in range(12):
        y = 150 + 44 * k
        p.path(f'M{452 - k},{y}h{56 + 2 * k}', 'none', MATERIALS['bone'][1] if k < 6 else MATERIALS['wood'][0], 6)
    p.path('M392,740h176v20h-176z', p.fill('wood', False), MATERIALS['wood'][3], 2)
    for k in range(4):
        p.path(f'M{462 + 12 * k},84L{444 + 24 * k},746', 'none', '#f7f1df', 2.6)
    for side in (-1, 1):
        for k in range(2):
            p.path(f'M{480 + side * 30},{104 + 36 * k}h{side * 70}', 'none', MATERIALS['wood'][3], 15)
        p.path(smooth([(480 + side * 66, 560), (480 + side * 96, 590), (480 + side * 84, 640)]), 'none', MATERIALS['wood'][3], 8, .8)
    p.path(polygon([(448, 80), (512, 80), (500, 30), (460, 30)]), p.fill('jade', False), MATERIALS['jade'][3], 3)
    p.add('</g>')
    p.save()


def dance_mask():
    p = Picture('dance-mask', '#dfd9cb')
    p.shadow(480, 836, 170)
    p.path('M468,690h24v140h-24z', p.fill('wood'))
    p.path('M400,820h160v22h-160z', p.fill('wood', False))
    for side in (-1, 1):
        for k in range(6):
            x = 480 + side * (120 + 26 * k)
            p.path(smooth([(480 + side * 90, 250), (x, 170 - 6 * k), (x + side * 34, 250 + 24 * k)]), 'none', '#3d6f86' if k % 2 else '#2c4a5e', 20, .9)
    d = smooth([(480, 130), (600, 160), (674, 280), (676, 440), (620, 610), (540, 716), (480, 736), (420, 716), (340, 610), (284, 440), (286, 280), (360, 160)], True)
    p.path(d, darker('#7a2f24', .7), extra='transform="translate(16,12)"')
    p.path(d, p.fill('clay'))
    p.grain(d, 'clay', 110)
    white, dark = '#f3e8cf', '#2b1710'
    p.add(f'<g {p.clip(d)}>')
    for k in range(3):
        p.path(smooth([(270, 236 + 26 * k), (380, 210 + 26 * k), (480, 244 + 26 * k), (590, 210 + 26 * k), (690, 240 + 26 * k)]), 'none', '#3d6f86', 9, .85)
    p.path(smooth([(480, 300), (516, 470), (540, 520), (480, 548), (420, 520), (444, 470)], True), p.fill('clay'), dark, 3)
    for side, lift in ((-1, -10), (1, 16)):  # it scolds on the left and laughs on the right
        x = 480 + side * 104
        p.path(ellipse(x, 400, 56, 38), white, dark, 7)
        p.path(ellipse(x + 6, 404, 20, 22), dark)
        p.path(smooth([(x - 74, 352 + side * lift), (x, 322), (x + 74, 352 - side * lift)]), 'none', dark, 20)
        p.path(spiral(480 + side * 134, 530, 42, 1.8, side), 'none', white, 9, .85)
    p.path(smooth([(366, 640), (420, 600), (500, 604), (590, 566), (604, 600), (540, 656), (450, 668)], True), dark)
    for k in range(6):
        p.path(f'M{404 + 30 * k},{618 - 5 * k}h22v20h-22z', white)
    p.add('</g>')
    p.path(smooth([(316, 300), (306, 400), (340, 540)]), 'none', '#fff', 13, .28)
    p.cut_out()
    p.save()


def river_core():
    p = Picture('river-core', '#dbdcd2')
    p.add('<ellipse cx="500" cy="870" rx="340" ry="26" fill="url(#shade)"/>')
    for column in range(3):
        x = 220 + 190 * column
        p.path(f'M{x - 14},96h168v770h-168z', p.fill('wood', False))
        core = f'M{x},110h140v742h-140z'
        p.path(core, '#8a7458')
        p.add(f'<g {p.clip(core)}>')
        y = 110 if column else 200
        if not column:
            p.path(f'M{x},110h140v90h-140z', '#efe8d8')
        while y < 852:
            h = p.random.uniform(5, 30)
            tone = p.random.choice(('#6b5a45', '#9a8466', '#b09a78', '#574a3b', '#7f7563', '#a58d6a'))
            wave = [(x + 35 * i, y + p.random.uniform(-4, 4)) for i in range(5)]
            p.path(smooth(wave) + f'L{x + 140},{y + h + 8:.0f}L{x},{y + h + 8:.0f}Z', tone)
            p.path(smooth(wave), 'none', '#2f271e', 3, .55)
            y += h
        if column == 1:
            p.path(smooth([(x, 520), (x + 60, 516), (x + 140, 523)]), 'none', '#b8402c', 8)
        for _ in range(26):
            p.path(ellipse(p.random.uniform(x, x + 140), p.random.uniform(220, 850), 5, 3), '#d8ccb2', opacity=.6)
        p.path(f'M{x + 16},110v742', 'none', '#fff', 20, .14)
        p.add('</g>')
    p.save()


def sherd_tray():
    p = Picture('sherd-tray', '#e1d9c8')
    p.shadow(500, 800, 350, 46)
    p.path('M120,190h720v600h-720z', p.fill('wood', False))
    p.path('M146,216h668v548h-668z', '#efe6d3')
    for row in range(7):
        for col in range(9):
            cx, cy, n = 184 + 74 * col, 256 + 78 * row, p.random.randint(4, 6)
            turn = p.random.uniform(0, 6.28)
            pts = [(cx + p.random.uniform(20, 32) * math.cos(turn + 2 * math.pi * k / n), cy + p.random.uniform(18, 30) * math.sin(turn + 2 * math.pi * k / n)) for k in range(n)]
            edge, body, _, deep = MATERIALS[p.random.choice(('clay', 'pale clay', 'clay', 'stone'))]
            p.path(polygon([(x + 5, y + 6) for x, y in pts]), darker(edge, .7), opacity=.6)
            p.path(polygon(pts), darker(body, p.random.uniform(.85, 1.15)), edge, 2)
            p.path(ellipse(cx, cy, 9, 11), deep, opacity=.5)
            for r in (4, 7):
                p.path(ellipse(cx, cy, r, r * 1.3), 'none', body, 1.2, .8)
            if p.random.random() < .3:
                p.path(f'M{cx - 20:.0f},{cy - 14:.0f}l36,-4', 'none', '#34190f', 4, .7)
    p.save()


def forged_ding():
    p = Picture('forged-ding', '#dcdccb')
    p.shadow(480, 816, 220)
    deep = MATERIALS['gold'][3]
    for x, lean in ((366, -1), (594, 1), (480, 0)):
        leg = [(x - 30, 560), (x - 30 + lean * 6, 680), (x - 40 + lean * 14, 806), (x + 40 + lean * 14, 806), (x + 30 + lean * 6, 680), (x + 30, 560)]
        p.path(smooth(leg, True), p.fill('bronze'), deep, 2)
    for x in (344, 616):
        p.path(f'M{x - 40},300V200q0,-30 40,-30t40,30V300h-24V212q0,-14 -16,-14t-16,14V300z', p.fill('bronze'), deep, 2)
    prof = [(290, 206), (316, 200), (360, 204), (470, 214), (560, 190), (630, 110), (646, 60)]
    d = vessel(p, 'bronze', prof, tilt=.2)
    p.add(f'<g {p.clip(d)}>')
    for y in (372, 486):
        p.path(band(prof, y, y + 7, tilt=.2), deep, opacity=.75)
    for k in range(11):  # too regular, and that gave it away
        a = -1.2 + 2.4 * k / 10
        p.path(spiral(480 + 204 * math.sin(a), 424 + 42 * math.cos(a), 24 * max(.4, math.cos(a)), 2.2, 1 if k % 2 else -1), 'none', deep, 6, .75)
    for _ in range(16):
        x, y, r = p.random.uniform(280, 680), p.random.uniform(330, 630), p.random.uniform(14, 46)
        p.path(ellipse(x, y, r, r * .6), '#58b39a', opacity=.5)
    p.add('</g>')
    p.path('M640,590l110,34v96l-120,-20z', '#f4ecd8', '#8b7a58', 3)
    for k in range(3):
        p.path(f'M656,{628 + 22 * k}l74,{14}', 'none', '#6d2f3a', 4, .8)
    p.path('M640,590q-40,-6 -56,30', 'none', '#8b7a58', 4)
    p.save()


def thunder_drum():
    p = Picture('thunder-drum', '#ded3c2')
    p.shadow(480, 836, 300, 44)
    for side in (-1, 1):
        p.path(polygon([(480 + side * 90, 470), (480 + side * 130, 470), (480 + side * 250, 836), (480 + side * 190, 836)]), p.fill('wood', False), '#2b1a0e', 3)
    p.path('M270,700h420v26h-420z', p.fill('wood', False))
    barrel = ellipse(480, 400, 316, 300)
    p.path(barrel, p.fill('clay'), '#4a2113', 6)
    for k in range(40):
        a = 2 * math.pi * k / 40
        p.path(ellipse(480 + 288 * math.cos(a), 400 + 273 * math.sin(a), 10, 10), p.fill('gold'), MATERIALS['gold'][3], 2)
    p.path(ellipse(480, 400, 258, 244), p.fill('bone', False), '#5d4526', 5)
    p.grain(ellipse(480, 400, 258, 244), 'bone', 140)
    for turn in range(3):
        a = 2 * math.pi * turn / 3 - .5
        p.add(f'<g transform="translate({480 + 104 * math.cos(a):.0f},{400 + 98 * math.sin(a):.0f}) rotate({math.degrees(a) + 90:.0f})">')
        p.path(spiral(0, 0, 72, 2, 1), 'none', '#8c3a2d', 15, .85)
        p.path(smooth([(72, 0), (96, 60), (30, 110)]), 'none', '#8c3a2d', 11, .7)
        p.add('</g>')
    p.path(ellipse(480, 400, 26, 25), '#8c3a2d', opacity=.85)
    p.path(smooth([(270, 300), (330, 214), (420, 176)]), 'none', '#fff', 15, .35)
    p.path('M690,640l150,-120l14,18l-146,126z', p.fill('wood', False), '#2b1a0e', 2)
    p.path(ellipse(690, 656, 34, 30), '#b23a2a', '#6d211a', 4)
    p.save()


if __name__ == '__main__':
    for draw in (boundary_stone, standing_king, painted_jar, bone_flute, millstone, tripod_ding, chime_bells, owl_vessel, oracle_bone, clay_letter,
                 papyrus_account, seal_stones, glass_flask, camel_figure, silk_fragment, coin_hoard, jade_disc, gold_diadem, jade_cicada,
                 tomb_guardian, painted_portrait, model_granary, amphora, stone_anchor, fish_mosaic, star_map, water_clock, rain_scroll, ink_stone,
                 river_lute, dance_mask, river_core, sherd_tray, forged_ding, thunder_drum, painted_jar_round, glass_flask_round, model_granary_round):
        draw()
