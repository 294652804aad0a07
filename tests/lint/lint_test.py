"""lint.py finds what it is for: each case is a file with a fault, and a word of what is said about it."""

import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent

CASES = [
    ("compiler/eval/a.cpp", '#include "emit/emit.h"\n', "eval must not include emit/emit.h"),
    ("compiler/syntax/a.cpp", '#include "ir/graph.h"\n', "syntax must not include ir/graph.h"),
    ("compiler/analysis/a.cpp", '#include "eval/evaluate.h"\n', "analysis must not include"),
    ("server/features/a.cpp", '#include "lsp/session.h"\n', "features must not include"),
    ("server/main.cpp", '#include "lsp/session.h"\n', "main.cpp must not include"),
    ("compiler/ir/a.cpp", "#include <thread>\n", "thread belongs to"),
    ("server/features/a.cpp", "#include <nlohmann/json.hpp>\n", "belongs to"),
    ("server/cli/a.cpp", "#include <epoxy/gl.h>\n", "belongs to"),
    ("server/cli/a.cpp", "#include <GLFW/glfw3.h>\n", "belongs to"),
    ("compiler/ir/a.h", "// no guard\n", "#pragma once"),
    ("compiler/ir/CamelCase.cpp", "\n", "snake_case"),
    ("compiler/ir/a.cpp", "\n" * 801, "longer than 800"),
    ("compiler/unknown/a.cpp", "\n", "is no texbrdf_library"),
    ("docs/a.md", "see /home/me/design.md\n", "outside the repository"),
]
CLEAN = [
    ("compiler/analysis/a.cpp", '#include "ir/graph.h"\n#include "analysis/b.h"\n#include <vector>\n'),
    ("server/lsp/a.cpp", '#include "features/hover.h"\n#include <nlohmann/json.hpp>\n'),
    ("server/main.cpp", '#include "cli/command_line.h"\n'),
]


def lint(path, text):
    with tempfile.TemporaryDirectory() as folder:
        for name in ("compiler/CMakeLists.txt", "server/CMakeLists.txt", path):
            target = pathlib.Path(folder) / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text if name == path else (ROOT / name).read_text())
        done = subprocess.run([sys.executable, HERE / "lint.py"], input=path, cwd=folder, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr


def main():
    faults = []
    for path, text, expected in CASES:
        status, output = lint(path, text)
        if status != 1 or expected not in output:
            faults.append(f"{path}: expected {expected!r}, got {status}: {output}")
    for path, text in CLEAN:
        status, output = lint(path, text)
        if status != 0:
            faults.append(f"{path}: expected nothing, got {output}")
    print("\n".join(faults) or "lint.py finds what it is for")
    return 1 if faults else 0


sys.exit(main())
