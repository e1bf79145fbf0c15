#!/usr/bin/env python3
"""The one rule of the house: a folder includes only what stands above it, and strangers never meet.

Reads every #include of the tree and every link between floors in its CMakeLists.txt, and fails on each arrow that
runs the wrong way; and on a heavy library outside its place. First it shows on made-up files that it can fail.
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

TOP_FOLDERS = {name.split("/")[0] for name in ABOVE}

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
# Those that whoever includes a header of core must not need.
NOT_IN_HEADERS_OF_CORE = ["nlohmann/"]

# In a CMakeLists.txt: the floors after USES, up to the next word in capitals, and what is linked by its name.
USES = re.compile(r"\bUSES\s+([^A-Z)]*)")
LINKS = re.compile(r"\btarget_link_libraries\s*\(\s*\S+([^)]*)\)")


def floor_of(path):
    """The longest floor name that `path` (relative, with slashes) lies in, or None."""
    parts = path.split("/")
    for name in ("/".join(parts[:2]), parts[0]):
        if name in ABOVE:
            return name
    return None


def faults_of(path, text):
    """A line of words for everything in the file that breaks the rule."""
    mine = floor_of(path)
    if mine is None:
        return []
    return faults_of_links(path, mine, text) if path.endswith(".txt") else faults_of_includes(path, mine, text)


def faults_of_includes(path, mine, text):
    faults = []
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, target = match.groups()
        where = f"{path}:{number}: "
        if quote == '"' or target.split("/")[0] in TOP_FOLDERS:
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
        for library in NOT_IN_HEADERS_OF_CORE:
            if target.startswith(library) and path.startswith("core/") and not path.endswith(".cpp"):
                faults.append(where + f"<{target}> may not be in a header of core")
    return faults


def floor_of_library(name):
    """The floor whose library is seesaw_`name`, or None."""
    return next((floor for floor in (f"core/{name}", name) if floor in ABOVE), None)


def faults_of_links(path, mine, text):
    faults = []
    text = re.sub(r"#.*", "", text)
    names = [name for words in USES.findall(text) for name in words.split()]
    names += [name for words in LINKS.findall(text) for name in re.findall(r"\bseesaw_(\w+)", words)]
    for name in names:
        theirs = floor_of_library(name)
        if theirs and theirs != mine and theirs not in ABOVE[mine]:
            faults.append(f"{path}: {mine} may not link {theirs}")
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
        ("core/rbf/a.h", "#include <core/contour/contour.h>"),
        ("core/contour/a.cpp", "#include <core/rbf/fit.h>"),
        ("core/rbf/a.h", "#include <core/attic/a.h>"),
        ("core/scene/a.cpp", "#include <figures/figure.h>"),
        ("core/scene/a.h", "#include <nlohmann/json.hpp>"),
        ("core/scene/a.inc", "#include <nlohmann/json_fwd.hpp>"),
        ("core/rbf/a.cpp", "#include <nlohmann/json.hpp>"),
        ("core/rbf/CMakeLists.txt", "seesaw_library(rbf SOURCES a.cpp\n  USES base contour\n  PRIVATE x)"),
        ("core/scene/CMakeLists.txt", "seesaw_library(scene\n  USES base\n    editing)"),
        ("core/rbf/CMakeLists.txt", "target_link_libraries(seesaw_rbf PUBLIC x\n  seesaw_contour)"),
        ("sandbox2d/CMakeLists.txt", "seesaw_program(sandbox2d USES figures)"),
    ]
    right = [
        ("core/rbf/a.h", '#include "core/implicit/field.h"\n#include <vector>'),
        ("core/scene/a.h", '  #  include "core/rbf/kernel.h"'),
        ("cli/main.cpp", '#include "core/scene/document.h"'),
        ("core/scene/a.h", "#include <core/rbf/kernel.h>\n#include <base/elsewhere.h>"),
        ("core/scene/a.cpp", "#include <nlohmann/json.hpp>"),
        ("figures/a.h", "#include <nlohmann/json.hpp>"),
        ("core/rbf/CMakeLists.txt", "seesaw_library(rbf SOURCES contour.cpp USES base\n  PRIVATE SeesawDeps::simd)"),
        ("core/rbf/CMakeLists.txt", "# USES contour\ntarget_link_libraries(seesaw_rbf PRIVATE seesaw_flags)"),
        ("cli/CMakeLists.txt", "seesaw_program(seesaw USES scene PRIVATE SeesawDeps::json)"),
    ]
    for path, text in wrong:
        assert faults_of(path, text), f"not caught: {path}: {text}"
    for path, text in right:
        assert not faults_of(path, text), f"wrongly caught: {path}: {text}"


def main():
    self_test()
    top = pathlib.Path(sys.argv[1])
    faults, count = [], 0
    for folder in sorted(TOP_FOLDERS):
        for file in sorted((top / folder).rglob("*")):
            if file.suffix in {".h", ".cpp", ".inc"} or file.name == "CMakeLists.txt":
                count += 1
                path = file.relative_to(top).as_posix()
                faults += faults_of(path, file.read_text(encoding="utf-8"))
    print("\n".join(faults) or f"{count} files, every arrow runs the right way")
    sys.exit(1 if faults or count == 0 else 0)


if __name__ == "__main__":
    main()
