"""What the cases ask of JSON, CSV, PNG and XML that the program writes. Each check takes bytes and raises if they fail."""

import csv
import io
import json
import math
import struct
import xml.etree.ElementTree
import zlib


def _check_range(range_):
    assert set(range_) == {"start", "end"}, range_
    for place in range_.values():
        assert set(place) == {"line", "column"} and min(place.values()) >= 1, place
    start, end = (range_[end]["line"] for end in ("start", "end"))
    assert (start, range_["start"]["column"]) <= (end, range_["end"]["column"]), range_


def diagnostics_list(data):
    """The documented shape of `check --format json`."""
    for entry in json.loads(data):
        assert list(entry) == ["file", "code", "severity", "message", "range", "related", "fixes"], list(entry)
        assert entry["severity"] in ("error", "warning", "information", "hint")
        assert entry["code"][0] == "E" and len(entry["code"]) == 5 and entry["code"][1:].isdigit(), entry["code"]
        assert entry["message"]
        _check_range(entry["range"])
        for related in entry["related"]:
            assert set(related) == {"file", "message", "range"}
            _check_range(related["range"])
        for fix in entry["fixes"]:
            assert set(fix) == {"title", "edits"} and fix["edits"]
            for edit in fix["edits"]:
                assert set(edit) == {"range", "replacement"}
                _check_range(edit["range"])


def not_empty_list(data):
    assert json.loads(data)


def empty_list(data):
    assert json.loads(data) == []


def columns_count_code_points(data):
    """The case has `f = ` and an undefined name after letters that take two, three and four bytes."""
    (entry,) = json.loads(data)
    assert entry["range"] == {"start": {"line": 1, "column": 34}, "end": {"line": 1, "column": 39}}, entry["range"]


def place_is_1_1(data):
    (entry,) = json.loads(data)
    assert entry["range"]["start"] == {"line": 1, "column": 1}, entry


def sarif_log(data):
    """The parts of SARIF 2.1.0 that its schema requires, and that readers of it use."""
    log = json.loads(data)
    assert log["version"] == "2.1.0" and "sarif-2.1.0" in log["$schema"]
    (run,) = log["runs"]
    driver = run["tool"]["driver"]
    assert driver["name"] == "texbrdf" and driver["version"]
    rules = [rule["id"] for rule in driver["rules"]]
    assert len(set(rules)) == len(rules) and rules
    for rule in driver["rules"]:
        assert rule["shortDescription"]["text"] and rule["fullDescription"]["text"]
        assert rule["defaultConfiguration"]["level"] in ("none", "note", "warning", "error")
    assert run["columnKind"] == "unicodeCodePoints"
    for result in run["results"]:
        assert result["ruleId"] in rules and result["message"]["text"]
        assert result["level"] in ("note", "warning", "error")
        for location in result["locations"] + result.get("relatedLocations", []):
            place = location["physicalLocation"]
            assert place["artifactLocation"]["uri"] and " " not in place["artifactLocation"]["uri"]
            region = place["region"]
            assert min(region.values()) >= 1 and set(region) == {"startLine", "startColumn", "endLine", "endColumn"}
        for fix in result.get("fixes", []):
            assert fix["description"]["text"] and fix["artifactChanges"][0]["replacements"]


def sarif_has_results(data):
    assert json.loads(data)["runs"][0]["results"]


def tree_list(data):
    def check(node):
        assert list(node) == ["kind", "range", "text", "type", "children"], list(node)
        _check_range(node["range"])
        for child in node["children"]:
            check(child)

    definitions = json.loads(data)
    assert definitions
    for definition in definitions:
        assert definition["name"] and definition["tree"]["kind"] == "Definition"
        check(definition["tree"])


def svg(data):
    root = xml.etree.ElementTree.fromstring(data)
    assert root.tag == "{http://www.w3.org/2000/svg}svg", root.tag


def _png_size(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height, depth, colour_type = struct.unpack(">IIBB", data[16:26])
    assert depth == 8 and colour_type in (2, 6)
    return width, height, colour_type


def png_256(data):
    assert _png_size(data)[:2] == (256, 256)


def png_64(data):
    assert _png_size(data)[:2] == (64, 64)


def png_80_by_40(data):
    assert _png_size(data)[:2] == (80, 40)


def png_300(data):
    assert _png_size(data)[:2] == (300, 300)


def png_shows_a_sphere(data):
    """Or another object: transparent in the corner, opaque in the middle, with more than a few colours."""
    assert _png_size(data)[2] == 6
    width, height, pixels = png_pixels(data)
    assert pixels[0][3] == 0, "the corner is transparent"
    assert pixels[(height // 2) * width + width // 2][3] == 255, "the middle is opaque"
    assert len(set(pixels)) > 50


def png_has_one_colour(data):
    """Wherever something is: (51, 102, 153)."""
    assert {pixel[:3] for pixel in png_pixels(data)[2] if pixel[3] > 0} == {(51, 102, 153)}


def png_pixels(data):
    """Width, height and (r, g, b) or (r, g, b, a) of each pixel, row by row."""
    width, height, colour_type = _png_size(data)
    return width, height, _pixels(data, width, height, {2: 3, 6: 4}[colour_type])


def _pixels(data, width, height, channels):
    position, compressed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        chunk = data[position + 8:position + 8 + length]
        assert zlib.crc32(kind + chunk) == struct.unpack(">I", data[position + 8 + length:position + 12 + length])[0]
        compressed += chunk if kind == b"IDAT" else b""
        position += 12 + length
    stride = channels * width
    raw, pixels, above = zlib.decompress(compressed), [], bytes(stride)
    for y in range(height):
        begin = y * (stride + 1)
        row = _unfilter(raw[begin], bytearray(raw[begin + 1:begin + 1 + stride]), above, channels)
        pixels += [tuple(row[x:x + channels]) for x in range(0, stride, channels)]
        above = row
    return pixels


def _unfilter(filter_, row, above, channels):
    for i, value in enumerate(row):
        left, corner = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
        up = above[i]
        if filter_ == 4:
            guess = left + up - corner
            predicted = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
        else:
            predicted = (0, left, up, (left + up) // 2)[filter_]
        row[i] = (value + predicted) & 255
    return row


def _rows(data):
    return list(csv.DictReader(io.StringIO(data.decode())))


DIRECTIONS = ["Lx", "Ly", "Lz", "Vx", "Vy", "Vz"]
FRAME = ["Nx", "Ny", "Nz", "Xx", "Xy", "Xz", "Yx", "Yy", "Yz"]


def csv_without_frame(data):
    assert data.decode().splitlines()[0].split(",") == DIRECTIONS + ["r", "g", "b"]


def csv_with_frame(data):
    assert data.decode().splitlines()[0].split(",") == DIRECTIONS + FRAME + ["r", "g", "b"]


def csv_reads_back(data):
    """Every number is the shortest that reads back: writing it again changes nothing but the notation."""
    for row in _rows(data):
        for text in row.values():
            number = float(text)
            assert math.isnan(number) or float(repr(number)) == number
            assert len(text.lstrip("-")) <= len(repr(number).lstrip("-")) + 2, text


def csv_200_rows(data):
    assert len(_rows(data)) == 200


def csv_lambert(data):
    """f = 1/pi everywhere."""
    for row in _rows(data):
        assert float(row["r"]) == float(row["g"]) == float(row["b"]) == 1 / math.pi, row


def csv_nan(data):
    rows = _rows(data)
    assert rows and all(row["r"] == "nan" for row in rows), rows
