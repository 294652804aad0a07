"""The program may need only what a default Debian 12 or Ubuntu 22.04 has."""

import re
import subprocess
import sys

LIBRARIES = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1", "ld-linux-x86-64.so.2"}
NEWEST = {"GLIBC": (2, 35), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13)}


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main(program):
    faults = []
    needed = set(re.findall(r"\(NEEDED\).*\[(.+)\]", output("readelf", "-d", program)))
    if not needed:
        faults.append("no library is needed at all: is this the program?")
    faults += [f"needs {library}" for library in sorted(needed - LIBRARIES)]
    versions = set(re.findall(r"\((GLIBC|GLIBCXX|CXXABI)_([0-9.]+)\)", output("objdump", "-T", program)))
    if not versions:
        faults.append("objdump shows no versioned symbol")
    for name, version in sorted(versions):
        if tuple(map(int, version.split("."))) > NEWEST[name]:
            faults.append(f"needs {name}_{version}")
    print("\n".join(faults) or f"needs {', '.join(sorted(needed))} only")
    return 1 if faults else 0


sys.exit(main(sys.argv[1]))
