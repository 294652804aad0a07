"""Random edits for as long as a person would write in years: soak.py PROGRAM [EDITS [SEED]]

Edits a document over the protocol in bursts, asks about random places in between, and compares a hundred times what the server
published with what it publishes for a new document of the same text. Fails when that differs, when an answer is an error, or
when the process grows from the first tenth to the end.
"""

import json
import pathlib
import random
import subprocess
import sys

URI, FRESH = "file:///soak.tex", "file:///fresh.tex"
BLOCKS = 80
LONGEST = 1000  # lines
GROWTH = 1.1  # of the memory after the first tenth, and
SLACK = 4 << 20  # bytes

PIECES = ["%", "{", "}", "(", ")", "$", "\\begin{equation}", "\\end{equation}", "\\begin{equation}\n", "\n\\end{equation}\n", " * ",
          " + ", "\\frac{1}{2}", "\\vec{1, 2, 3}", "\\rho_d", "\\theta_h", "\\cos\\theta_i", "x", "1.5", "\n", "\\", "=", "_", "^2", "é",
          "% range [0, 1]", "\\vec{n}", "\\sqrt[3]{", "f"]

# Capability -> request, and what it takes besides document and position.
QUESTIONS = {
    "hoverProvider": ("textDocument/hover", {}),
    "definitionProvider": ("textDocument/definition", {}),
    "referencesProvider": ("textDocument/references", {"context": {"includeDeclaration": True}}),
    "documentHighlightProvider": ("textDocument/documentHighlight", {}),
    "documentSymbolProvider": ("textDocument/documentSymbol", {}),
    "completionProvider": ("textDocument/completion", {}),
    "signatureHelpProvider": ("textDocument/signatureHelp", {}),
    "semanticTokensProvider": ("textDocument/semanticTokens/full", {}),
    "foldingRangeProvider": ("textDocument/foldingRange", {}),
    "codeLensProvider": ("textDocument/codeLens", {}),
}


class Server:
    def __init__(self, program):
        self.process = subprocess.Popen([program, "lsp", "--log-level", "error"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.requests = 0
        self.diagnostics = {}  # by URI: version, list

    def send(self, method, params):
        self.write({"jsonrpc": "2.0", "method": method, "params": params})

    def write(self, message):
        body = json.dumps(message).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))

    def read(self):
        self.process.stdin.flush()
        length = 0
        while (line := self.process.stdout.readline().strip()):
            name, _, value = line.partition(b":")
            if name == b"Content-Length":
                length = int(value)
        if not length:
            sys.exit("the server ended")
        message = json.loads(self.process.stdout.read(length))
        if message.get("method") == "textDocument/publishDiagnostics":
            params = message["params"]
            self.diagnostics[params["uri"]] = (params.get("version"), params["diagnostics"])
        elif "method" in message and "id" in message:
            self.write({"jsonrpc": "2.0", "id": message["id"], "result": None})
        return message

    def ask(self, method, params):
        self.requests += 1
        self.write({"jsonrpc": "2.0", "id": self.requests, "method": method, "params": params})
        while (answer := self.read()).get("id") != self.requests or "method" in answer:
            pass
        if "error" in answer:
            sys.exit(f"{method} {params}: {answer['error']}")
        return answer["result"]

    def published(self, uri, version):
        while self.diagnostics.get(uri, (None,))[0] != version:
            self.read()
        while version is not None and self.is_pending(uri):
            pass
        return self.diagnostics[uri][1]

    def is_pending(self, uri):
        """What was published may not be the last word on its version."""
        documents = self.ask("texbrdf/stats", {})["documents"]
        return any(document["uri"] == uri and document["diagnosticsPending"] for document in documents)

    def memory(self):
        status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text(encoding="ascii")
        return next(int(line.split()[1]) << 10 for line in status.splitlines() if line.startswith("VmRSS:"))


class Text:
    """What the client has: lines, and edits as the protocol has them. All characters take one UTF-16 unit."""

    def __init__(self, text):
        self.lines = text.split("\n")

    def __str__(self):
        return "\n".join(self.lines)

    def replace(self, start, end, text):
        """Returns the edit that takes this one back."""
        (first, column), (last, end_column) = start, end
        old = self.lines[first:last + 1]
        head, tail = old[0][:column], old[-1][end_column:]
        old[-1] = old[-1][:end_column]
        old[0] = old[0][column:]
        new = (head + text + tail).split("\n")
        self.lines[first:last + 1] = new
        return start, (first + len(new) - 1, len(new[-1]) - len(tail)), "\n".join(old)


