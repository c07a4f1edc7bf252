# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Use a page as a reader would: look, turn, play, choose, read numbers.

    click_through.py CASE [PAGE]     writes CASE/*.png to look at
    click_through.py --bare PAGE     one without three.js
"""

import base64
import sys
import time

import h5py
import numpy as np
from browser import Page
from selenium.webdriver.common.action_chains import ActionChains


def until(what, test, seconds=40):
    end = time.time() + seconds
    while not test():
        assert time.time() < end, f"waited in vain until {what}"
        time.sleep(0.1)


def frame(page):
    return page.run("return fsbiBodies.state.frame")


def changed(a, b):
    """Share of the drawing that differs."""
    return np.mean(np.abs(a - b).max(axis=2) > 24)


def look(page, case):
    until("something is drawn", lambda: np.ptp(page.canvas(f"{case}/first.png")) > 50)
    assert frame(page) == 0


def turn(page):
    before, camera = page.canvas(), page.run("return fsbiBodies.camera.position.toArray()")
    ActionChains(page.driver).move_to_element(page.element("#canvas")).click_and_hold() \
        .move_by_offset(150, 40).release().perform()
    time.sleep(0.5)
    after = page.run("return fsbiBodies.camera.position.toArray()")
    assert np.linalg.norm(np.subtract(camera, after)) > 1, "the camera stands still"
    assert changed(before, page.canvas()) > 0.01, "the drawing stands still"
    page.click("#whole")


def play(page, case):
    last = page.run("return fsbiBodies.times.length - 1")
    before = page.canvas()
    page.click("#play")
    until("it plays", lambda: 0 < frame(page))
    page.click("#play")                         # pause
    stopped = frame(page)
    time.sleep(1)
    assert frame(page) == stopped, "it plays on"
    page.click("#play")
    until("it has played", lambda: frame(page) == last)
    until("it stops", lambda: page.element("#play").text == "Play")
    page.click("#glass")
    page.click("#edges")
    after = page.canvas(f"{case}/last.png")
    assert changed(before, after) > 0.001, "nothing has moved"
    shown = page.element("#clock").text
    assert f"{page.run('return fsbiBodies.times')[-1]:g}" in shown, shown


def choose(page, case):
    """Every body by its button, numbers beside it as in the history."""
    with h5py.File(f"{case}/postProcessing/history.h5", "r", swmr=True) as file:
        for button in page.elements("#choices button"):
            page.run("arguments[0].scrollIntoView({block: 'center'})", button)
            button.click()
            lines = page.elements("#values tr")
            there = page.run("return fsbiBodies.state.chosen.group.visible")
            assert bool(lines) == there, button.text
            for line in lines:
                path = line.get_attribute("data-path")
                assert path.split("/")[1] == button.text, path
                told = line.find_elements("css selector", "td")[1].text.split()
                row = file[path][int(line.get_attribute("data-row"))]
                np.testing.assert_allclose([float(t) for t in told], row[1:], rtol=1e-3,
                                           err_msg=path)
                assert row[0] == file[path][-1][0], "not those of the last time"


def pick(page):
    """A body by a click on it."""
    page.click("#whole")
    time.sleep(0.3)
    models = page.run("""return fsbiBodies.models.map(m => {
        const at = m.sphere(fsbiBodies.state.frame);
        if (!at) return null;
        const s = at.center.project(fsbiBodies.camera);
        return [m.name, s.x, s.y]; })""")
    canvas = page.element("#canvas")
    page.run("arguments[0].scrollIntoView({block: 'center'})", canvas)
    for name, x, y in filter(None, models):
        ActionChains(page.driver).move_to_element_with_offset(
            canvas, round(x * canvas.size["width"] / 2),
            round(-y * canvas.size["height"] / 2)).click().perform()
        assert page.run("return fsbiBodies.state.chosen.name") == name, name


def absent(page):
    """Who is not there is not drawn, whichever time is chosen."""
    shown = page.run("""
        const slider = document.getElementById('slider'), shown = [];
        for (let k = 0; k < fsbiBodies.times.length; ++k) {
            slider.value = k;
            slider.oninput({ target: slider });
            shown.push(fsbiBodies.models.map(m => m.group.visible));
        }
        return shown;""")
    scene = page.run("return data.scene.bodies")
    for body, seen in zip(scene, zip(*shown)):
        there = [f is not None for f in body["frames"]] if "frames" in body else list(
            ~np.isnan(np.frombuffer(base64.b64decode(body["motion"]), "<f4")[::7]))
        assert list(seen) == there, body["name"]


def bonds(page):
    if not page.run("return !!fsbiBodies.rods"):
        return
    assert page.element("#tensions").is_displayed()
    page.run("fsbiBodies.camera.position.y -= fsbiBodies.camera.position.distanceTo("
             "fsbiBodies.models[0].sphere(0).center)")
    time.sleep(0.5)
    before = page.canvas()
    page.run("fsbiBodies.rods.visible = false")
    time.sleep(0.5)
    assert changed(before, page.canvas()) > 1e-4, "bonds cannot be seen"


def curves(page, case):
    """The number under the pointer."""
    titles = page.run("return charts.map(c => c.spec.title)")
    assert len(titles) == len(page.elements(".chart")) > 6, titles
    chart = page.elements(".chart")[titles.index("Krylov iterations")]
    drawn = chart.find_element("css selector", "svg")
    page.run("arguments[0].scrollIntoView({block: 'center'})", drawn)
    ActionChains(page.driver).move_to_element_with_offset(
        drawn, drawn.size["width"] // 2 - 24, 0).perform()
    told = chart.find_element("css selector", ".legend").text.split()
    if case:
        with h5py.File(f"{case}/postProcessing/history.h5", "r", swmr=True) as file:
            last = file["cost"][-1]
        assert [float(told[0]), float(told[-1])] == [last[0], last[2]], (told, last)
    page.click("details summary")
    assert page.element("details table").is_displayed()


def main(argv):
    bare = argv[0] == "--bare"
    path = argv[1] if len(argv) > 1 else f"{argv[0]}/report.html"
    with Page(path) as page:
        if bare:
            assert not page.element("#stage").is_displayed()
            assert "libjs-three" in page.element(".missing").text
            curves(page, None)
        else:
            case = argv[0]
            look(page, case)
            turn(page)
            play(page, case)
            choose(page, case)
            pick(page)
            absent(page)
            curves(page, case)
            bonds(page)
        assert not page.complaints(), page.complaints()
        assert not page.requests(), page.requests()


main(sys.argv[1:])
