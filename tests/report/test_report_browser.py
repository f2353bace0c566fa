# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""The page of a report in a real browser without a network: nothing is fetched, no script fails,
curves are drawn and zoom together, the view shows the bodies, and its controls change the picture;
the colours of the summary are those of a good run and of one whose history breaks a law.

Skipped (exit status 77) where there is no Chromium, driver, Selenium or Dygraphs.

test_report_browser.py EXECUTABLE FOLDER
"""

import base64
import io
import json
import re
import shutil
import subprocess
import sys
import time
import unittest

import matplotlib.image
from small_runs import SOURCE, Runs, change_column

from plotting import fields  # noqa: E402  (small_runs knows where)
from reporting import dygraphs

BROWSER, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
EXECUTABLE, FOLDER = sys.argv[1:3]
SKIPPED = 77
#: What the Dygraphs of Debian 13 says of a picture that shows a part of its curve.
ZOOMED = re.compile("points out of [XY] bounds")
OPTIONS = (
    "--headless=new",
    "--no-sandbox",  # refused to root otherwise
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--use-angle=swiftshader",  # WebGL without a graphics card
    "--enable-unsafe-swiftshader",
    "--window-size=1000,900",
)


def missing():
    """What the test needs and does not find, as Debian's packages."""
    packages = {"chromium": BROWSER, "chromium-driver": DRIVER}
    packages["libjs-dygraphs"] = dygraphs.embedded()[1]
    try:
        import selenium  # noqa: F401

        packages["python3-selenium"] = True
    except ImportError:
        packages["python3-selenium"] = False
    return [name for name, found in packages.items() if not found]


