"""The checks of output_checks.py fail where they should."""

import struct
import unittest
import zlib

import output_checks

PLACE = '{"start": {"line": 1, "column": 2}, "end": {"line": 1, "column": 1}}'


class OutputChecks(unittest.TestCase):
    def test_a_list_of_diagnostics_has_all_members(self):
        with self.assertRaises(AssertionError):
            output_checks.diagnostics_list(b'[{"file": "a.tex", "code": "E1001"}]')

    def test_a_range_does_not_end_before_it_starts(self):
        entry = ('[{"file": "a", "code": "E1001", "severity": "error", "message": "m", "range": %s, "related": [], '
                 '"fixes": []}]' % PLACE)
        with self.assertRaises(AssertionError):
            output_checks.diagnostics_list(entry.encode())

    def test_sarif_needs_a_version(self):
        with self.assertRaises(KeyError):
            output_checks.sarif_log(b'{"runs": []}')

    def test_padded_numbers_do_not_pass_as_the_shortest(self):
        with self.assertRaises(AssertionError):
            output_checks.csv_reads_back(b"r\n0.10000000000000001\n")

    def test_a_picture_without_transparency_is_no_sphere(self):
        header = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
        data = b"\x89PNG\r\n\x1a\n" + struct.pack(">I4s", 13, b"IHDR") + header + struct.pack(">I", zlib.crc32(b"IHDR" + header))
        with self.assertRaises(AssertionError):
            output_checks.png_shows_a_sphere(data)


unittest.main()
