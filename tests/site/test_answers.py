"""The numbers in the answers to exercises, worked out once more. Usage: test_answers.py docs"""
import math
import re
import sys
import unittest
from pathlib import Path

DOCS = Path(sys.argv.pop())


def fresnel(n, degrees):
    """Exact, unpolarized, by Snell's law."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    t = math.sqrt(1 - (s / n) ** 2)
    return (((c - n * t) / (c + n * t)) ** 2 + ((n * c - t) / (n * c + t)) ** 2) / 2


def srgb(light):
    return 1.055 * light ** (1 / 2.4) - 0.055


def best_factor(shininess, degrees, steps=24):
    """The factor of Phong's exponent with which Blinn's highlight is nearest to Phong's, in least squares over all viewers."""
    angle, pairs = math.radians(degrees), []
    for i in range(steps):
        z = (i + 0.5) / steps
        for j in range(2 * steps):
            phi, s = math.pi * (j + 0.5) / steps, math.sqrt(1 - z * z)
            x, y = s * math.cos(phi), s * math.sin(phi)
            phong = max(math.sin(angle) * x + math.cos(angle) * z, 0)
            blinn = (z + math.cos(angle)) / math.hypot(x - math.sin(angle), y, z + math.cos(angle))
            pairs.append((phong ** shininess, blinn))
    return min((sum((p - b ** (shininess * f / 100)) ** 2 for p, b in pairs), f / 100) for f in range(190, 241, 10))[1]


ANSWERS = [  # page, what the answer says with {} for the number, the number
    ("11_z_buffer", "= {}. So everything", 100 * (1 - 0.1) / (1 * (100 - 0.1))),
    ("12_camera", "the tangent of {}°", math.degrees(math.atan(math.tan(math.radians(20)) / 2))),
    ("12_camera", "vertical_fov_deg = {},", 2 * math.degrees(math.atan(math.tan(math.radians(20)) / 2))),
    ("23_blinn_phong", "about {} h if squares", best_factor(24, 60)),
    ("25_exponents", "turned by {}°", math.degrees(math.acos(0.5 ** (1 / 16))) / 2),
    ("25_exponents", "= {} of the radius", math.sin(math.acos(0.5 ** (1 / 16)) / 2)),
    ("30_fog", "e^−1 = {}.", math.exp(-1)),
    ("31_fog_distance", "+ 0.333) = {}.", math.sqrt(1 + (16 / 9) ** 2 / 3 + 1 / 3)),
    ("32_fog_per_vertex", "Δt ≤ {}.", math.sqrt(8 / 255)),
    ("40_fresnel", "above it ({} against", fresnel(1.33, 60)),
    ("40_fresnel", "against {})", (0.33 / 2.33) ** 2 + (1 - (0.33 / 2.33) ** 2) * 0.5 ** 5),
    ("40_fresnel", "so F = {}, which", 0.04 / 1.04),
    ("40_fresnel", "has at {}°", min(range(90), key=lambda a: abs(fresnel(1.33, a) - 0.04 / 1.04))),
    ("41_microfacets", "= {}, that is", 1 / math.sqrt(math.pi)),
    ("41_microfacets", "above {}.", math.pi ** -0.25),
    ("50_environment", "cos 10° = {},", 1 - math.cos(math.radians(10))),
    ("50_environment", "(2/256)² = {} sr", (2 / 256) ** 2),
    ("50_environment", "/256² = {};", 4 * math.pi / 6 / 256 ** 2),
    ("50_environment", "middle's, {}.", (2 / 256) ** 2 / (3 * math.sqrt(3))),
    ("51_irradiance", "A₂ = π/4 = {},", math.pi / 4),
    ("51_irradiance", "0.28 = {} normals", 1536 * 28 / 100),
    ("53_brdf_map", "+ 0.445 = {}, green", 0.449 + 0.445),
    ("53_brdf_map", "+ 0.445 = {}, blue", 0.77 * 0.449 + 0.445),
    ("53_brdf_map", "+ 0.445 = {}. Paler", 0.34 * 0.449 + 0.445),
    ("62_pcf", "+ 1)² = {}.", (2 * 3 + 1) ** 2),
    ("71_gamma", "0.9 is {} of 255", 255 * srgb(0.9)),
    ("71_gamma", "to 255: {}.", 255 - math.floor(255 * srgb(0.9))),
    ("71_gamma", "to 255, {} of them", 255 - math.floor(255 * 0.9)),
    ("95_depth_precision", "(f − n)) = {} for", 10000 * 0.01 * 2 ** 24 / (1000 * (10000 - 0.01))),
]


class Answers(unittest.TestCase):
    def test_each_number_is_what_it_says(self):
        for page, text, value in ANSWERS:
            words = " ".join((DOCS / f"{page}.md").read_text(encoding="utf-8").partition("## Exercises")[2].split())
            before, after = (re.escape(part) for part in text.split("{}"))
            found = re.search(rf"{before}(\d+(?:\.\d+)?(?:e-?\d+)?){after}", words)
            with self.subTest(page=page, text=text):
                self.assertIsNotNone(found, "the page does not say this")
                mantissa, _, exponent = found.group(1).partition("e")
                step = 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
                self.assertLessEqual(abs(float(found.group(1)) - value), 0.5001 * step)

    def test_planar_shadow_of_64(self):
        plane, light = (0, 1, 0, 0), (1, 2, 0, 0)
        height = sum(p * l for p, l in zip(plane, light))
        matrix = [[height * (i == j) - light[i] * plane[j] for j in range(4)] for i in range(4)]
        x, y, z, w = (sum(m * q for m, q in zip(row, (3, 4, 5, 1))) for row in matrix)
        page = (DOCS / "64_planar_shadows.md").read_text(encoding="utf-8")
        self.assertEqual((x / w, y / w, z / w), (1, 0, 5))
        self.assertIn("the point (1, 0, 5)", " ".join(page.split()))


if __name__ == "__main__":
    unittest.main()
