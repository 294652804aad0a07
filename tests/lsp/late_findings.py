"""Diagnostics that take long to compute come behind those that do not: late_findings.py PROGRAM

An edit of what an integral needs is published at once, without the hint about the integral (E4044) and without the comparison of a
chain (E4009), and then once more with both. An edit of anything else has them in its first publication.
"""

import sys

from soak import Server

URI = "file:///late.tex"
TEXT = r"""\begin{equation}
  m = 0.3
\end{equation}
\begin{equation}
  unused = 0.5
\end{equation}
\begin{equation}
  f = \int_0^1 \sqrt{|x - m|}\,dx = m
\end{equation}
"""
LATE = {"E4009", "E4044"}


class Client:
    def __init__(self, program):
        self.server, self.version = Server(program), 1
        self.server.ask("initialize", {"processId": None, "rootUri": None, "capabilities": {}})
        self.server.send("initialized", {})
        self.server.send("textDocument/didOpen",
                         {"textDocument": {"uri": URI, "languageId": "latex", "version": 1, "text": TEXT}})

    def edit(self, line, digit):
        self.version += 1
        start = {"line": line, "character": TEXT.splitlines()[line].index(".") + 1}
        end = {"line": line, "character": start["character"] + 1}
        self.server.send("textDocument/didChange",
                         {"textDocument": {"uri": URI, "version": self.version},
                          "contentChanges": [{"range": {"start": start, "end": end}, "text": digit}]})

    def next_publication(self):
        while True:
            message = self.server.read()
            if message.get("method") == "textDocument/publishDiagnostics":
                params = message["params"]
                return params["version"], LATE & {diagnostic["code"] for diagnostic in params["diagnostics"]}

    def expect(self, what, *publications):
        for late in publications:
            version, codes = self.next_publication()
            if (version, codes) != (self.version, late):
                sys.exit(f"{what}: published {codes} for version {version}, expected {late} for {self.version}")
        if self.server.is_pending(URI):
            sys.exit(f"{what}: more is to come")


def main():
    client = Client(sys.argv[1])
    client.expect("opened", set(), LATE)
    client.edit(4, "6")
    client.expect("an edit elsewhere", LATE)
    client.edit(1, "4")
    client.expect("an edit of what the integral needs", set(), LATE)
    client.edit(1, "3")
    client.edit(1, "7")
    version, codes = client.next_publication()
    while codes != LATE or version != client.version:
        version, codes = client.next_publication()
    client.edit(1, "4")
    client.server.ask("shutdown", None)
    client.server.send("exit", None)
    client.server.process.stdin.close()
    if client.server.process.wait(10) != 0:
        sys.exit("the server did not end while something was being computed")


if __name__ == "__main__":
    main()
