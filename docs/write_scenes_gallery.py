"""Draws docs/gallery/scenes: a picture beside each *.scene.json, and the page that shows them.

    docs/write_scenes_gallery.py PROGRAM

tests/render compares fresh pictures with these.
"""

import pathlib
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent / "gallery" / "scenes"
COLUMNS = 3

SENTENCES = {
    "two_colours": "A sphere whose material blends red and blue by 0.618.",
    "one_sphere": "A sphere of radius 0.5 at (0.3, 0.2, 0), scaled by (1, 2, 4).",
    "three_spheres": "Three spheres in a union, two red ones and a blue one above.",
    "both_models": "Both models, the one sphere moved by (−0.8, 0, 0).",
    "cuboid_moved": "A cuboid moved by (2, 1, 0).",
    "cuboid_scaled": "A cuboid scaled by (1, 2, 4).",
    "cuboid_rotated": "A cuboid rotated by (π/4, π/6, π/4).",
    "repeated_infinitely": "Rounded cuboids without end.",
    "repeated_5_by_9": "5 × 9 rounded cuboids.",
    "union": "A clay cuboid and a blue sphere together.",
    "subtraction": "The cuboid without the sphere: what the sphere cut is blue.",
    "intersection": "What both have in common.",
    "smooth_union": "The union with a soft seam.",
    "smooth_subtraction": "The subtraction with a soft edge.",
    "smooth_intersection": "The intersection with soft edges.",
    "bent_cuboid": "A long cuboid, bent.",
    "displaced_torus": "A torus with waves of a sine on it.",
    "twisted_torus": "A standing torus, twisted about its upright axis.",
    "extruded_vesica": "A vesica, which is flat, made a solid along z.",
    "revolved_cross": "A cross turned around the upright axis.",
    "elongated_ellipsoid": "An ellipsoid with straight parts.",
    "shell": "A hollow sphere, cut open.",
    "rounding": "A cuboid with round edges.",
    "axes_and_planes": "X red, Y green, Z blue; XY yellow, XZ magenta, YZ cyan.",
    "steered": "A ball with the BRDF of a document over a floor made by a primitive of its own; in a window I, J, K, L move it.",
}

HEAD = """# Scenes

How scenes are written is told in [scenes.md](../../scenes.md), how they are drawn in [pictures.md](../../pictures.md). The pictures are written
by `./dev docs`, as `texbrdf render NAME.scene.json --size 200 --samples 16 -o NAME.png` does."""


def draw(program, name):
    arguments = [program, "render", FOLDER / f"{name}.scene.json", "--size", "200", "--samples", "16", "-o",
                 FOLDER / f"{name}.png"]
    done = subprocess.run([str(argument) for argument in arguments], capture_output=True, text=True)
    if done.returncode != 0 or done.stderr:
        sys.exit(f"{name}: {done.stderr}")


def cell(name):
    if name is None:
        return " "
    return f"![{name}]({name}.png)<br>[`{name}`]({name}.scene.json): {SENTENCES[name]}"


def main(program):
    scenes = {path.name.removesuffix(".scene.json") for path in FOLDER.glob("*.scene.json")}
    if scenes != set(SENTENCES):
        sys.exit(f"a scene without a sentence, or a sentence without a scene: {scenes ^ set(SENTENCES)}")
    names = list(SENTENCES)
    for name in names:
        draw(program, name)
    names += [None] * (-len(names) % COLUMNS)
    rows = ["| " + " | ".join(map(cell, names[i:i + COLUMNS])) + " |" for i in range(0, len(names), COLUMNS)]
    table = ["|" + " |" * COLUMNS, "|" + "---|" * COLUMNS, *rows]
    (FOLDER / "README.md").write_text(HEAD + "\n\n" + "\n".join(table) + "\n", encoding="utf-8")


main(sys.argv[1])
