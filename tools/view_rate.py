#!/usr/bin/python3
"""Measures the speed of a page of `geodesic-bench view` in headless Chromium, without a graphics
processor: while the model turns, and while its solvers are played as fast as possible. Prints the
frames per second; the CPU seconds per frame, which depend less on other load of the machine; and the
part of them for the page's scripts and for submitting the scene to the renderer. With a graphics
processor only that part remains on the CPU.

view_rate.py PAGE.html
"""

from __future__ import annotations

import os
import statistics
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "plots"))

import chromium  # noqa: E402  (needs the path above)

SECONDS, TIMES = 5, 3
DRAW = """
    const [keys, seconds, done] = arguments, begin = performance.now();
    const ends = new MessageChannel(), own = [];
    let frames = 0, start = 0;
    ends.port1.onmessage = () => own.push(performance.now() - start);
    const draw = () => {
      start = performance.now();
      ends.port2.postMessage(null);  // handled after all scripts of this frame
      const options = {key: keys[frames % keys.length], bubbles: true};
      document.body.dispatchEvent(new KeyboardEvent('keydown', options));
      const passed = (performance.now() - begin) / 1000;
      if (passed < seconds) { ++frames; requestAnimationFrame(draw); } else done([frames, passed, own]);
    };
    requestAnimationFrame(draw);"""


def processor_seconds(process: int) -> float:
    """Returns the CPU seconds of a process and its descendants."""
    of, parents = {}, {}
    for file in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = file.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        number = int(file.parent.name)
        parents[number] = int(words[1])
        of[number] = (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def belongs(number: int) -> bool:
        return number == process or (number in parents and belongs(parents[number]))

    return sum(seconds for number, seconds in of.items() if belongs(number))


def main() -> int:
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_file():
        print("view_rate.py: name one page, as geodesic-bench view writes them", file=sys.stderr)
        return 1
    browser = chromium.start()
    try:
        browser.set_script_timeout(60 * SECONDS)
        browser.get(Path(sys.argv[1]).resolve().as_uri())
        while browser.execute_script("return document.body.dataset.rests") != "true":
            time.sleep(0.1)
        for what, keys in {"turning": ["ArrowRight"], "playing": [",", "."]}.items():
            rates, costs, own = [], [], []
            for _ in range(TIMES):
                before = processor_seconds(browser.service.process.pid)
                frames, seconds, scripts = browser.execute_async_script(DRAW, keys, SECONDS)
                rates.append(frames / seconds)
                own.append(statistics.median(scripts))
                costs.append((processor_seconds(browser.service.process.pid) - before) / frames)
            print(
                f"{what}: {min(rates):.1f} to {max(rates):.1f} frames a second, "
                f"{min(costs):.2f} to {max(costs):.2f} s of processors a frame, "
                f"{min(own):.1f} to {max(own):.1f} ms of them the page's own"
            )
        load, processors = os.getloadavg()[0], os.cpu_count()
        print(f"on {processors} processors with a load of {load:.1f}")
    finally:
        browser.quit()
    return 0


if __name__ == "__main__":
    sys.exit(main())
