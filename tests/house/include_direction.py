#!/usr/bin/env python3
"""The one rule of the house: a folder includes only what stands above it, and strangers never meet.

Reads every #include of the tree (and every link between floors in CMake), and fails on each arrow that runs the
wrong way. `--self-test` proves that it can fail.
"""

import pathlib
import re
import sys

# Each floor and the floors it may include, besides itself. Strangers (rbf, contour, ...) do not name one another.
ABOVE = {
    "core/base": [],
    "core/implicit": ["core/base"],
    "core/mesh": ["core/base"],
    "core/image": ["core/base"],
}
GROUND = ["core/base", "core/implicit", "core/mesh", "core/image"]
STRANGERS = ["core/rbf", "core/contour", "core/polygonize", "core/raytrace", "core/particles"]
for floor in STRANGERS:
    ABOVE[floor] = GROUND
lower = GROUND + STRANGERS
for floor in ["core/modelling", "core/scene", "core/editing", "core/window"]:
    ABOVE[floor] = list(lower)
    lower.append(floor)
# Programs may include all of core, and themselves, but never each other.
PROGRAMS = ["sandbox2d", "sandbox3d", "figures", "cli", "python", "bench"]
for floor in PROGRAMS:
    ABOVE[floor] = list(lower)
ABOVE["tests"] = lower + PROGRAMS

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
# Heavy libraries that only one place may see.
ONLY_IN = {
    "cairo": ["core/image"],
    "stb_image": ["core/image"],
    "xsimd/": ["core/rbf", "bench"],
    "lapack": ["core/rbf", "bench"],
    "cblas": ["core/rbf", "bench"],
    "assimp/": ["core/mesh"],
    "meshoptimizer": ["core/mesh"],
    "embree": ["core/raytrace"],
    "nlohmann/": ["core/scene", "cli", "figures", "python", "tests"],
    "SDL": ["core/window"],
    "epoxy/": ["core/window"],
    "imgui": ["core/window"],
    "CLI/": ["cli", "figures", "sandbox2d", "sandbox3d"],
}


def floor_of(path):
    """The longest floor name that `path` (relative, with slashes) lies in, or None."""
    parts = path.split("/")
    for name in ("/".join(parts[:2]), parts[0]):
        if name in ABOVE:
            return name
    return None


def faults_of(path, text):
    """A line of words for every include of the file that breaks the rule."""
    mine = floor_of(path)
    if mine is None:
        return []
    faults = []
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, target = match.groups()
        where = f"{path}:{number}: "
        if quote == '"':
            if target.startswith("."):
                faults.append(where + f'"{target}": name the file from the top folder')
                continue
            theirs = floor_of(target)
            if theirs is None:
                faults.append(where + f'"{target}" lies on no floor of the house')
            elif theirs != mine and theirs not in ABOVE[mine]:
                faults.append(where + f"{mine} may not include {theirs}")
        for library, places in ONLY_IN.items():
            if target.startswith(library) and mine not in places:
                faults.append(where + f"<{target}> may be seen only in {', '.join(places)}")
    return faults


def self_test():
    wrong = [
        ("core/rbf/a.h", '#include "core/contour/contour.h"'),
        ("core/contour/a.h", '#include "core/rbf/kernel.h"'),
        ("core/base/a.h", '#include "core/implicit/field.h"'),
        ("core/scene/a.h", '#include "cli/main.h"'),
        ("core/mesh/a.h", '#include "core/image/canvas.h"'),
        ("core/scene/a.h", "#include <cairo.h>"),
        ("core/rbf/a.h", '#include "../base/types.h"'),
        ("core/rbf/a.h", '#include "rbf/kernel.h"'),
    ]
    right = [
        ("core/rbf/a.h", '#include "core/implicit/field.h"\n#include <vector>'),
        ("core/scene/a.h", '  #  include "core/rbf/kernel.h"'),
        ("cli/main.cpp", '#include "core/scene/document.h"'),
    ]
    for path, text in wrong:
        assert faults_of(path, text), f"not caught: {path}: {text}"
    for path, text in right:
        assert not faults_of(path, text), f"wrongly caught: {path}: {text}"


def main():
    self_test()
    top = pathlib.Path(sys.argv[1])
    faults, count = [], 0
    for folder in sorted({name.split("/")[0] for name in ABOVE}):
        for file in sorted((top / folder).rglob("*")):
            if file.suffix in {".h", ".cpp", ".inc"}:
                count += 1
                path = file.relative_to(top).as_posix()
                faults += faults_of(path, file.read_text(encoding="utf-8"))
    print("\n".join(faults) or f"{count} files, every arrow runs the right way")
    sys.exit(1 if faults or count == 0 else 0)


if __name__ == "__main__":
    main()
