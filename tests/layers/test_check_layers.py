#!/usr/bin/env python3
"""The layer check itself: a clean tree passes, and each planted violation is found and named."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from check_layers import violations  # noqa: E402

CLEAN = {
    "shapes/math/vec.h": "#include <cmath>\n#include <experimental/simd>\n",
    "shapes/sphere.h": '#include <Eigen/Core>\n#include "shapes/math/vec.h"\n',
    "shapes/hull.cpp": '#include <libqhull_r/qhull_ra.h>\n#include "shapes/sphere.h"\n',
    "libcontact/contact.h": '#include "shapes/math/vec.h"\n',
    "libcontact/methods/spheres.h": '#include "libcontact/contact.h"\n#include "shapes/sphere.h"\n',
    "libcontact/laws/hertz.h": '#include "libcontact/contact.h"\n#include "shapes/math/vec.h"\n',
    "libcontact/kernels/hertz.kernel.cpp": '#include "libcontact/laws/hertz.h"\n',
    "libcontact/bindings/c/contact.h": "#include <stdint.h>\n",
    "libdem/world.h": '#include <hdf5.h>\n#include "libcontact/methods/spheres.h"\n',
    "tests/libdem/world.cpp": '#include "libdem/world.h"\n',
}
PLANTED = [  # path, added text, what the report must say
    ("shapes/sphere.h", '#include "libcontact/contact.h"\n', "goes upward"),
    ("shapes/hull.cpp", '#  include "libdem/world.h"\n', "goes upward"),
    ("libcontact/contact.h", '#include "libdem/world.h"\n', "goes upward"),
    ("libdem/world.h", '#include "tests/helper.h"\n', "goes upward"),
    ("libcontact/methods/spheres.h", '#include "libcontact/laws/hertz.h"\n', "law in a method"),
    ("libcontact/laws/hertz.h", '#include "libcontact/methods/spheres.h"\n', "method in a law"),
    ("libcontact/laws/hertz.h", '#include "shapes/sphere.h"\n', "shape in a law"),
    ("libcontact/contact.h", "#include <fmt/core.h>\n", "neither the standard library nor Eigen"),
    ("libcontact/bindings/c/contact.h", "#include <math.h>\n", "neither the standard library nor Eigen"),
    ("shapes/sphere.h", "#include <immintrin.h>\n", "neither the standard library nor Eigen"),
    ("libcontact/contact.h", "#include <Eigen/Dense>\n", "reached by libcontact/kernels/hertz.kernel.cpp"),
    ("libcontact/kernels/hertz.kernel.cpp", '#include "shapes/sphere.h"\n', "only shapes/math and kernel templates"),
    ("shapes/hull.cpp", '#include "sphere.h"\n', "not written from the root"),
    ("libdem/world.cpp", "\n" * 501, "501 lines"),
]


class LayerCheck(unittest.TestCase):
    def report(self, planted=None):
        with tempfile.TemporaryDirectory() as root:
            for path, text in CLEAN.items():
                self.append(root, path, text)
            if planted:
                self.append(root, *planted)
            return list(violations(root))

    @staticmethod
    def append(root, path, text):
        full = os.path.join(root, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, "a", encoding="utf-8") as out:
            out.write(text)

    def test_clean_tree_passes(self):
        self.assertEqual(self.report(), [])

    def test_each_planted_violation_is_named(self):
        for path, text, expected in PLANTED:
            with self.subTest(path=path, text=text[:40]):
                found = self.report((path, text))
                self.assertTrue(any(expected in line for line in found), found)
                self.assertTrue(any(line.startswith(path) for line in found), found)


if __name__ == "__main__":
    unittest.main()