def start_browser():
    """Without a network."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = BROWSER
    for option in OPTIONS:
        options.add_argument(option)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service(DRIVER), options=options)
    browser.set_network_conditions(offline=True, latency=0, throughput=0)
    browser.set_script_timeout(60)
    return browser


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        runs = Runs(EXECUTABLE, FOLDER)
        cls.folders = {name: runs.run(name) for name in ("disc", "ball")}
        cls.folders["broken"] = runs.copy(cls.folders["disc"], "broken")
        change_column(
            cls.folders["broken"] / "history.csv",
            "total_energy_modified",
            lambda n, v: v + 1e-3 * (n > 5),
        )
        for folder in cls.folders.values():
            command = [sys.executable, "-B", SOURCE / "tools" / "report.py", folder]
            subprocess.run(command, check=True, capture_output=True)
        cls.browser = start_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def open(self, name):
        self.browser.get((self.folders[name] / "report.html").as_uri())

    def run_script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def tearDown(self):
        """After each test: nothing failed, and nothing but the page itself was asked for."""
        errors = [
            entry
            for entry in self.browser.get_log("browser")
            if entry["level"] != "INFO" and not ZOOMED.search(entry["message"])
        ]
        self.assertEqual(errors, [])
        events = [json.loads(entry["message"]) for entry in self.browser.get_log("performance")]
        addresses = {
            event["message"]["params"]["request"]["url"]
            for event in events
            if event["message"]["method"] == "Network.requestWillBeSent"
        }
        strange = [
            address
            for address in addresses
            if not address.startswith("data:") and not address.endswith("/report.html")
        ]
        self.assertEqual(strange, [])

    def picture(self):
        """Pixels of the view after it was drawn, values from 0 to 1."""
        text = self.browser.execute_async_script(
            "const done = arguments[0], canvas = document.getElementById('view-canvas');"
            "requestAnimationFrame(() => requestAnimationFrame(() => done(canvas.toDataURL())));"
        )
        data = base64.b64decode(text.partition(",")[2])
        return matplotlib.image.imread(io.BytesIO(data), format="png")[:, :, :3]

    def give(self, control, value):
        """As if a person had moved or typed."""
        self.run_script(
            "const control = document.getElementById('view-' + arguments[0]);"
            "if (control.type === 'checkbox') control.checked = arguments[1];"
            "else control.value = arguments[1];"
            "control.dispatchEvent(new Event('input'));",
            control,
            value,
        )

    def change(self, before, what):
        """The picture, which has to be another one."""
        after = self.picture()
        self.assertGreater(abs(after - before).max(), 0.05, f"{what} has changed nothing")
        return after

    def largest(self, name, field, series):
        """Of a field at all moments, read from the files of the run."""
        found = fields.read_series(self.folders[name] / f"{series}.pvd")
        return max(fields.read_fields(path).point_data[field].max() for _, path in found)

    def look_at(self, name):
        """What holds for the view of any run. Returns the picture in the middle of the run."""
        self.open(name)
        first = self.picture()
        shown = (first.min(axis=2) < 0.97).mean()
        self.assertGreater(shown, 0.03, "nothing is drawn")
        self.assertLess(shown, 0.9, "there is no background")
        last = int(self.run_script("return document.getElementById('view-time').max"))
        self.assertEqual(last + 1, len(fields.read_series(self.folders[name] / "volume.pvd")))
        self.give("time", last // 2)
        middle = self.change(first, "the slider")
        self.give("field", "pressure")
        pressed = self.change(middle, "another field")
        top = float(self.run_script("return document.getElementById('view-top').value"))
        self.assertAlmostEqual(top / self.largest(name, "CPRESS", "surface"), 1, places=3)
        self.give("field", "stress")
        self.assertEqual(abs(self.picture() - middle).max(), 0)
        self.assertGreater(abs(pressed - middle).max(), 0)
        for control, value in (("mesh", False), ("obstacles", False), ("factor", 3), ("top", 1)):
            self.give(control, value)
            middle = self.change(middle, control)
        return middle

    def drag(self, element, x, y):
        from selenium.webdriver import ActionChains

        ActionChains(self.browser).move_to_element(element).click_and_hold().move_by_offset(
            x, y
        ).release().perform()

    def double_click(self, element):
        from selenium.webdriver import ActionChains

        ActionChains(self.browser).double_click(element).perform()

    def element(self, selector):
        return self.browser.find_element("css selector", selector)

    def wait_for(self, text, value):
        """Until a script returns the value, for ten seconds."""
        for _ in range(200):
            if self.run_script(text) == value:
                return
            time.sleep(0.05)
        self.fail(f"{text} does not become {value}")

    def test_view_in_2d(self):
        picture = self.look_at("disc")
        self.drag(self.element("#view-canvas"), 90, 40)
        self.change(picture, "dragging")

    def test_view_in_3d(self):
        picture = self.look_at("ball")
        self.drag(self.element("#view-canvas"), 90, 40)
        picture = self.change(picture, "dragging")
        self.run_script(
            "document.getElementById('view-canvas').dispatchEvent("
            "new WheelEvent('wheel', {deltaY: -400, cancelable: true}))"
        )
        picture = self.change(picture, "the wheel")
        self.run_script("document.getElementById('view-play').click()")
        for _ in range(100):
            time.sleep(0.05)
            if abs(self.picture() - picture).max() > 0.05:
                break
        self.change(picture, "playing")
        self.run_script("document.getElementById('view-play').click()")

    def test_curves_zoom_together(self):
        self.open("disc")
        sections = self.run_script(
            "const all = document.querySelectorAll('details[data-curves]');"
            "for (const details of all) details.open = true; return all.length"
        )
        self.assertGreaterEqual(sections, 4)
        self.wait_for("return document.querySelectorAll('details[data-drawn]').length", sections)
        curves = self.browser.find_elements("css selector", ".curve")
        self.assertGreater(len(curves), 20)

        def ticks(curve, axis="x"):
            labels = curve.find_elements("css selector", f".dygraph-axis-label-{axis}")
            return [float(label.get_attribute("textContent")) for label in labels]

        heights, others = ticks(curves[0], "y"), ticks(curves[5], "y")
        self.drag(curves[0], 0, 60)
        self.assertNotEqual(ticks(curves[0], "y"), heights)
        self.assertEqual(ticks(curves[5], "y"), others)
        self.assertGreater(max(ticks(curves[5])), 0.2)
        self.drag(curves[0], -100, 0)
        for curve in (curves[0], curves[5], curves[-1]):
            self.assertLess(max(ticks(curve)), 0.2)
            self.assertGreater(min(ticks(curve)), 0.0)
        self.double_click(curves[0])
        for curve in (curves[0], curves[5], curves[-1]):
            self.assertGreater(max(ticks(curve)), 0.2)
        self.assertEqual(ticks(curves[0], "y"), heights)
        drawn = self.run_script(
            "return [...document.querySelectorAll('.curve canvas:first-of-type')].map(canvas =>"
            "  canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height)"
            "    .data.some(value => value > 0))"
        )
        self.assertTrue(all(drawn))

    def colours(self, name):
        """Class of each verdict, and the headline."""
        self.open(name)
        rows = self.run_script(
            "return [...document.querySelectorAll('#laws tr')].map("
            "row => [row.cells[0].textContent, row.querySelector('.verdict').className])"
        )
        return dict(rows), self.element("#headline").text

    def test_verdicts(self):
        good, headline = self.colours("disc")
        self.assertEqual(set(good.values()), {"verdict kept"})
        self.assertIn("All laws that the tables can judge are kept", headline)
        bad, headline = self.colours("broken")
        self.assertEqual(bad.pop("energy balance"), "verdict broken")
        good.pop("energy balance")
        self.assertEqual(bad, good)
        self.assertIn("Broken: energy balance. Do not trust this run.", headline)


if __name__ == "__main__":
    lacking = missing()
    if lacking:
        print(f"Skipped: no browser to look with. On Debian: apt-get install {' '.join(lacking)}")
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
