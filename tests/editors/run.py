"""Runs one editor's session against the program: run.py (neovim | emacs) EDITOR PROGRAM

The editor has the configuration that docs/editors.md tells people to copy, and edits a copy of document.tex. What it does is
in neovim.lua and emacs.el; both end with status 0 when all was as expected.
"""

import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parent.parent / "docs" / "editors.md"
DEADLINE = 200  # seconds, for a busy machine and a server under a sanitizer; a run takes less than two

CONFIGURATION = {"neovim": "init.lua", "emacs": "init.el"}
ARGUMENTS = {
    "neovim": ["--headless", "-n", "-i", "NONE", "-u", "init.lua", "document.tex", "-c", f"luafile {HERE}/neovim.lua"],
    "emacs": ["--batch", "--load", str(HERE / "emacs.el")],
}


def configuration(name):
    """The code block of the page that stands below the comment with this name."""
    block = re.search(rf"<!-- run by tests/editors: {name} -->\s*```\w+\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    if not block:
        sys.exit(f"{PAGE} has no configuration for {name}")
    return block.group(1)


def main():
    name, editor, program = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="texbrdf-editor-", ignore_cleanup_errors=True) as folder:
        home = pathlib.Path(folder)
        (home / "document.tex").write_bytes((HERE / "document.tex").read_bytes())
        (home / CONFIGURATION[name]).write_text(configuration(name), encoding="utf-8")
        environment = {variable: value for variable, value in os.environ.items() if not variable.startswith("XDG_")}
        environment |= {"HOME": folder, "LC_ALL": "C.UTF-8", "PATH": f"{pathlib.Path(program).parent}:{os.environ['PATH']}"}
        session = subprocess.Popen([editor, *ARGUMENTS[name]], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                   start_new_session=True)
        try:
            return session.wait(DEADLINE)
        except subprocess.TimeoutExpired:
            os.killpg(session.pid, signal.SIGKILL)
            print(f"{name} did not end within {DEADLINE} s")
            return 1


sys.exit(main())
