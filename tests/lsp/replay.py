"""Edits as an editor sends them, each publication held against a fresh compile of that version: replay.py PROGRAM [SEED]

A paper of equations is edited as somebody writes: a number changes, a letter comes and goes, a name is misspelled and mended, an
equation is added and taken away, some edits in one write. What the server publishes for each version must be what it publishes
for a new document of the same text.
"""

import random
import re
import sys

from soak import Server

URI = "file:///paper.tex"
BLOCKS = 120
EDITS = 300


def paper(chained):
    text = "\\documentclass{article}\n\\begin{document}\n\n\\begin{equation}\n  \\rho_d = 0.5\n\\end{equation}\n"
    for i in range(1, BLOCKS + 1):
        operand = f"a_{{{i - 1}}}" if chained and i > 1 else "\\theta_h"
        text += f"\nTerm number {i} of the model.\n\\begin{{equation}}\n  a_{{{i}}} = \\frac{{\\rho_d}}{{\\pi}} * {operand} + 0.25\n\\end{{equation}}\n"
    return text + f"\n\\begin{{equation}}\n  f = a_{{{BLOCKS}}} * 1.25\n\\end{{equation}}\n\\end{{document}}\n"


class Editor:
    """Applies edits to its own copy of the text and tells the server."""

    def __init__(self, server, text):
        self.server, self.text, self.version = server, text, 1
        self.versions = {1: text}
        server.send("textDocument/didOpen", {"textDocument": {"uri": URI, "languageId": "latex", "version": 1, "text": text}})

    def position(self, offset):
        line = self.text.count("\n", 0, offset)
        return {"line": line, "character": offset - self.text.rfind("\n", 0, offset) - 1}

    def replace(self, begin, end, by):
        change = {"range": {"start": self.position(begin), "end": self.position(end)}, "text": by}
        before = self.text[begin:end]
        self.text = self.text[:begin] + by + self.text[end:]
        self.version += 1
        self.versions[self.version] = self.text
        self.server.send("textDocument/didChange", {"textDocument": {"uri": URI, "version": self.version}, "contentChanges": [change]})
        return begin, begin + len(by), before  # takes it back


def place(random_, text, pattern):
    return random_.choice(list(re.finditer(pattern, text))).span()


def one_edit(editor, random_):
    """The inverse of the edit, or nothing where it is to stay."""
    kind = random_.randrange(5)
    if kind == 0:
        editor.replace(*place(random_, editor.text, r"\d\.\d+"), f"{random_.randrange(9)}.{random_.randrange(1, 99)}")
        return None
    if kind == 1:
        at = place(random_, editor.text, r" \* ")[0]
        return editor.replace(at, at, random_.choice("x(}%$\\^"))
    if kind == 2:
        return editor.replace(*place(random_, editor.text, r"\\rho_d|\\theta_h"), "zq_{900}")
    if kind == 3:
        at = place(random_, editor.text, r"\nTerm")[0]
        name = random_.choice(["b", "f", "a_{3}", "\\theta_o"])
        return editor.replace(at, at, f"\n\\begin{{equation}}\n  {name} = \\rho_d + 1\n\\end{{equation}}\n")
    begin, end = place(random_, editor.text, r"\\end\{equation\}\n")
    return editor.replace(begin, end, "")


def compare(server, editor, problems):
    version, published = server.diagnostics[URI]
    if version in editor.versions:
        fresh = f"file:///fresh{version}.tex"
        server.send("textDocument/didOpen",
                    {"textDocument": {"uri": fresh, "languageId": "latex", "version": 1, "text": editor.versions[version]}})
        server.published(fresh, 1)
        expected = server.diagnostics[fresh][1]
        server.send("textDocument/didClose", {"textDocument": {"uri": fresh}})
        if expected != published:
            problems.append(f"version {version}: published {published}, expected {expected}")


def replay(program, chained, seed):
    random_ = random.Random(seed)
    server = Server(program)
    server.ask("initialize", {"processId": None, "rootUri": None, "capabilities": {"textDocument": {"publishDiagnostics": {}}}})
    server.send("initialized", {})
    editor, problems, inverses = Editor(server, paper(chained)), [], []
    publications = 0
    for _ in range(EDITS):
        for _ in range(random_.choice([1, 1, 1, 5])):  # sometimes a burst
            if inverses and random_.random() < 0.6:
                editor.replace(*inverses.pop())
            elif (inverse := one_edit(editor, random_)) is not None:
                inverses.append(inverse)
        server.published(URI, editor.version)
        compare(server, editor, problems)
        publications += 1
    server.ask("shutdown", None)
    server.send("exit", None)
    server.process.stdin.close()
    print(f"{'chained' if chained else 'not chained'}: {editor.version} versions, {publications} publications compared, {len(problems)} wrong")
    return problems


def main():
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else random.randrange(1 << 30)
    print(f"seed {seed}")
    problems = replay(sys.argv[1], True, seed) + replay(sys.argv[1], False, seed + 1)
    if problems:
        sys.exit("\n".join(problems[:5]))


if __name__ == "__main__":
    main()
