#!/usr/bin/env python3
"""Counts the instructions of one edit with callgrind: instructions_per_edit.py BENCH_EDITS [BLOCKS …]

Two runs of BENCH_EDITS that differ only in the number of edits are subtracted, so that opening the document does not
count. The same binary gives the same figures however busy the machine is.
"""
import re
import subprocess
import sys
import tempfile

FEW, MANY = 10, 110


def instructions(program, blocks, edits):
    with tempfile.NamedTemporaryFile() as out:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}", program, str(blocks), str(edits)],
            capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", run.stderr).group(1))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = sys.argv[1]
    sizes = [int(size) for size in sys.argv[2:]] or [100, 1000, 10000]
    first = None
    for blocks in sizes:
        count = (instructions(program, blocks, MANY) - instructions(program, blocks, FEW)) / (MANY - FEW)
        first = first or count
        print(f"{blocks} blocks: {count:.0f} instructions an edit, {count / first:.2f} times those of {sizes[0]} blocks")


if __name__ == "__main__":
    main()
