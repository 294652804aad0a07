"""Runs the command-line cases of one TOML file: run.py PROGRAM DATA CASES.toml

Each [[case]] runs in an empty folder of its own and has
  name             what it shows
  args             the arguments; {data} is tests/data
  files            table of files that stand there before
  stdin            what the program reads from standard input
  read_only        files or folders that may not be written (skipped for root, who may write all)
  environment      variables set besides those of the caller
  closed_stdout    standard output is a pipe that nobody reads
  full_stdout      standard output is a device without space
and expects
  exit             the exit status (0); -13 is the signal SIGPIPE
  stdout, stderr   the exact text; or
  stdout_has, stderr_has, stdout_lacks, stderr_lacks   texts that are in it, or are not
  stdout_lines     how many lines
  written          table: file -> texts that it holds
  absent           files that must not be there afterwards
  checks           names of functions of output_checks.py, which look into JSON, CSV, PNG and XML
  checked_file     what they look into: a file, otherwise standard output
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib

import output_checks

KEYS = {"name", "args", "files", "stdin", "read_only", "environment", "closed_stdout", "full_stdout", "exit", "stdout",
        "stderr", "stdout_has", "stderr_has", "stdout_lacks", "stderr_lacks", "stdout_lines", "written", "absent",
        "checks", "checked_file"}


def run(program, data, case, folder):
    for name, text in case.get("files", {}).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    for name in case.get("read_only", []):
        (folder / name).chmod(0o555)
    environment = os.environ | case.get("environment", {})
    arguments = [program] + [argument.replace("{data}", data) for argument in case["args"]]
    common = {"cwd": folder, "env": environment, "stderr": subprocess.PIPE, "timeout": 120}
    stdin = case.get("stdin", "").encode()
    if case.get("closed_stdout"):
        read_end, write_end = os.pipe()
        os.close(read_end)
        try:
            done = subprocess.run(arguments, input=stdin, stdout=write_end, **common)
        finally:
            os.close(write_end)
        return done.returncode, b"", done.stderr
    if case.get("full_stdout"):
        with open("/dev/full", "wb") as full:
            done = subprocess.run(arguments, input=stdin, stdout=full, **common)
        return done.returncode, b"", done.stderr
    done = subprocess.run(arguments, input=stdin, stdout=subprocess.PIPE, **common)
    return done.returncode, done.stdout, done.stderr


def stream_faults(case, name, text):
    if name in case and text != case[name]:
        yield f"{name} is not as expected"
    for part in case.get(f"{name}_has", []):
        if part not in text:
            yield f"{name} lacks {part!r}"
    for part in case.get(f"{name}_lacks", []):
        if part in text:
            yield f"{name} has {part!r}"
    lines = case.get(f"{name}_lines")
    if lines is not None and text.count("\n") != lines:
        yield f"{name} has {text.count(chr(10))} lines, not {lines}"


def faults(case, folder, status, stdout, stderr):
    if status != case.get("exit", 0):
        yield f"exit status {status}, not {case.get('exit', 0)}"
    yield from stream_faults(case, "stdout", stdout.decode(errors="replace"))
    yield from stream_faults(case, "stderr", stderr.decode(errors="replace"))
    for name, parts in case.get("written", {}).items():
        path = folder / name
        text = path.read_text(errors="replace") if path.is_file() else None
        if text is None:
            yield f"{name} was not written"
        else:
            yield from (f"{name} lacks {part!r}" for part in parts if part not in text)
    for name in case.get("absent", []):
        if (folder / name).exists():
            yield f"{name} is there"
    checked = (folder / case["checked_file"]).read_bytes() if "checked_file" in case else stdout
    for check in case.get("checks", []):
        try:
            getattr(output_checks, check)(checked)
        except (AssertionError, KeyError, ValueError, IndexError) as error:
            yield f"{check}: {type(error).__name__} {error}"


def run_case(program, data, case):
    unknown = set(case) - KEYS
    if unknown:
        return [f"unknown keys: {', '.join(sorted(unknown))}"]
    if case.get("read_only") and os.geteuid() == 0:
        print(f"skipped for root: {case['name']}")
        return []
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        status, stdout, stderr = run(program, data, case, path)
        found = list(faults(case, path, status, stdout, stderr))
        for name in case.get("read_only", []):
            (path / name).chmod(0o755)
    if found:
        found += ["--- stdout", stdout.decode(errors="replace")[:2000], "--- stderr", stderr.decode(errors="replace")[:2000]]
    return found


def main(program, data, cases_file):
    with open(cases_file, "rb") as file:
        cases = tomllib.load(file)["case"]
    failed = 0
    for case in cases:
        found = run_case(os.path.abspath(program), os.path.abspath(data), case)
        if found:
            failed += 1
            print(f"FAILED: {case['name']}\n  " + "\n  ".join(found))
    print(f"{len(cases) - failed} of {len(cases)} cases passed")
    return 1 if failed else 0


sys.exit(main(*sys.argv[1:]))
