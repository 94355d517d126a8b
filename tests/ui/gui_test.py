#!/usr/bin/env python3
"""Drives the window of Druse with real mouse and keyboard events.

usage: gui_test.py SCENARIO DRUSE MODELS PICTURES

Needs a display (on_display.sh makes one). What happened is read from the event log, never guessed from pictures; the pictures are
kept to be looked at.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

PATIENCE = 20  # seconds; a frame takes a third of one where the processor draws it

# Places in a window of 1280 by 800, as src/ui/layout.h has them.
SEARCH_FIELD = (140, 46)
VIEW_MIDDLE = (658, 420)
SIDE_FACE = (540, 500)
TOP_FACE = (658, 280)
BESIDE_THE_MESH = (330, 700)
PANEL_ROWS_TOP = 28 + 300 + 1 + 28 + 2 * 22
ROW_HEIGHT = 26
SLIDER = (176, 278)
PANEL_PICTURE = (260, 380)
PRESETS = (250, 343)
RESET = (203, 753)
APPLY = (111, 753)
SWATCH_X = 1028 + 16
GROUP_ROWS_TOP = 28 + 28 + 242 + 28
PAINT_BUTTON = (1060, 551)
# In the tile editor, of the same size.
TILE_TYPE = (50, 47)
TILE_CHOICE = (1150, 266)
TILE_FIELD = (1150, 368)
# In the cell editor, too.
CELL_KIND = (90, 47)
CELL_NEAR, CELL_FAR = (723, 308), (1095, 308)  # the middles of its views
# Faces of a torus with 24 by 12 of them.
HOLES = ((690, 485), (560, 475), (866, 436))
STRIP = ((622, 565), (694, 565), (762, 555))
INSIDE_THE_STRIP = (690, 567)


class Failure(Exception):
    pass


def check(condition, text):
    if not condition:
        raise Failure(text)


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, timeout=60, capture_output=True, text=True, **options).stdout


class Window:
    """The program, its window and its event log."""

    def __init__(self, druse, folder, pictures, arguments, geometry="1280x800+0+0"):
        self.log_file = folder / "events.txt"
        self.log_file.unlink(missing_ok=True)
        self.seen = 0
        self.pictures = pictures
        environment = dict(os.environ, HOME=str(folder), XDG_STATE_HOME=str(folder / "state"), XDG_CONFIG_HOME=str(folder / "config"),
                            LP_NUM_THREADS="2")
        self.errors = open(folder / "stderr.txt", "w+")
        self.process = subprocess.Popen(
            [str(druse), "--test", "--geometry", geometry, "--event-log", str(self.log_file)] + [str(a) for a in arguments],
            cwd=folder, env=environment, stderr=self.errors)
        self.wait("frame")
        self.wait_anywhere("ready")
        self.id = run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "Druse$").split()[0]

    def lines(self):
        return self.log_file.read_text().splitlines() if self.log_file.exists() else []

    def alive(self):
        return self.process.poll() is None

    def wait_anywhere(self, start):
        self.seen = 0
        return self.wait(start)

    def wait(self, start):
        """Waits for a line that begins so, after those already waited for."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            lines = self.lines()
            for i in range(self.seen, len(lines)):
                if lines[i].startswith(start):
                    self.seen = i + 1
                    return lines[i]
            if not self.alive():
                self.errors.seek(0)
                raise Failure(f"the program ended with {self.process.returncode}, waiting for '{start}': {self.errors.read()}")
            time.sleep(0.02)
        raise Failure(f"no '{start}' after line {self.seen} of the event log:\n" + "\n".join(self.lines()[-20:]))

    def quiet(self, start, seconds=0.7):
        """Makes sure that no such line comes."""
        time.sleep(seconds)
        lines = [line for line in self.lines()[self.seen:] if line.startswith(start)]
        check(not lines, f"unexpected: {lines}")

    def mouse(self, *words):
        run("xdotool", *words)

    def move(self, place):
        self.mouse("mousemove", "--window", self.id, place[0], place[1])

    def press(self, place, button=1):
        self.move(place)
        self.mouse("mousedown", button)

    def release(self, button=1):
        self.mouse("mouseup", button)

    def click(self, place, button=1):
        self.press(place, button)
        self.release(button)

    def keys(self, *names):
        for name in names:
            run("xdotool", "key", name)
            time.sleep(0.05)

    def type(self, text, delay=12):
        run("xdotool", "type", "--delay", delay, text)

    def picture(self, name):
        """A picture of the whole screen: dialogs are windows of their own."""
        time.sleep(0.3)
        file = self.pictures / (name + ".png")
        # xwd leaves the view of a second window black.
        subprocess.run(["timeout", "10", "import", "-window", "root", str(file)], check=True, timeout=60)
        return file

    def choose(self, name, words=None):
        """Through the search field, as a person would who does not know where it is."""
        self.click(SEARCH_FIELD)
        self.keys("ctrl+a")
        self.type(words or name.split(".")[1])
        self.keys("Return")
        self.wait("chosen " + name)

    def answer_file_dialog(self, title, path, proposed=""):
        """Types the name of a file in the folder that the dialog shows; it would complete the names of others."""
        run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", title)
        time.sleep(0.5)
        self.keys("End", *["BackSpace"] * len(proposed))
        self.type(path.name, delay=80)
        self.picture("dialog-" + title.lower().replace(" ", "-"))
        self.keys("Return")

    def export_save_and_close(self, folder):
        """Leaves the mesh in window.obj and its history in history.druse."""
        self.keys("ctrl+e")
        self.answer_file_dialog("Export", folder / "window.obj", "colored_cube.stl")
        self.wait("exported")
        self.keys("ctrl+shift+s")
        self.answer_file_dialog("Save as", folder / "history.druse", "colored_cube.obj")
        self.wait("saved " + str(folder / "history.druse"))
        self.close()

    def close(self):
        if self.alive():
            self.process.terminate()
            self.process.wait(timeout=10)
        self.errors.close()


def different_pixels(a, b):
    done = subprocess.run(["compare", "-metric", "AE", "-fuzz", "2%", str(a), str(b), "null:"], capture_output=True, text=True, timeout=60)
    return int(float(done.stderr.split()[0]))


def row_of(druse, operator, parameter):
    """The row of the panel that a parameter has, counted from 0: a list of n numbers has n of them."""
    row = 0
    listed = json.loads(run(druse, "ops", operator, "--json"))
    entry = listed[0] if isinstance(listed, list) else listed.get("operators", [listed])[0]
    for p in entry["parameters"]:
        if p["name"] == parameter:
            return row
        row += len(str(p["default"]).split(",")) if "numbers" in p["type"] else 1
    raise Failure(f"{operator} has no parameter {parameter}")