class Writer:
    """Somebody who edits at random, and takes back about as much as they write."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.names = 0
        self.undo = []
        self.original = "% texbrdf: root = f\n" + "\n".join(self.block(i) for i in range(BLOCKS)) + self.equation("f", "a_{0} * \\cos\\theta_h")
        self.text = Text(self.original)

    @staticmethod
    def equation(left, right):
        return f"\\begin{{equation}}\n  {left} = {right}\n\\end{{equation}}\n"

    def block(self, i):
        return self.equation(f"a_{{{i}}}", f"{i}.5 * \\cos\\theta_i" + (f" + a_{{{i + 1}}}" if i + 1 < BLOCKS else ""))

    def place(self):
        line = self.random.randrange(len(self.text.lines))
        return line, self.random.randint(0, len(self.text.lines[line]))

    def edit(self):
        """The next change, already made in self.text: (start, end, text)."""
        kind = self.random.random()
        start = self.place()
        line, column = start
        if kind < 0.4 and self.undo:
            change = self.undo.pop()
            self.text.replace(*change)
            return change
        if kind < 0.6:
            change = (start, start, self.random.choice(PIECES))
        elif kind < 0.75:
            change = (start, (line, min(column + self.random.randint(1, 8), len(self.text.lines[line]))), "")
        elif kind < 0.8:
            last = min(line + self.random.randint(1, 6), len(self.text.lines) - 1)
            change = ((line, 0), (last, 0), "")
        elif kind < 0.9:
            self.names += 1
            change = ((line, 0), (line, 0), self.equation(f"n_{{{self.names}}}", "2 * a_{3}"))
        else:
            change = (start, (line, min(column + 1, len(self.text.lines[line]))), str(self.random.randrange(10)))
        self.undo.append(self.text.replace(*change))
        return change

    def start_again(self):
        self.undo.clear()
        self.text = Text(self.original)


def change_event(change):
    (line, column), (last, end), text = change
    return {"range": {"start": {"line": line, "character": column}, "end": {"line": last, "character": end}}, "text": text}


class Soak:
    def __init__(self, program, seed):
        self.server = Server(program)
        self.writer = Writer(seed)
        self.version = 1
        capabilities = self.server.ask("initialize", {"processId": None, "rootUri": None, "capabilities": {}})["capabilities"]
        self.questions = [question for capability, question in QUESTIONS.items() if capabilities.get(capability)]
        self.server.send("initialized", {})
        self.open(URI, self.version)

    def open(self, uri, version):
        document = {"uri": uri, "languageId": "latex", "version": version, "text": str(self.writer.text)}
        self.server.send("textDocument/didOpen", {"textDocument": document})

    def change(self, *changes):
        self.version += 1
        self.server.send("textDocument/didChange", {"textDocument": {"uri": URI, "version": self.version}, "contentChanges": changes})

    def burst(self, edits):
        for _ in range(edits):
            self.change(change_event(self.writer.edit()))
        if len(self.writer.text.lines) > LONGEST or self.writer.random.random() < 0.001:
            self.writer.start_again()
            self.change({"text": self.writer.original})
        if self.writer.random.random() < 0.2:
            self.ask_something()
        self.server.published(URI, self.version)

    def ask_something(self):
        method, more = self.writer.random.choice(self.questions)
        line, column = self.writer.place()
        self.server.ask(method, {"textDocument": {"uri": URI}, "position": {"line": line, "character": column}, **more})

    def compare_with_fresh(self):
        """A new document of the same text gets the same diagnostics."""
        self.open(FRESH, self.version)
        expected = self.server.published(FRESH, self.version)
        self.server.send("textDocument/didClose", {"textDocument": {"uri": FRESH}})
        self.server.published(FRESH, None)
        actual = self.server.published(URI, self.version)
        if json.dumps(actual).replace(URI, FRESH) != json.dumps(expected):
            pathlib.Path("soak-failure.tex").write_text(str(self.writer.text), encoding="utf-8")
            sys.exit(f"version {self.version} has other diagnostics than its text (soak-failure.tex)")


def main():
    program, edits, seed = sys.argv[1], int((sys.argv[2:] or ["1000000"])[0]), int((sys.argv[3:] or ["1"])[0])
    print(f"{edits} edits, seed {seed}")
    soak = Soak(program, seed)
    memory = []
    for hundredth in range(1, 101):
        while soak.version < edits * hundredth / 100:
            soak.burst(soak.writer.random.randint(1, 20))
        soak.compare_with_fresh()
        if hundredth % 10 != 0:
            continue
        memory.append(soak.server.memory())
        print(f"{soak.version} edits, {len(soak.writer.text.lines)} lines, {len(soak.server.diagnostics[URI][1])} diagnostics, "
              f"{memory[-1] / 1e6:.1f} MB", flush=True)
    soak.server.ask("shutdown", None)
    soak.server.send("exit", None)
    soak.server.process.stdin.close()
    if soak.server.process.wait(60) != 0:
        sys.exit(f"exit status {soak.server.process.returncode}")
    if memory[-1] > memory[0] * GROWTH + SLACK:
        sys.exit(f"grew from {memory[0] / 1e6:.1f} to {memory[-1] / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
