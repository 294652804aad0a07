"""`texbrdf view` in a real window: run.py PROGRAM SOURCES SCREENSHOTS. Prints what went wrong; exits with 1 then."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from screen import Screen, write_png

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from output_checks import png_pixels  # noqa: E402

SIZE = 96
PATIENCE = 120  # seconds until something that has to come is given up
BALL = '"position": {"x": 0, "y": 0.7, "z": 0}'


def difference(one, other):
    """Per cent of the pixels that differ by more than 3 of 255: edges may fall to the other side."""
    assert len(one) == len(other), (len(one), len(other))
    far = sum(any(abs(a - b) > 3 for a, b in zip(first, second)) for first, second in zip(one, other))
    return 100 * far / len(one)


def is_same(one, other):
    return difference(one, other) < 1.5


class Session:
    def __init__(self, program, sources, screenshots):
        self.program, self.screenshots = program, screenshots
        self.folder = pathlib.Path(tempfile.mkdtemp())
        for part in ("gallery/scenes", "examples"):
            shutil.copytree(sources / "docs" / part, self.folder / part)
        self.scene = self.folder / "gallery/scenes/steered.scene.json"
        self.text = self.scene.read_text()

    def rendered(self, *options):
        out = self.folder / "out.png"
        subprocess.run([self.program, "render", self.scene, "-o", out, "--size", str(SIZE), *options], check=True)
        width, height, pixels = png_pixels(out.read_bytes())
        assert (width, height) == (SIZE, SIZE)
        return [pixel[:3] for pixel in pixels]

    def open(self, screen):
        self.screen = screen
        self.errors = open(self.folder / "errors.txt", "w+")
        self.process = subprocess.Popen([self.program, "view", self.scene, "--size", str(SIZE)],
                                        env=screen.environment, stderr=self.errors)
        self.until("there is a window", lambda: len(screen.find_windows()) == 1)
        (self.window,) = screen.find_windows()
        screen.do("windowfocus", "--sync", self.window)

    def until(self, what, holds):
        begin = time.monotonic()
        while not holds():
            assert self.process.poll() is None, f"{what}: the program ended with {self.process.returncode}: {self.told()}"
            assert time.monotonic() - begin < PATIENCE, f"not so after {PATIENCE} seconds: {what}"
            time.sleep(0.05)

    def seen(self):
        width, height, pixels = self.screen.picture(self.window)
        assert (width, height) == (SIZE, SIZE), (width, height)
        return pixels

    def shows(self, what, picture):
        try:
            self.until(f"the window shows {what}", lambda: is_same(self.seen(), picture))
        finally:
            write_png(self.screenshots / f"{what.replace(' ', '_')}.png", SIZE, SIZE, self.seen())

    def differs(self, what, picture):
        self.until(f"{what} changes the picture", lambda: not is_same(self.seen(), picture))
        write_png(self.screenshots / f"{what.replace(' ', '_')}.png", SIZE, SIZE, self.seen())

    def press(self, key):
        self.screen.do("key", key)

    def hold(self, key, what, picture):
        self.screen.do("keydown", key)
        try:
            self.differs(what, picture)
        finally:
            self.screen.do("keyup", key)

    def told(self):
        self.errors.seek(0)
        return self.errors.read()

    def title(self):
        return self.screen.do("getwindowname", self.window)

    def write(self, text):
        """As editors do: never half a file."""
        beside = self.scene.with_suffix(".new")
        beside.write_text(text)
        beside.rename(self.scene)


def start_view(session):
    picture = session.rendered()
    session.shows("the start", picture)
    assert "steered" in session.title(), session.title()
    return picture


def views(session, start):
    for key, name in (("2", "normals"), ("3", "depth"), ("4", "steps"), ("5", "lipschitz")):
        session.press(key)
        session.shows(name, session.rendered("--view", name))
        assert name in session.title(), session.title()
    session.press("1")
    session.shows("shaded again", start)


def objects(session, start):
    session.hold("l", "the ball moved by L", start)
    # The camera stands still: the corner, where only the floor is, looks as before.
    corner = slice(SIZE * (SIZE - 1), SIZE * (SIZE - 1) + SIZE // 8)
    assert difference(session.seen()[corner], start[corner]) < 15, "the camera moved"
    session.press("r")
    session.shows("the ball back by R", start)


def camera(session, start):
    session.hold("w", "walking by W", start)
    session.press("r")
    session.shows("the start after W", start)
    session.hold("Left", "walking by an arrow", start)
    session.press("r")
    session.shows("the start after an arrow", start)
    screen, middle = session.screen, SIZE // 2
    screen.do("mousemove", "--window", session.window, middle, middle, "mousedown", 1, "mousemove", "--window",
              session.window, middle + 20, middle + 5, "mouseup", 1)
    session.differs("a drag", start)
    session.press("r")
    session.shows("the start after a drag", start)
    screen.do("click", 5)
    session.differs("the wheel", start)
    session.press("r")
    session.shows("the start after the wheel", start)


def edits(session, start):
    higher = session.text.replace(BALL, BALL.replace("0.7", "1.1"))
    assert higher != session.text
    session.write(higher)
    session.shows("the ball higher after an edit", session.rendered())

    before = session.seen()
    session.write(session.text.replace('"type": "Primitives/Sphere"', '"type": "Primitives/Sphare"'))
    session.until("the mistake is told", lambda: "Primitives/Sphare" in session.told())
    assert "gallery/scenes/steered.scene.json(" in session.told() and ") error: scene[0].type: " in session.told()
    session.until("the title tells of it", lambda: "not up to date" in session.title())
    assert is_same(session.seen(), before), "a broken file changed the picture"

    session.write(session.text.replace("wave.x * wave.y", "wave.x * wave.w"))
    session.until("the mistake in code is told", lambda: session.told().count("error") >= 2)
    assert "not up to date" in session.title(), session.title()
    assert is_same(session.seen(), before), "broken code changed the picture"

    session.write(session.text)
    session.shows("the start after the file is mended", start)
    session.until("the title is as before", lambda: "not up to date" not in session.title())


def closes(session, _):
    session.press("Escape")
    status = session.process.wait(timeout=PATIENCE)
    assert status == 0, f"status {status}: {session.told()}"


def without_display(program, scene):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run([program, "view", scene], env=environment, capture_output=True, text=True)
    assert done.returncode == 3 and "display" in done.stderr, (done.returncode, done.stderr)


def main(program, sources, screenshots):
    screenshots.mkdir(parents=True, exist_ok=True)
    session = Session(program, sources, screenshots)
    without_display(program, session.scene)
    with Screen() as screen:
        session.open(screen)
        try:
            start = start_view(session)
            for step in (views, objects, camera, edits, closes):
                step(session, start)
                print(f"{step.__name__}: fine")
        finally:
            session.process.kill()
            session.process.wait()
    shutil.rmtree(session.folder)
    return 0


sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])))
