"""Headless Chromium, which draws WebGL without a graphics card."""

from __future__ import annotations

import shutil
from typing import Any

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

BROWSER, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")


def is_installed() -> bool:
    return bool(BROWSER and DRIVER)


def start() -> Any:
    """Returns a new driver. The caller must quit it."""
    options: Any = Options()
    options.binary_location = str(BROWSER)
    for argument in [
        "--headless=new",
        "--no-sandbox",  # root cannot use the sandbox
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--disable-dev-shm-usage",
        "--window-size=1280,900",
    ]:
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(str(DRIVER)), options=options)
