"""Writes docs/gallery: a page for each model of tests/data/models, with its equations, pictures and plots.

    docs/write_gallery.py PROGRAM
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GALLERY = ROOT / "docs" / "gallery"
MODELS = ROOT / "tests" / "data" / "models"
NOT_A_MODEL = {"conventions"}  # shows names, not a material

EQUATION = re.compile(r"\\begin\{(equation|align)\*?\}(.*?)\\end\{\1\*?\}", re.DOTALL)
COMMENT = re.compile(r"(?<!\\)%.*")
PLOTS = {
    "lobe": ("lobe.png", ["--view", "lobe", "--size", "480x380"]),
    "polar": ("polar.svg", ["--view", "polar", "--size", "560x380"]),
    "albedo": ("albedo.svg", ["--view", "albedo", "--size", "560x380"]),
}


class Program:
    def __init__(self, path):
        self.path = path
        help_text = subprocess.run([path, "render", "--help"], check=True, capture_output=True, text=True).stdout
        self.has_objects = "--object" in help_text

    def run(self, *arguments):
        done = subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, arguments))}: {done.stderr}")

    def draw(self, document, picture, *arguments):
        self.run("render", document, "--device", "cpu", "--size", "200", *arguments, "-o", picture)


def body_of(document):
    text = document.read_text(encoding="utf-8")
    inside = re.search(r"\\begin\{document\}(.*)\\end\{document\}", text, re.DOTALL)
    return COMMENT.sub("", inside.group(1) if inside else text)


def markdown_of_prose(text):
    text = text.replace("---", "—").replace("--", "–").replace("~", " ").replace("\\\\", " ")
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in re.split(r"\n\s*\n", text) if paragraph.strip())


def equations_page(body):
    """Prose and equations in their order; equations as GitHub shows them."""
    parts = []
    end = 0
    for match in EQUATION.finditer(body):
        parts.append(markdown_of_prose(body[end:match.start()]))
        lines = [line.strip() for line in match.group(2).strip().splitlines() if line.strip()]
        parts.append("$$\n" + "\n".join(lines) + "\n$$")
        end = match.end()
    parts.append(markdown_of_prose(body[end:]))
    return [part for part in parts if part]


def title_of(parts, name):
    """What the document says first, else its file's name."""
    first = parts[0] if parts and not parts[0].startswith("$$") else name.replace("-", " ").capitalize()
    return first.split(". ")[0].rstrip(".:")


def write_model(program, document):
    name = document.stem
    pictures = [("sphere.png", "the lit sphere")]
    program.draw(document, GALLERY / f"{name}-sphere.png")
    if program.has_objects:
        program.draw(document, GALLERY / f"{name}-teapot.png", "--object", "teapot")
        pictures.append(("teapot.png", "the lit teapot"))
    for file, arguments in PLOTS.values():
        program.run("plot", document, *arguments, "-o", GALLERY / f"{name}-{file}")
    parts = equations_page(body_of(document))
    page = [f"# {title_of(parts, name)}",
            f"[The document](../../tests/data/models/{name}.tex) · [all models](README.md)",
            " ".join(f"![{what}]({name}-{file})" for file, what in pictures),
            "## Equations", *parts,
            "## The lobe, light at 45°", f"![lobe]({name}-lobe.png)",
            "## The plane of incidence, light at 45°", f"![polar plot]({name}-polar.svg)",
            "## Directional albedo", f"![albedo]({name}-albedo.svg)"]
    (GALLERY / f"{name}.md").write_text("\n\n".join(page) + "\n", encoding="utf-8")
    return title_of(parts, name)


def write_index(titles):
    rows = [f"| [{title}]({name}.md) | ![sphere]({name}-sphere.png) | <img src=\"{name}-lobe.png\" width=\"300\" alt=\"lobe\"> |"
            for name, title in titles.items()]
    page = ["# Gallery", "Eleven models, written by `./dev docs` from their documents. [Plots](../plots.md) says what the plots show. [Example scenes](scenes/README.md) have a page of their own.",
            "\n".join(["| model | sphere | lobe |", "|---|---|---|", *rows])]
    (GALLERY / "README.md").write_text("\n\n".join(page) + "\n", encoding="utf-8")


def main(path):
    program = Program(path)
    GALLERY.mkdir(exist_ok=True)
    documents = [document for document in sorted(MODELS.glob("*.tex")) if document.stem not in NOT_A_MODEL]
    write_index({document.stem: write_model(program, document) for document in documents})


main(sys.argv[1])