def row_middle(row):
    return PANEL_ROWS_TOP + row * ROW_HEIGHT + 11


def group_row(row):
    return GROUP_ROWS_TOP + row * 22 + 11


# --- scenarios -------------------------------------------------------------------------------------------------------------------


def click_and_export(druse, folder, pictures):
    """Open, press and release on a face, drag a slider, undo, redo, export: the file is that of `druse apply` with the history."""
    window = Window(druse, folder, pictures, [folder / "colored_cube.obj"])
    window.choose("extrude.dodecahedral")
    window.move(BESIDE_THE_MESH)
    idle = window.picture("1-idle")

    window.press(SIDE_FACE)
    pressed = window.wait("pressed face")
    check("outlined 4" in pressed, f"the whole group should be outlined: {pressed}")
    press = window.picture("2-press")
    check(different_pixels(idle, press) > 1000, "a press should show")
    check("applied" not in "\n".join(window.lines()), "a press must not act")
    window.release()
    # 4 sides of the cube: each adds 2 rows of 4 pentagons, so 6 + 4 * 8 faces.
    window.wait("applied extrude.dodecahedral faces=38")
    window.picture("3-release")

    y = row_middle(row_of(druse, "extrude.dodecahedral", "angle"))
    window.press(((SLIDER[0] + SLIDER[1]) // 2, y))
    for x in range((SLIDER[0] + SLIDER[1]) // 2, SLIDER[0] + 40, -4):
        window.move((x, y))
    window.release()
    window.wait("adjusted extrude.dodecahedral faces=38")
    window.picture("4-slider")

    window.keys("ctrl+z")
    window.wait("applied document.undo faces=6")
    window.picture("5-undo")
    window.keys("ctrl+shift+z")
    window.wait("applied document.redo faces=38")

    for name in ("window.stl", "window.obj"):
        window.keys("ctrl+e")
        window.answer_file_dialog("Export", folder / name, "colored_cube.stl")
        window.wait("exported " + str(folder / name))
    window.keys("ctrl+shift+s")
    window.answer_file_dialog("Save as", folder / "history.druse", "colored_cube.obj")
    window.wait("saved " + str(folder / "history.druse"))
    window.picture("6-exported")
    window.close()

    script = (folder / "history.druse").read_text().splitlines()
    steps = [line for line in script if line.startswith("extrude.")]
    check(len(steps) == 1 and "angle=" in steps[0], f"one extrusion with the slider's angle should be recorded: {script}")
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.stl", "-o", folder / "terminal.obj")
    for kind in ("stl", "obj"):
        ours, theirs = (folder / f"window.{kind}").read_bytes(), (folder / f"terminal.{kind}").read_bytes()
        if kind == "obj":  # the name of its material library is that of the file
            ours, theirs = ours.replace(b"window", b"terminal"), theirs
        check(ours == theirs, f"the exported .{kind} is not the one that `druse apply` makes")


def cancel(druse, folder, pictures):
    """Nothing happens when a press is taken back; an error is a line and not the end."""
    window = Window(druse, folder, pictures, [folder / "colored_cube.obj"])
    window.choose("extrude.cubical")

    window.press(SIDE_FACE)
    window.wait("pressed face")
    window.move(TOP_FACE)
    window.wait("pressed face 1")
    window.move(BESIDE_THE_MESH)
    window.wait("pressed nothing")
    window.release()
    window.quiet("applied")

    window.press(SIDE_FACE)
    window.wait("pressed face")
    window.keys("Escape")
    window.wait("click cancelled")
    window.release()
    window.quiet("applied")

    window.press(SIDE_FACE)
    window.wait("pressed face")
    window.mouse("mousedown", 3)
    window.wait("click cancelled")
    window.mouse("mouseup", 3)
    window.release()
    window.quiet("applied")

    window.keys("Escape", "Escape", "Escape")  # puts the tool down, and never closes the window
    check(window.alive(), "Escape closed the window")
    window.keys("ctrl+p")
    time.sleep(0.5)
    window.type("extrude.cubical faces=0 angle=270")
    window.keys("Return")
    window.wait("error extrude.cubical: angle=270: expected 1 to 179 degrees")
    window.picture("error")
    window.keys("ctrl+p")
    time.sleep(0.5)
    window.type("extrude.cubical faces=0 angle=100")
    window.keys("Return")
    window.wait("applied extrude.cubical faces=10")

    for command in ("make.torus nu=380 nv=380", "remesh.catmull_clark iterations=3"):  # the second takes its time
        window.keys("ctrl+p")
        time.sleep(0.5)
        window.type(command)
        window.keys("Return")
        if command.startswith("make"):
            window.wait("applied make.torus")
    time.sleep(0.25)
    window.keys("Escape")
    window.wait("cancelled")
    window.picture("cancelled")
    window.keys("ctrl+z")
    window.wait("applied document.undo faces=10")

    window.process.terminate()  # asked to end, it does so in order
    check(window.process.wait(timeout=10) == 0, f"SIGTERM ended with {window.process.returncode}")
    window.close()


def dialogs(druse, folder, pictures):
    """Open by dialog, a good file and a broken one; menus by keyboard."""
    (folder / "broken.obj").write_text("v 0 0 0\nf 1 2 9000\n")
    window = Window(druse, folder, pictures, [folder / "cube.obj"])
    window.click(BESIDE_THE_MESH)
    window.keys("ctrl+o")
    window.answer_file_dialog("Open", folder / "dodecahedron.obj")
    window.wait("opened " + str(folder / "dodecahedron.obj"))
    window.wait("frame")
    window.keys("ctrl+o")
    window.answer_file_dialog("Open", folder / "broken.obj")
    error = window.wait("error")
    check("broken.obj:2" in error, f"the line should be named: {error}")
    window.picture("broken")
    check(window.alive(), "a broken file ended the program")

    window.keys("alt+e")
    time.sleep(0.5)
    window.picture("menu")
    window.keys("Escape")
    window.press((560, 300), 3)
    window.release(3)
    time.sleep(0.5)
    window.picture("context-menu")
    window.keys("Escape")
    window.keys("a")
    window.wait("applied select.faces faces=12")
    window.close()


def solids(druse, folder, pictures):
    """A solid from the gallery, its sliders, values kept under a name, and a start corner."""
    window = Window(druse, folder, pictures, [folder / "colored_cube.obj"])
    window.choose("extrude.solid", "any solid")
    window.picture("1-no-solid")
    window.click(PANEL_PICTURE)
    gallery = run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Solids$").split()[0]
    time.sleep(1.5)  # its pictures come a few at a time
    plain = window.picture("2-gallery")
    window.mouse("mousemove", "--window", gallery, 10 + 3 * 96 + 48, 10 + 40)  # the fourth: the dodecahedron
    check(different_pixels(plain, window.picture("3-gallery-marked")) > 1000, "the solid under the pointer should be marked")
    window.mouse("click", 1)

    window.click(SIDE_FACE)
    window.wait("applied extrude.solid faces=38")  # as with extrude.dodecahedral
    y = row_middle(8)  # solid base turns phase mirror angle, and the third of three heights
    window.press((SLIDER[0] + 30, y))
    for x in range(SLIDER[0] + 30, SLIDER[0] + 70, 4):
        window.move((x, y))
    window.release()
    window.wait("adjusted extrude.solid faces=38")
    window.picture("4-adjusted")

    window.click(PRESETS)
    time.sleep(0.5)
    window.picture("5-presets")
    window.keys("Down", "Return")
    time.sleep(0.5)
    window.type("my spikes")
    window.picture("6-preset-name")
    window.keys("Return")
    window.wait("stored preset my spikes")
    window.click(RESET)
    window.wait("error extrude.solid: solid= is missing")
    window.click(PRESETS)
    time.sleep(0.5)
    window.picture("7-own-preset")
    window.keys("Down", "Down", "Return")  # below the entry that keeps values
    window.wait("preset my spikes")
    window.wait("adjusted extrude.solid faces=38")

    window.choose("face.start", "face.start")
    window.click(TOP_FACE)
    window.wait("applied face.start faces=38")
    window.picture("8-start-corner")
    window.export_save_and_close(folder)

    script = (folder / "history.druse").read_text().splitlines()
    check(len(script) == 3 and script[1].startswith("extrude.solid solid=dodecahedron heights=1,"), f"one extrusion should be recorded: {script}")
    stored = (folder / "config/druse/presets").read_text()
    check(stored.startswith('extrude.solid preset="my spikes" solid=dodecahedron heights=1,'), stored)
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.obj")
    ours, theirs = ((folder / f"{name}.obj").read_text().replace("window", "terminal") for name in ("window", "terminal"))
    check(ours == theirs, "the exported mesh is not the one that `druse apply` makes")


def groups(druse, folder, pictures):
    """The palette of groups, the brush and the smooth preview, by mouse; the history, and a recording, give the same again."""
    window = Window(druse, folder, pictures, ["--record", folder / "recording.txt", folder / "colored_cube.obj"])
    window.move(BESIDE_THE_MESH)
    plain = window.picture("1-plain")

    window.click(SIDE_FACE)
    window.click(SIDE_FACE)
    window.wait("applied select.faces")
    window.wait("applied select.faces")
    window.picture("2-group-selected")
    window.keys("Escape")
    window.wait("applied select.faces")

    window.move(BESIDE_THE_MESH)
    window.keys("s")
    window.wait("smooth faces=6144")
    window.wait("frame")
    smooth = window.picture("3-smooth")
    check(different_pixels(plain, smooth) > 20000, "the smooth preview should show")
    window.move(SIDE_FACE)
    window.picture("4-smooth-hover")
    window.move(BESIDE_THE_MESH)
    window.keys("s")
    window.wait("smooth off")
    window.picture("5-plain-again")

    # Rows 0, 1 and 2 are the bottom, the top and the four sides.
    window.press((SWATCH_X, group_row(1)))
    window.move((SWATCH_X + 6, group_row(1) - 8))
    window.move((SWATCH_X + 6, group_row(0)))
    window.picture("6-swatch-over-another")
    window.release()
    window.wait("applied group.merge")
    window.press((SWATCH_X, group_row(0)))
    window.move((SWATCH_X - 100, group_row(0) + 50))
    window.move(SIDE_FACE)
    window.wait("pressed face")
    window.picture("7-swatch-over-a-face")
    window.release()
    window.wait("applied group.assign")

    window.click(PAINT_BUTTON)
    window.wait("chosen group.assign")
    window.click((SWATCH_X + 60, group_row(1)))
    window.press(TOP_FACE)
    window.move(((TOP_FACE[0] + SIDE_FACE[0]) // 2, (TOP_FACE[1] + SIDE_FACE[1]) // 2))
    window.move(SIDE_FACE)
    window.picture("8-stroke")
    window.quiet("applied")
    window.release()
    window.wait("applied group.assign faces=6")
    window.press(TOP_FACE)
    window.keys("Escape")
    window.wait("click cancelled")
    window.release()
    window.quiet("applied")
    window.keys("Escape")
    window.wait("chosen nothing")

    # A brush over many faces, on the smooth surface.
    window.keys("ctrl+p")
    time.sleep(0.5)
    window.type("make.torus nu=48 nv=24")
    window.keys("Return")
    window.wait("applied make.torus")
    window.keys("Escape", "Home", "s")
    window.wait("smooth faces=")
    window.click(PAINT_BUTTON)
    window.wait("chosen group.assign")
    window.keys("period", "period", "period")
    window.press((500, 430))
    for x in range(500, 700, 20):
        window.move((x, 430 + (x - 500) // 2))
    window.picture("9-wide-stroke")
    window.release()
    window.wait("applied group.assign")
    window.picture("10-painted")

    window.export_save_and_close(folder)

    script = (folder / "history.druse").read_text().splitlines()
    steps = [line for line in script[1:] if not line.startswith("make.")]
    check(steps[1] == "select.faces faces=group:3", f"a double click should take the group: {script}")
    check(steps[3] == "group.merge ids=2,1 into=1", f"a swatch on another: {script}")
    check(steps[4] == "group.assign faces=2 id=1", f"a swatch on a face: {script}")
    check(steps[5] == "group.assign faces=1-2 id=3", f"one stroke over two faces: {script}")
    check(steps[-1].startswith("group.assign faces=") and steps[-1].count(",") > 10, f"many faces in one stroke: {script}")
    check(len([line for line in steps if line.startswith("group.")]) == 4, f"a command for each gesture: {script}")
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.obj")
    ours, theirs = ((folder / f"{name}.obj").read_text().replace("window", "terminal") for name in ("window", "terminal"))
    check(ours == theirs, "the exported mesh is not the one that `druse apply` makes")

    again = (folder / "recording.txt").read_text().replace("history.druse", "again.druse") + "wait saved\nquit\n"
    (folder / "again.txt").write_text(again)
    subprocess.run([str(druse), "--test", "--geometry", "1280x800+0+0", "--replay", str(folder / "again.txt"), str(folder / "colored_cube.obj")],
                   check=True, timeout=60, cwd=folder, env=dict(os.environ, HOME=str(folder)))
    check((folder / "again.druse").read_text().splitlines() == script, "a recording of the gestures should play back to the same history")


def rinds(druse, folder, pictures):
    """A crust, three holes and a peeled strip, each by a click; undone to the start bit for bit; the history gives the same again."""
    (folder / "torus.druse").write_text("make.torus nu=24 nv=12\n")
    run(druse, "apply", "-s", folder / "torus.druse", "-o", folder / "torus.obj")
    window = Window(druse, folder, pictures, [folder / "torus.obj"])

    def export(name, proposed="torus.stl"):
        window.keys("ctrl+e")
        window.answer_file_dialog("Export", folder / name, proposed)
        window.wait("exported " + str(folder / name))

    export("start.dlfl")
    window.choose("rind.crust", "crust")
    window.wait("safe thickness")
    window.click(APPLY)
    window.wait("applied rind.crust faces=576")
    window.picture("1-crust")
    y = row_middle(row_of(druse, "rind.crust", "thickness"))
    window.click((SLIDER[1] - 4, y))
    window.wait("adjusted rind.crust faces=576")
    window.wait("faces that meet: ")
    window.picture("2-too-thick")
    window.click(((SLIDER[0] + SLIDER[1]) // 2 + 12, y))
    window.wait("adjusted rind.crust faces=576")

    # A torus of 288 quads: a hole takes 2 faces and adds 4 walls. So does the first face of a strip; the others take the wall between them too.
    window.choose("rind.punch", "punch")
    for place, faces in zip(HOLES, (578, 580, 582)):
        window.press(place)
        check("outlined 2" in window.wait("pressed face"), "the faces of both surfaces should be outlined")
        window.release()
        window.wait(f"applied rind.punch faces={faces}")
    window.picture("3-punched")
    window.choose("rind.peel", "peel")
    for place in STRIP:
        window.click(place)
        window.wait("applied rind.peel faces=584")
    window.picture("4-peeled")
    window.click(INSIDE_THE_STRIP)
    window.quiet("applied")
    window.picture("5-no-rind")

    for name in ("window.obj", "window.dlfl"):
        export(name)
    window.keys("ctrl+shift+s")
    window.answer_file_dialog("Save as", folder / "history.druse", "torus.obj")
    window.wait("saved " + str(folder / "history.druse"))
    for faces in (584, 584, 582, 580, 578, 576, 288):
        window.keys("ctrl+z")
        window.wait(f"applied document.undo faces={faces}")
    export("undone.dlfl", "history.stl")
    window.close()

    script = (folder / "history.druse").read_text().splitlines()
    steps = [line.split()[0] for line in script[1:]]
    check(steps == ["rind.crust"] + 3 * ["rind.punch"] + 3 * ["rind.peel"], f"one step for the crust and for each click: {script}")
    check(all("faces=" in line and "," not in line for line in script[2:]), f"one face for each click: {script}")
    check((folder / "undone.dlfl").read_bytes() == (folder / "start.dlfl").read_bytes(), "undone, the model should be what it was")
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.obj", "-o", folder / "terminal.dlfl")
    for kind in ("obj", "dlfl"):
        ours, theirs = ((folder / f"{name}.{kind}").read_text().replace("window", "terminal") for name in ("window", "terminal"))
        check(ours == theirs, f"the exported .{kind} is not the one that `druse apply` makes")


def sculptures(druse, folder, pictures):
    """A tessellation, its map and struts of it, each in its panel with sliders that run it again; the history gives the same again."""
    window = Window(druse, folder, pictures, [])

    def slide(operator, row, x):
        window.click((x, row_middle(row)))
        window.wait("adjusted " + operator)

    window.move(BESIDE_THE_MESH)
    empty = window.picture("0-empty")
    window.choose("graph.tess")
    window.click(APPLY)
    window.wait("applied graph.tess")
    window.wait("frame")
    lines = window.picture("1-tessellation")
    check(different_pixels(empty, lines) > 2000, "the lines of the graph should show")
    slide("graph.tess", row_of(druse, "graph.tess", "layers"), SLIDER[0] + (SLIDER[1] - SLIDER[0]) // 6)  # 2 of 12
    window.wait("frame")
    check(different_pixels(lines, window.picture("2-fewer-layers")) > 1000, "the slider should run it again")

    window.choose("graph.map")
    window.click(((SLIDER[0] + SLIDER[1]) // 2, row_middle(0)))  # its choice is a menu
    window.keys("Down", "Down", "Down", "Down", "Return")
    window.wait("set to torus")
    window.click(APPLY)
    window.wait("applied graph.map")
    window.wait("frame")
    window.picture("3-torus")
    slide("graph.map", 1, SLIDER[1] - 20)  # its size: rows that do not concern a torus are not there

    window.choose("graph.struts")
    window.click(APPLY)
    window.wait("applied graph.struts faces=")
    window.wait("frame")
    window.picture("4-struts")
    slide("graph.struts", row_of(druse, "graph.struts", "radius"), SLIDER[0] + 10)
    window.picture("5-thinner")
    window.keys("ctrl+shift+s")
    window.answer_file_dialog("Save as", folder / "history.druse", "untitled.obj")
    window.wait("saved " + str(folder / "history.druse"))
    window.close()

    script = (folder / "history.druse").read_text().splitlines()
    names = [line.split()[0] for line in script]
    check(names == ["graph.tess", "graph.map", "graph.struts"], f"a step for each panel: {script}")
    check(script[0] == "graph.tess layers=2" and "to=torus" in script[1] and "size=" in script[1] and "radius=" in script[2], f"the sliders' values: {script}")
    facts = json.loads(run(druse, "info", folder / "history.druse", "--json"))
    # 5 times 112 vertices and 140 edges: the genus of the struts is that of the graph.
    check(facts["genus"] == 5 * 28 + 1 and facts["watertight"] and facts["graph"]["cycle_rank"] == 141, f"the struts of a torus: {facts}")


class TileEditor:
    """The tile editor of a program that was started at 1280 by 800: its plane on the left, the tile in space beside it."""

    LEFT, TOP, WIDTH, HEIGHT = 0, 66, (1280 - 256 - 2) // 2, 800 - 66 - 28

    def __init__(self, window, low, high):
        """The tile lies in the box from `low` to `high` when it is framed, with 0.45 of its size around it."""
        self.window = window
        self.main = window.id
        self.id = run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "Tile editor$").split()[0]
        window.id = self.id
        self.middle = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2)
        self.scale = min(self.WIDTH / ((high[0] - low[0]) * 1.9), self.HEIGHT / ((high[1] - low[1]) * 1.9))

    def place(self, x, y):
        """Where a place of the plane is seen."""
        return (round(self.LEFT + self.WIDTH / 2 + (x - self.middle[0]) * self.scale), round(self.TOP + self.HEIGHT / 2 - (y - self.middle[1]) * self.scale))

    def drag(self, start, end, steps=8):
        self.window.press(start)
        for i in range(1, steps + 1):
            self.window.move((start[0] + (end[0] - start[0]) * i // steps, start[1] + (end[1] - start[1]) * i // steps))
            time.sleep(0.05)
        self.window.release()

    def raise_point(self, seen, pixels):
        """Drags a point in space upward; `seen` is the line of the event log that says where it is."""
        x, y = (int(number) for number in seen.split()[-1].split(","))
        self.drag((x, y), (x, y - pixels))

    def enter(self, text):
        """Types into the first field of the panel, which runs its operator."""
        self.window.click(TILE_FIELD)
        self.window.keys("ctrl+a")
        self.window.type(text)
        self.window.keys("Return")

    def choose(self, druse, operator, current=None):
        """In the list over the panel, which opens at the current operator."""
        listed = json.loads(run(druse, "ops", "--json"))
        operators = [op["name"] for op in (listed if isinstance(listed, list) else listed["operators"])]
        tile_operators = [name for name in operators if name.startswith("tile.")]
        self.window.click(TILE_CHOICE)
        time.sleep(0.3)
        self.window.keys(*["Down"] * (tile_operators.index(operator) - (tile_operators.index(current) if current else -1)), "Return")
        self.window.wait("tile: chosen " + operator)

    def save_as(self, file, proposed="untitled.tile"):
        self.window.keys("ctrl+shift+s")
        self.window.answer_file_dialog("Save as", file, proposed)
        self.window.wait("tile: saved " + str(file))


def tiles(druse, folder, pictures):
    """A tile from type to solid in its editor, all by the mouse; the exported file is that of `druse apply` with the history; undone to the start."""
    main = Window(druse, folder, pictures, [])
    main.click(BESIDE_THE_MESH)
    main.keys("F6")
    main.wait("tile: frame")
    editor = TileEditor(main, (0, 0), (20, 10))  # corners (10,10) (0,0) (20,0)
    place, drag = editor.place, editor.drag

    main.click(TILE_TYPE)
    run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Tile type$")
    time.sleep(1)
    main.keys(*["Down"] * 7, *["Right"] * 7)  # from IH01, 9 in a row
    main.picture("1-types")
    main.keys("Return")
    main.wait("tile: applied tile.new")
    main.wait("tile: frame")

    main.click(place(5, 5))  # the middle of a leg
    main.wait("tile: applied tile.edge_add")
    drag(place(5, 5), place(6, 3))
    main.wait("tile: adjusted tile.edge_move")
    main.click(place(11, 4))
    main.wait("tile: applied tile.point_add")
    main.picture("2-plane")
    main.keys("F3")  # heights: the panel asks for a thickness first
    main.wait("tile: chosen tile.extrude")
    editor.enter("5")
    main.wait("tile: applied tile.extrude")
    main.click(place(11, 4))
    editor.raise_point(main.wait("tile: selected i0 seen at "), 40)
    main.wait("tile: adjusted tile.height")
    main.picture("3-relief")
    main.keys("F4")
    drag(place(10, 4), place(20.2, 13.9), 12)
    main.wait("tile: applied tile.stack")
    time.sleep(0.5)
    main.picture("4-stack")
    main.keys("ctrl+e")
    run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Export tile$")
    time.sleep(0.5)
    main.picture("5-export")
    main.keys("Return")
    main.wait("tile: applied tile.solid")
    main.wait("took exported tile")

    main.id = editor.main
    main.wait("frame")
    main.click(BESIDE_THE_MESH)
    main.picture("6-main")
    main.keys("ctrl+e")
    main.answer_file_dialog("Export", folder / "window.stl", "untitled.stl")
    main.wait("exported")
    main.keys("ctrl+shift+s")
    main.answer_file_dialog("Save as", folder / "history.druse", "untitled.obj")
    main.wait("saved")
    main.keys("F6")
    time.sleep(0.5)
    main.id = editor.id
    main.click(place(24, 12))  # beside the tile: nothing is there to act on but the plane
    steps = (folder / "history.druse").read_text().splitlines()
    for _ in steps:
        main.keys("ctrl+z")
        main.wait("tile: applied document.undo")
    main.keys("ctrl+z")
    main.wait("tile: error document.undo")
    main.picture("7-undone")
    main.close()

    names = [line.split()[0] for line in steps]
    check(names == ["tile." + name for name in ("new", "edge_add", "edge_move", "point_add", "extrude", "height", "stack", "solid")],
          f"a step for each gesture: {steps}")
    check(steps[0] == "tile.new type=IH79 size=20" and steps[6] == "tile.stack mode=shift offset=10,10", f"the type, and the offset of a whole leg: {steps}")
    facts = json.loads(run(druse, "info", folder / "history.druse", "--json"))
    check(facts["watertight"] and facts["genus"] == 0 and abs(facts["volume"] - 500) < 1e-6, f"an area of 100, 5 thick: {facts['volume']}")
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.stl")
    check((folder / "window.stl").read_bytes() == (folder / "terminal.stl").read_bytes(), "the exported file is not the one that `druse apply` makes")


def make_tile(druse, folder, name, *commands):
    run(druse, "apply", *[word for command in commands for word in ("-c", command)], "-o", folder / name)
    return folder / name


def tile_edits(druse, folder, pictures):
    """Constraints, refusals, tracing, corners, removal, heights of many points and layers; the tile that is saved is that of `druse apply`."""
    start = make_tile(druse, folder, "start.tile", "tile.new type=IH41 size=20", "tile.point_add at=5,12", "tile.point_add at=15,12", "tile.point_add at=10,16")
    run("convert", "-size", "60x40", "gradient:#ff8000-#004080", "-depth", "8", "-define", "png:color-type=2", folder / "drawing.png")
    window = Window(druse, folder, pictures, [start])
    editor = TileEditor(window, (0, 0), (20, 20))
    place, drag = editor.place, editor.drag

    window.move(place(5, 12))  # keys are for the window under the pointer
    window.keys("c")
    drag(place(5, 12), place(15, 12))
    window.wait("tile: applied tile.constrain")
    window.click(place(10, 0))
    window.wait("tile: applied tile.edge_add")
    window.press(place(10, 0))  # at once to where the outline would cut the line
    window.move(place(10, 14))
    refused = window.wait("tile: error tile.edge_move")
    window.picture("1-refused")
    window.release()
    check("outside: the line from i0 to i1" in refused, f"why not: {refused}")
    window.quiet("tile: applied")
    drag(place(10, 0), place(10, 6))
    window.wait("tile: adjusted tile.edge_move")
    window.keys("c")
    drag(place(0, 0), place(20, 0))  # straight across the dent
    refused = window.wait("tile: error tile.constrain")
    window.picture("2-refused-line")
    check("outside" in refused, f"why not: {refused}")
    drag(place(20, 0), place(21, 2))
    window.wait("tile: adjusted tile.corner")
    window.click(place(10, 16))
    window.wait("tile: selected i2")
    window.keys("Delete")
    window.wait("tile: applied tile.point_remove")

    window.keys("p")
    window.answer_file_dialog("Tracing image", folder / "drawing.png")
    time.sleep(1)
    window.picture("3-tracing")
    window.keys("Return")
    window.wait("tile: applied tile.trace")

    window.keys("F3")
    window.wait("tile: chosen tile.extrude")
    editor.enter("6")
    window.wait("tile: applied tile.extrude")
    drag(place(2, 9), place(17, 15))  # a box around the ends of the line
    window.wait("tile: selected i0,i1")
    window.keys("Escape")
    window.wait("tile: selected nothing")
    window.keys("F2")
    window.click(place(5, 12))
    seen = window.wait("tile: selected i0 seen at ")
    window.keys("b")
    drag(place(2, 9), place(17, 15))
    window.wait("tile: selected i0,i1")
    editor.raise_point(seen, 30)  # one of them takes the other along
    window.wait("tile: adjusted tile.height")
    window.picture("4-heights")
    editor.choose(druse, "tile.assemble", "tile.extrude")
    editor.enter("2")
    window.wait("tile: applied tile.assemble")
    window.wait("tile: frame")
    window.picture("5-layers")
    window.move(place(5, 12))
    editor.save_as(folder / "window.tile", "start.tile")
    editor.save_as(folder / "history.druse", "window.tile")
    steps = (folder / "history.druse").read_text().splitlines()
    for _ in steps[1:]:
        window.keys("ctrl+z")
        window.wait("tile: applied document.undo")
    window.keys("ctrl+z")
    window.wait("tile: error document.undo")
    editor.save_as(folder / "undone.tile", "history.tile")
    window.close()

    names = [line.split()[0] for line in steps]
    check(names == ["document.open"] + ["tile." + name for name in ("constrain", "edge_add", "edge_move", "corner", "point_remove", "trace", "extrude", "height", "assemble")],
          f"a step for each gesture, and none for what was refused: {steps}")
    check("image=drawing.png" in steps[6] and "points=i0,i1" in steps[8], f"a name beside the script, and both points: {steps}")
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.tile")
    check((folder / "window.tile").read_bytes() == (folder / "terminal.tile").read_bytes(), "the tile is not the one that `druse apply` makes")
    tile = json.loads((folder / "window.tile").read_text())
    check(tile["view"]["trace"]["image"] == "drawing.png" and tile["heights"]["i0"] == tile["heights"]["i1"] > 0, f"the picture, and heights that go together: {tile}")
    check((folder / "undone.tile").read_bytes() == start.read_bytes(), "undone, the tile should be what it was")


def tile_replay(druse, folder, pictures):
    """What was done in the tile editor, dialogs too, plays back to the same tile and the same mesh."""
    start = make_tile(druse, folder, "start.tile", "tile.new type=IH79 size=20", "tile.extrude thickness=5")
    window = Window(druse, folder, pictures, ["--record", folder / "recording.txt", start])
    editor = TileEditor(window, (0, 0), (20, 10))
    window.click(editor.place(11, 4))
    window.wait("tile: applied tile.point_add")
    editor.raise_point(select_again(window, editor.place(11, 4)), 30)
    window.wait("tile: adjusted tile.height")
    editor.choose(druse, "tile.stack")
    window.move(editor.place(24, 12))
    window.keys("ctrl+e")
    run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Export tile$")
    time.sleep(0.5)
    window.keys("Return")
    window.wait("took exported tile")  # the main window is in front now
    window.id = editor.main
    window.move(BESIDE_THE_MESH)
    window.keys("F6")
    time.sleep(0.5)
    window.id = editor.id
    window.move(editor.place(24, 12))
    editor.save_as(folder / "first.tile", "start.tile")
    window.close()

    recording = (folder / "recording.txt").read_text()
    check("tile: push" in recording and "tile: run tile.solid" in recording and "tile: hand over" in recording, f"too little was recorded:\n{recording}")
    again = recording.replace("first.tile", "second.tile") + f"wait tile: saved\ntile: shot {pictures / 'replayed.png'}\nexport {folder / 'second.obj'}\nwait exported\ntile: quit\nquit\n"
    (folder / "again.txt").write_text(again)
    subprocess.run([str(druse), "--test", "--geometry", "1280x800+0+0", "--replay", str(folder / "again.txt"), str(start)],
                   check=True, timeout=60, cwd=folder, env=dict(os.environ, HOME=str(folder)))
    first, second = (folder / "first.tile").read_text(), (folder / "second.tile").read_text()
    check(first == second and '"i0"' in first, f"the tiles differ:\n{first}\n{second}")
    check((folder / "second.obj").read_text().count("\nf ") == 12, "the main window has not the mesh")


def numbers(text):
    return tuple(float(number) for number in text.split(","))


class CellEditor:
    """The cell editor of a program that was started at 1280 by 800."""

    def __init__(self, window):
        self.window = window
        self.main = window.id
        self.id = run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "Cell editor$").split()[0]
        window.id = self.id

    def open_pane(self, place):
        """By a right click in space. The event log says which one it is, and where it is on the left."""
        self.window.click(place, 3)
        words = self.window.wait("cell: pane ").split()
        check(words[2] != "none", "the right click should be on a pane")
        self.middle, self.scale = numbers(words[5]), float(words[7])
        return int(words[2]), words[3]

    def place(self, x, y):
        """Where a place of the pane is seen."""
        return (round(self.middle[0] + x * self.scale), round(self.middle[1] - y * self.scale))

    def drag(self, start, by, steps=8):
        self.window.press(start)
        for i in range(1, steps + 1):
            self.window.move((start[0] + by[0] * i // steps, start[1] + by[1] * i // steps))
            time.sleep(0.05)
        self.window.release()

    @staticmethod
    def seen(line, word):
        """The pixel that a line of the event log says after a word."""
        words = line.split()
        check(word in words, f"no '{word}' in '{line}'")
        return tuple(int(number) for number in words[words.index(word) + (1 if word == "at" else 2)].split(","))


def cells(druse, folder, pictures):
    """A cell from its kind to its solid in its editor, all by the mouse; what is exported is what `druse apply` makes of the history, and what the recording does again."""
    main = Window(druse, folder, pictures, ["--record", folder / "recording.txt"])
    main.click(BESIDE_THE_MESH)
    main.keys("F7")
    main.wait("cell: frame")
    editor = CellEditor(main)

    main.click(CELL_KIND)
    run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Cell$")
    time.sleep(1)
    main.picture("1-kinds")
    main.keys("Right", "Return")
    main.wait("cell: applied cell.new")
    main.wait("cell: frame")
    main.picture("2-cell")

    pane, side = editor.open_pane(CELL_NEAR)
    main.wait("cell: frame")
    main.click(editor.place(0, 0))
    main.wait("cell: applied cell.point_add")
    main.click(editor.place(0, 2.5))
    main.wait("cell: applied cell.point_add")
    main.keys("c")
    editor.drag(editor.place(0, 0), (0, round(-2.5 * editor.scale)))
    main.wait("cell: applied cell.constrain")
    main.move(CELL_NEAR)
    main.picture("3-pane")

    main.keys("F3")
    main.wait("cell: applied cell.shape")
    main.keys("z")  # the arrow is not seen end on
    main.click(CELL_NEAR)
    picked = main.wait(f"cell: selected p{pane}:i0 at ")
    start, partner, tip = editor.seen(picked, "seen"), editor.seen(picked, "opposite"), editor.seen(picked, "arrow")
    check(abs(start[0] - CELL_NEAR[0]) <= 1 and partner[0] > 910, f"the point in the middle, and its partner in the second view: {picked}")
    main.picture("4-shape")
    editor.drag(((start[0] + tip[0]) // 2, (start[1] + tip[1]) // 2), (0, -40))  # by the arrow
    main.wait("cell: adjusted cell.move")
    along = main.wait(f"cell: selected p{pane}:i0 at ")
    check(editor.seen(along, "seen")[1] < start[1] - 25, f"the point should go up: {picked}, {along}")
    check(editor.seen(along, "opposite")[1] < partner[1] - 25, f"the opposite pane should follow: {picked}, {along}")
    editor.drag(editor.seen(along, "seen"), (30, 40))  # by the point itself, in the plane of the pane
    main.wait("cell: adjusted cell.move")
    moved = main.wait(f"cell: selected p{pane}:i0 at ")
    check(editor.seen(moved, "seen")[0] > start[0] + 20, f"the point should go to the right: {along}, {moved}")
    main.picture("5-moved")

    words = [line for line in main.lines() if line.startswith("cell: skew ")][-1].split()
    handle = tuple(int(number) for number in words[words.index("zz") + 1].split(","))
    editor.drag(handle, (8, -20))
    main.wait("cell: adjusted cell.skew")
    main.wait("cell: cell fits")
    main.keys("n")  # the neighbours
    main.picture("6-skewed")
    main.keys("ctrl+e")
    run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Export cell$")
    time.sleep(0.5)
    main.picture("7-export")
    main.keys("Return")
    main.wait("cell: applied cell.solid")
    main.wait("took exported cell")

    main.id = editor.main
    main.wait("frame")
    main.click(BESIDE_THE_MESH)
    main.keys("ctrl+e")
    main.answer_file_dialog("Export", folder / "window.stl", "untitled.stl")
    main.wait("exported")
    main.keys("ctrl+shift+s")
    main.answer_file_dialog("Save as", folder / "history.druse", "untitled.obj")
    main.wait("saved")
    main.close()

    steps = (folder / "history.druse").read_text().splitlines()
    check([line.split()[0] for line in steps] == ["cell." + name for name in ("new", "point_add", "point_add", "constrain", "shape", "move", "move", "skew", "solid")],
          f"a step for each gesture: {steps}")
    check(steps[0] == "cell.new cell=fcc size=20" and "along=z" in steps[5] and "plane=" in steps[6], f"the second cell, the arrow and the plane: {steps}")
    facts = json.loads(run(druse, "info", folder / "history.druse", "--json"))
    check(facts["watertight"] and facts["genus"] == 0, f"a closed solid: {facts}")
    run(druse, "apply", "-s", folder / "history.druse", "-o", folder / "terminal.stl", "-o", folder / "cell.tile")
    check((folder / "window.stl").read_bytes() == (folder / "terminal.stl").read_bytes(), "the exported file is not the one that `druse apply` makes")
    cell = json.loads((folder / "cell.tile").read_text())
    m = cell["matrix"]
    volume = 2000 * (m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]))
    check(m != [1, 0, 0, 0, 1, 0, 0, 0, 1] and abs(facts["volume"] - volume) < 1e-6 * volume, f"a quarter of 20³, skewed: {facts['volume']}, {m}")

    recording = (folder / "recording.txt").read_text()
    check("cell: run cell.new" in recording and "cell: push" in recording and "cell: hand over" in recording, f"too little was recorded:\n{recording}")
    (folder / "again.txt").write_text(recording.replace("window.stl", "again.stl") + "cell: quit\nquit\n")
    subprocess.run([str(druse), "--test", "--geometry", "1280x800+0+0", "--replay", str(folder / "again.txt")],
                   check=True, timeout=60, cwd=folder, env=dict(os.environ, HOME=str(folder)))
    check((folder / "again.stl").read_bytes() == (folder / "window.stl").read_bytes(), "the recording makes another cell")


def cell_views(druse, folder, pictures):
    """A cell from a file: what Escape, boxes and right clicks mean, the two views, and what is asked before a pane is flat again."""
    commands = ["cell.new cell=cube size=20", *(f"cell.point_add pane={pane} at=0,0" for pane in range(3)), "cell.shape"]
    window = Window(druse, folder, pictures, [make_tile(druse, folder, "start.tile", *commands)])
    window.wait_anywhere("cell: frame")
    editor = CellEditor(window)
    pane, side = editor.open_pane(CELL_NEAR)
    check((pane, side) == editor.open_pane(CELL_FAR), "a pane that is clicked in the opposite view stays there, and this one where it is")
    everything = "c0,p0:i0,p1:i0,p2:i0"
    window.keys("a")
    window.wait(f"cell: selected {everything} at ")
    window.picture("1-all")
    window.keys("Escape")
    window.wait("cell: selected nothing")

    window.press(CELL_NEAR)
    window.move((CELL_NEAR[0] + 20, CELL_NEAR[1]))
    window.wait("cell: applied cell.move")
    window.keys("ctrl+z", "F2")  # wait for the end of the drag
    window.release()
    window.quiet("cell: applied")
    window.keys("ctrl+z")
    window.wait("cell: applied document.undo")
    window.keys("Escape")
    window.wait("cell: selected nothing")

    window.move(CELL_FAR)
    window.keys("b")
    editor.drag((CELL_NEAR[0] - 180, CELL_NEAR[1] - 210), (4, 8), 4)  # the box is for the other view
    window.quiet("cell: selected")
    editor.drag((CELL_FAR[0] - 180, CELL_FAR[1] - 210), (360, 420))
    window.wait("cell: selected c0,")
    window.keys("Escape")
    window.wait("cell: selected nothing")

    editor.open_pane(CELL_NEAR)  # both turn back
    window.keys("d")
    window.wait("cell: frame")
    window.click(CELL_NEAR)
    picked = window.wait(f"cell: selected p{pane}:i0 at ")
    check(abs(editor.seen(picked, "opposite")[0] - CELL_NEAR[0]) <= 3, f"the opposite view should be on the left: {picked}")
    window.keys("d", "shift+d")
    window.wait("cell: frame")
    single = ((CELL_NEAR[0] + CELL_FAR[0]) // 2, CELL_NEAR[1])
    window.picture("2-single")
    window.click(single)
    picked = window.wait(f"cell: selected p{pane}:i0 at ")
    check(abs(editor.seen(picked, "seen")[0] - single[0]) <= 3, f"the one view should take all the room: {picked}")
    window.keys("shift+d", "Escape", "l")
    window.wait("cell: selected nothing")
    editor.drag((CELL_NEAR[0] - 180, CELL_NEAR[1] - 210), (60, 40))  # turns that view alone
    window.click(CELL_FAR)
    picked = window.wait(f"cell: selected p{pane}:i0 at ")
    check(abs(editor.seen(picked, "opposite")[0] - CELL_FAR[0]) <= 3, f"the opposite view should be as it was: {picked}")
    window.picture("3-apart")

    window.keys("l", "1", "F6")  # upright again
    window.wait("cell: frame")
    window.click((CELL_NEAR[0] + 40, CELL_NEAR[1] + 40))  # on the way from the point to a corner
    window.wait("cell: applied cell.flip")
    window.keys("F4")
    pane, side = editor.open_pane(CELL_NEAR)
    window.keys("F2")
    time.sleep(0.7)
    window.picture("4-question")
    window.keys("Escape")
    window.quiet("cell: applied")
    window.keys("F2")
    time.sleep(0.7)
    window.keys("Return")
    window.wait(f"cell: run cell.rollback pane={pane}")
    window.wait("cell: applied cell.rollback")
    window.keys("ctrl+z", "ctrl+z")  # nothing is unsaved
    window.wait("cell: applied document.undo")
    window.wait("cell: applied document.undo")

    (folder / "solid.druse").write_text("\n".join(commands + ["cell.solid"]) + "\n")
    window.keys("ctrl+o")
    window.answer_file_dialog("Open", folder / "solid.druse")
    window.wait("cell: opened")
    window.wait("cell: frame")
    window.click(CELL_NEAR, 3)
    window.wait("cell: shows the cell")
    editor.open_pane(CELL_NEAR)
    window.close()


def select_again(window, place):
    """Where a point is seen in space that is clicked in the plane."""
    window.click(place)
    return window.wait("tile: selected i0 seen at ")


def replay(druse, folder, pictures):
    """A recording plays back to the same history."""
    window = Window(druse, folder, pictures, ["--record", folder / "recording.txt", folder / "colored_cube.obj"])
    window.choose("extrude.cubical")
    window.click(TOP_FACE)
    window.wait("applied extrude.cubical faces=10")
    y = row_middle(row_of(druse, "extrude.cubical", "angle"))
    window.click((SLIDER[0] + 30, y))
    window.wait("adjusted extrude.cubical")
    window.choose("extrude.solid", "any solid")
    window.click(PANEL_PICTURE)  # what is chosen in dialogs and menus is recorded, not the way there
    run("timeout", "10", "xdotool", "search", "--sync", "--onlyvisible", "--name", "^Solids$")
    window.keys("Home", "Right", "Return")
    window.wait("set solid cube")
    window.click(SIDE_FACE)
    window.wait("applied extrude.solid faces=26")  # the 4 sides, 4 walls each
    window.press(BESIDE_THE_MESH)
    window.move((400, 640))
    window.release()
    window.keys("ctrl+shift+s")
    window.answer_file_dialog("Save as", folder / "first.druse", "colored_cube.obj")
    window.wait("saved")
    window.close()

    recording = (folder / "recording.txt").read_text()
    check("push" in recording and "release" in recording and "save " in recording, f"too little was recorded:\n{recording}")
    again = recording.replace("first.druse", "second.druse") + f"wait saved\nshot {pictures / 'replayed.png'}\nquit\n"
    (folder / "again.txt").write_text(again)
    subprocess.run([str(druse), "--test", "--geometry", "1280x800+0+0", "--replay", str(folder / "again.txt"), str(folder / "colored_cube.obj")],
                   check=True, timeout=60, cwd=folder, env=dict(os.environ, HOME=str(folder)))
    first, second = (folder / "first.druse").read_text(), (folder / "second.druse").read_text()
    check(first == second, f"the histories differ:\n{first}\n{second}")
    check((pictures / "replayed.png").stat().st_size > 1000, "no picture of the replay")

    (folder / "wrong.txt").write_text("wait ready\n# the next line is number 3\nmenu No/Such\n")
    failed = subprocess.run([str(druse), "--test", "--geometry", "1280x800+0+0", "--replay", str(folder / "wrong.txt"), str(folder / "colored_cube.obj")],
                            timeout=60, cwd=folder, env=dict(os.environ, HOME=str(folder)), capture_output=True, text=True)
    check(failed.returncode == 2, f"a recording that cannot be played ends with {failed.returncode}")
    check("wrong.txt:3: no menu entry 'No/Such'" in failed.stderr, failed.stderr)


def sizes(druse, folder, pictures):
    """The window fits its least and its usual size, and can be drawn larger."""
    for name, geometry, arguments in (("least", "960x640+0+0", []), ("usual", "1280x800+0+0", []), ("scaled", "1280x800+0+0", ["--ui-scale", "1.25"])):
        window = Window(druse, folder, pictures, arguments + [folder / "star.obj"], geometry)
        shape = run("xdotool", "getwindowgeometry", "--shell", window.id)
        width, height = geometry.split("+")[0].split("x")
        check(f"WIDTH={width}" in shape and f"HEIGHT={height}" in shape, f"{name}: {shape}")
        window.picture(name)
        window.close()


def main():
    scenario, druse, models, pictures = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4]) / sys.argv[1]
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir(parents=True)
    known = {f.__name__: f for f in (click_and_export, cancel, dialogs, solids, groups, rinds, sculptures, tiles, tile_edits, tile_replay, cells, cell_views, replay, sizes)}
    with tempfile.TemporaryDirectory() as folder:
        try:
            folder = pathlib.Path(folder).resolve()
            for model in models.iterdir():
                shutil.copy(model, folder)
            known[scenario](druse, folder, pictures)
        except Failure as failure:
            log = folder / "events.txt"
            print(f"{scenario}: {failure}", file=sys.stderr)
            if log.exists():
                print("event log:\n" + log.read_text(), file=sys.stderr)
            print(f"pictures: {pictures}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
