# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A page of fsbiReport in Chromium without a display."""

import io
import json
import os
import tempfile

import numpy as np
from PIL import Image
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

QUIET = ["--headless=new", "--no-sandbox", "--no-first-run", "--disable-quic",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--window-size=1280,1000"]


class Page:
    """The page while the `with` lasts."""

    def __init__(self, path):
        self.path = os.path.abspath(path)

    def __enter__(self):
        self.home = tempfile.TemporaryDirectory()
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        for argument in QUIET + [f"--user-data-dir={self.home.name}"]:
            options.add_argument(argument)
        self.driver = webdriver.Chrome(
            options=options, service=Service("/usr/bin/chromedriver"))
        self.driver.get("file://" + self.path)
        return self

    def __exit__(self, *_):
        self.driver.quit()
        self.home.cleanup()

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def element(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def elements(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def click(self, selector):
        # not through the sticky line of links
        self.run("arguments[0].scrollIntoView({block: 'center'})", self.element(selector))
        self.element(selector).click()

    def complaints(self):
        return [e["message"] for e in self.driver.get_log("browser")
                if e["level"] in ("SEVERE", "WARNING") and "GPU stall" not in e["message"]]

    def requests(self):
        """Addresses the page asked for, besides itself and what it carries."""
        found = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                if url.startswith(("http", "ws", "ftp", "file:")) \
                        and url != "file://" + self.path:
                    found.append(url)
        return found

    def canvas(self, save=None):
        """Pixels of the drawing."""
        self.run("arguments[0].scrollIntoView({block: 'center'})", self.element("#canvas"))
        image = Image.open(io.BytesIO(self.element("#canvas").screenshot_as_png)).convert("RGB")
        if save:
            image.save(save)
        return np.asarray(image, float)
