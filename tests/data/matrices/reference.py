"""Writes NAME.csv beside each document: its BRDF from the formulas, written out without matrices, for the pairs of ../publications/directions.txt."""

import csv
import math
import pathlib

HERE = pathlib.Path(__file__).parent


def half(light, view):
    total = [a + b for a, b in zip(light, view)]
    length = math.sqrt(sum(x * x for x in total))
    return [x / length for x in total]


def olano_baker(light, view):
    h = half(light, view)
    x, y = h[0] / h[2] - 0.12, h[1] / h[2] + 0.05
    a, b, c = 0.06 + 1 / 25, 0.02, 0.03 + 1 / 25  # the covariance: a b, b c
    determinant = a * c - b * b
    exponent = (c * x * x - 2 * b * x * y + a * y * y) / determinant
    p = math.exp(-exponent / 2) / (2 * math.pi * math.sqrt(determinant))
    lobe = p / (4 * h[2] ** 4 * max(light[2], view[2]))
    return [0.2 / math.pi + k * lobe for k in (0.9, 0.6, 0.3)]


def heitz(light, view):
    # M w = light, solved by hand: the second row stands alone, the others are a pair.
    a, b, c = 0.45, 0.22, -0.17
    pair = a * 1 - b * c
    w = [(light[0] - b * light[2]) / pair, light[1] / 0.38, (a * light[2] - c * light[0]) / pair]
    length = math.sqrt(sum(x * x for x in w))
    determinant = 1 / (pair * 0.38)
    d = max(0, w[2] / length) / math.pi * determinant / length**3
    return [0.85 * d / light[2]] * 3


def walter(light, view):
    psi, ax, ay = math.radians(30), 0.45, 0.2

    def turned(v):  # into the frame of the ellipsoid
        return [math.cos(psi) * v[0] + math.sin(psi) * v[1], -math.sin(psi) * v[0] + math.cos(psi) * v[1], v[2]]

    h = turned(half(light, view))
    form = (h[0] / ax) ** 2 + (h[1] / ay) ** 2 + h[2] ** 2
    d = 1 / (math.pi * ax * ay * form**2)

    def g1(v):
        t = turned(v)
        return 2 * v[2] / (v[2] + math.sqrt((ax * t[0]) ** 2 + (ay * t[1]) ** 2 + t[2] ** 2))

    x, y, z = 0.35, 0.33, 0.18
    colour = [3.2405 * x - 1.5371 * y - 0.4985 * z, -0.9693 * x + 1.8760 * y + 0.0416 * z, 0.0556 * x - 0.2040 * y + 1.0572 * z]
    return [c * d * g1(light) * g1(view) / (4 * light[2] * view[2]) for c in colour]


def directions():
    for line in (HERE / "../publications/directions.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            numbers = [float(x) for x in line.replace(",", " ").split()]
            yield numbers[:3], numbers[3:6]


for name, model in {"olano-baker-2010": olano_baker, "heitz-2016": heitz, "walter-2015": walter}.items():
    with open(HERE / f"{name}.csv", "w", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow("Lx Ly Lz Vx Vy Vz r g b".split())
        for light, view in directions():
            writer.writerow([repr(x) for x in [*light, *view, *model(light, view)]])
