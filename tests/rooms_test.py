#!/usr/bin/env python3
"""Holds every #include of src/ against the table of rooms: includes point from a room to itself or to those it may use."""

import pathlib
import re
import sys

MAY_INCLUDE = {
    "geom": [],
    "dlfl": ["geom"],
    "graph": ["dlfl", "geom"],
    "pane": ["dlfl", "geom"],
    "tile": ["pane", "dlfl", "geom"],
    "cell": ["pane", "dlfl", "geom"],
    "ops": ["cell", "tile", "pane", "graph", "dlfl", "geom"],
    "io": ["cell", "tile", "pane", "graph", "dlfl", "geom"],
    "app": ["ops", "io", "cell", "tile", "pane", "graph", "dlfl", "geom"],
    "render": ["graph", "dlfl", "geom"],
    "ui": ["app", "render", "ops", "io", "cell", "tile", "pane", "graph", "dlfl", "geom"],
    "cli": ["ui", "app", "render", "ops", "io", "cell", "tile", "pane", "graph", "dlfl", "geom"],
}

# Libraries that belong to some rooms only.
LIBRARIES = [
    (re.compile(r"FL/"), {"ui"}, "FLTK"),
    (re.compile(r"(GL|KHR|GLES\d?|EGL)/"), {"render", "ui"}, "OpenGL"),
    (re.compile(r"X11/"), {"ui"}, "X11"),
    (re.compile(r"CGAL/"), {"geom"}, "CGAL"),
    (re.compile(r"png(conf)?\.h"), {"io", "render"}, "libpng"),
    (re.compile(r"CLI/"), {"cli"}, "CLI11"),
]

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def complaints(source: pathlib.Path):
    for file in sorted(source.rglob("*")):
        if file.suffix not in (".h", ".cpp"):
            continue
        room = file.relative_to(source).parts[0]
        if room not in MAY_INCLUDE:
            yield f"{file}: there is no room '{room}'"
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            kind, name = match.groups()
            where = f"{file}:{number}: {room} includes {name}"
            if kind == '"':
                target = name.split("/")[0]
                if not (source / name).is_file():
                    yield f"{where}: not a file under src/, named from there"
                elif target != room and target not in MAY_INCLUDE[room]:
                    yield f"{where}: {room} may include {', '.join(MAY_INCLUDE[room]) or 'no other room'}"
            else:
                for pattern, rooms, library in LIBRARIES:
                    if pattern.match(name) and room not in rooms:
                        yield f"{where}: {library} belongs to {', '.join(sorted(rooms))}"


def main():
    source = pathlib.Path(__file__).resolve().parent.parent / "src"
    found = list(complaints(source))
    print("\n".join(found) or f"every #include under {source} points the right way")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
