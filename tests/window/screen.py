"""A virtual screen without a window manager, what a person does at it, and what is seen there."""

import os
import struct
import subprocess
import zlib


class Screen:
    """Xvfb on a display of its own."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            number = answer.readline().strip()
        assert number, "Xvfb did not start"
        self.environment = {**os.environ, "DISPLAY": f":{number}"}
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

    def do(self, *words):
        """xdotool's words; what it prints."""
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True, capture_output=True,
                              text=True).stdout.strip()

    def find_windows(self):
        """Ids of windows with a name, which is all that a program opens here."""
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "."], env=self.environment,
                               capture_output=True, text=True).stdout
        return found.split()

    def picture(self, window):
        """Width, height and (r, g, b) of each pixel, row by row."""
        dump = subprocess.run(["xwd", "-silent", "-id", window], env=self.environment, check=True,
                              capture_output=True).stdout
        return read_xwd(dump)


def read_xwd(dump):
    """X Window Dump, version 7, with true colours of 8 bits."""
    header = struct.unpack(">25I", dump[:100])
    (header_size, version, _, _, width, height, _, byte_order, _, _, _, bits, stride) = header[:13]
    assert version == 7 and bits in (24, 32), header
    colours = header[19]
    begin = header_size + 12 * colours
    size = bits // 8
    order = (2, 1, 0) if byte_order == 0 else (size - 3, size - 2, size - 1)
    pixels = []
    for y in range(height):
        row = dump[begin + y * stride:begin + (y + 1) * stride]
        pixels += [tuple(row[x * size + channel] for channel in order) for x in range(width)]
    return width, height, pixels


def write_png(path, width, height, pixels):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + bytes(value for pixel in pixels[y * width:(y + 1) * width] for value in pixel)
                    for y in range(height))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
