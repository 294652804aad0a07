"""Checks of the source that no compiler makes. Reads the files to check from standard input, one a line."""

import os
import re
import sys

LIBRARY = re.compile(r"texbrdf_library\((\w+) DEPENDS ([^)]*)\)")
TARGET = re.compile(r"texbrdf_(\w+)")


def read_layers():
    """Who may include whom, from the dependencies in the CMake files: {"eval": {"ir", "semantics", ...}, ...}."""
    layers = {"compiler": {"eval", "emit", "analysis", "scene"}}
    for path in ("compiler/CMakeLists.txt", "server/CMakeLists.txt"):
        with open(path, encoding="utf-8") as file:
            for folder, dependencies in LIBRARY.findall(file.read()):
                layers[folder] = set(TARGET.findall(dependencies))

    def everything_below(folder):
        direct = layers.get(folder, set())
        return direct.union(*(everything_below(below) for below in direct))

    folders = layers.keys() - {"compiler"}
    return {folder: everything_below(folder) & folders for folder in folders} | {"main.cpp": {"cli"}}


LAYERS = read_layers()

# What only some folders may know: (header pattern, folders).
RESTRICTED_HEADERS = [
    (re.compile(r"nlohmann/"), ("server/lsp/", "server/scene_json/")),
    (re.compile(r"CLI/"), ("server/cli/",)),
    (re.compile(r"boost/"), ("server/web/",)),
    (re.compile(r"GLFW/"), ("server/window/",)),
    (re.compile(r"(epoxy|EGL|GL|glslang|SPIRV)/"), ("server/render/",)),
    (re.compile(r"(thread|condition_variable|future|stop_token|fstream|iostream|filesystem|unistd\.h)$"),
     ("server/", "tests/")),
    # The compiler starts no thread, but several may read a Snapshot, parts of which are formed at the first reading.
    (re.compile(r"mutex$"), ("server/", "tests/", "compiler/analysis/")),
]

LONGEST_FILE = 800
SOURCE = re.compile(r"\.(h|cpp)$")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
# Somebody's own folders, which others do not have.
OUTSIDE = re.compile(r"(?<![\w.])/(home|root)/\w")
INCLUDED_OFTEN = re.compile(r"Included by each\b")
FILE_NAME = re.compile(r"^[a-z0-9_]+\.(h|cpp|def)$")


def include_faults(path, lines):
    top, folder = path.split("/")[:2]
    allowed = LAYERS.get(folder)
    if allowed is None:
        yield 1, f"the folder {top}/{folder} is no texbrdf_library of {top}/CMakeLists.txt"
        return
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        header = match.group(1)
        first = header.split("/")[0]
        if "/" in header and first in LAYERS and first != folder and first not in allowed:
            yield number, f"{folder} must not include {header}"
        for pattern, places in RESTRICTED_HEADERS:
            if pattern.match(header) and not path.startswith(places):
                yield number, f"{header} belongs to {', '.join(places)}"


def faults(path):
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    if SOURCE.search(path):
        if path.startswith(("compiler/", "server/")):
            yield from include_faults(path, lines)
        if path.startswith(("compiler/", "server/")) and len(lines) > LONGEST_FILE:
            yield len(lines), f"longer than {LONGEST_FILE} lines"
        if not FILE_NAME.match(os.path.basename(path)):
            yield 1, "names of source files are snake_case"
        if path.endswith(".h") and lines[:1] != ["#pragma once"] and not INCLUDED_OFTEN.search("".join(lines[:3])):
            yield 1, "a header starts with #pragma once, or says that it is `Included by each …`"
    if not path.startswith("tests/lint/"):
        for number, line in enumerate(lines, 1):
            if OUTSIDE.search(line):
                yield number, "mentions a place outside the repository"


def main():
    count = 0
    for path in sys.stdin.read().splitlines():
        if path.endswith((".png", ".vsix")):
            continue
        for line, what in faults(path):
            print(f"{path}:{line}: {what}")
            count += 1
    return 1 if count else 0


sys.exit(main())
