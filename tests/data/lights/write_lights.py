"""Writes the .hdr files beside it, which the reader of the program never saw being written: write_lights.py

Each good one holds the same 16 by 8 picture: texel (column, row) has red = column + 1, green = row / 8, blue = 1/4, all
times 4 in the lower half. The first header line of a broken one tells what is to be said of it.
"""

import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
WIDTH, HEIGHT = 16, 8


def rgbe(colour):
    largest = max(colour)
    if largest <= 0:
        return bytes(4)
    exponent = math.frexp(largest)[1]
    return bytes(int(c * 256 / 2**exponent) for c in colour) + bytes([exponent + 128])


def texel(column, row):
    factor = 4 if row >= HEIGHT // 2 else 1
    return rgbe([factor * (column + 1), factor * row / 8, factor / 4])


ROWS = [[texel(column, row) for column in range(WIDTH)] for row in range(HEIGHT)]


def head(*variables, size="-Y 8 +X 16", magic="#?RADIANCE"):
    return "\n".join([magic, *variables, "FORMAT=32-bit_rle_rgbe", "", size, ""]).encode()


def plain(rows):
    return b"".join(b"".join(row) for row in rows)


def new_runs(row):
    data = bytes([2, 2, len(row) >> 8, len(row) & 255])
    for channel in range(4):
        values = [texel[channel] for texel in row]
        at = 0
        while at < len(values):
            run = 1
            while at + run < len(values) and values[at + run] == values[at] and run < 127:
                run += 1
            if run > 2:
                data += bytes([128 + run, values[at]])
                at += run
            else:
                part = values[at:at + 5]
                data += bytes([len(part), *part])
                at += len(part)
    return data


def old_runs(row):
    data, at = b"", 0
    while at < len(row):
        run = 1
        while at + run < len(row) and row[at + run] == row[at]:
            run += 1
        data += row[at] + (bytes([1, 1, 1, run - 1]) if run > 1 else b"")
        at += run
    return data


def write(name, data):
    (HERE / name).write_bytes(data)


def broken(name, expect, data):
    write(f"broken/{name}.hdr", data.replace(b"#?RADIANCE\n", f"#?RADIANCE\n# expect: {expect}\n".encode(), 1))


def write_good():
    encoded = b"".join(map(new_runs, ROWS))
    write("plain.hdr", head() + plain(ROWS))
    write("new-runs.hdr", head("SOFTWARE=some", magic="#?RGBE") + encoded)
    write("from-bottom.hdr", head(size="+Y 8 +X 16") + plain(ROWS[::-1]))
    write("from-right.hdr", head(size="-Y 8 -X 16") + plain([row[::-1] for row in ROWS]))
    # Four times as bright, which two exposures tell.
    write("exposed.hdr", head("EXPOSURE=2", "EXPOSURE= 2.0") + plain([[t[:3] + bytes([t[3] + 2]) for t in r] for r in ROWS]))
    write("corrected.hdr", head("COLORCORR=1 2 1") + plain([[bytes([t[0], t[1] * 2, *t[2:]]) for t in r] for r in ROWS]))
    stripes = [[rgbe([row + 1, 0.5, 0])] * 600 for row in range(300)]
    # 599 is more than a byte: two runs, the second of which counts 256 times.
    long_run = b"".join(row[0] + bytes([1, 1, 1, 599 & 255, 1, 1, 1, 599 >> 8]) for row in stripes)
    write("old-runs.hdr", head(size="-Y 300 +X 600") + long_run)
    write("old-runs-short.hdr", head(size="-Y 2 +X 4") + b"".join(old_runs([rgbe([1, 1, 1])] * 3 + [rgbe([8, 8, 8])]) for _ in range(2)))


def write_broken():
    good = head() + plain(ROWS)
    encoded = [new_runs(row) for row in ROWS]
    broken("ends-in-a-row", "row 8 of 8: the file ends in it", good[:-1])
    broken("ends-in-a-run", "row 8 of 8: the file ends in it", head() + b"".join(encoded)[:-1])
    broken("ends-behind-its-size", "row 1 of 8: the file ends in it", head())
    broken("ends-in-its-header", "it ends in its header", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n")
    broken("ends-before-its-size", "it ends before its size", b"#?RADIANCE\n\n")
    broken("other-format", "its format is '32-bit_rle_xyze'", good.replace(b"rgbe", b"xyze", 1))
    broken("no-size", "'-Y 8 +X' is no size", head(size="-Y 8 +X"))
    broken("size-of-nothing", "'-Y 0 +X 0' is no size", head(size="-Y 0 +X 0"))
    broken("negative-size", "'-Y -8 +X 16' is no size", head(size="-Y -8 +X 16"))
    broken("columns-first", "does not give rows (Y) of columns (X)", head(size="+X 16 -Y 8"))
    broken("a-square", "it is 8 by 8; a picture of all directions is twice as wide as high", head(size="-Y 8 +X 8"))
    broken("too-large", "it is 2000000 by 1000000, which is too large", head(size="-Y 1000000 +X 2000000"))
    broken("other-width", "row 1 of 8: it is encoded for 15 columns", head() + bytes([2, 2, 0, 15]) + encoded[0][4:])
    broken("run-too-long", "row 1 of 8: a run is longer than what is left of it", head() + bytes([2, 2, 0, 16, 128 + 17, 1]))
    broken("literals-too-long", "row 1 of 8: a run is longer", head() + bytes([2, 2, 0, 16, 17]) + bytes(17))
    broken("run-of-nothing", "row 1 of 8: a run of nothing", head() + bytes([2, 2, 0, 16, 0, 1]))
    broken("begins-with-an-old-run", "row 1 of 8: it begins with a run", head() + bytes([1, 1, 1, 3]) + plain(ROWS))
    broken("old-run-too-long", "row 1 of 8: a run is longer", head() + ROWS[0][0] + bytes([1, 1, 1, 16]) + plain(ROWS))
    broken("endless-old-runs", "row 1 of 8: a run is longer", head() + ROWS[0][0] + bytes([1, 1, 1, 0]) * 40)
    broken("no-exposure", "'EXPOSURE=bright' is no exposure", head("EXPOSURE=bright") + plain(ROWS))
    broken("exposure-of-nothing", "'EXPOSURE=0' is no exposure", head("EXPOSURE=0") + plain(ROWS))
    broken("exposures-together", "its exposures together", head(*["EXPOSURE=1e-20"] * 3) + plain(ROWS))
    broken("two-corrections", "'COLORCORR=1 2' is no correction", head("COLORCORR=1 2") + plain(ROWS))
    broken("too-strong", "too strong for a number", head("EXPOSURE=1e-20") + plain([[bytes([9, 9, 9, 255])] * 16] * 8))
    broken("black", "it is black", head() + bytes(4 * WIDTH * HEIGHT))


write_good()
write_broken()
