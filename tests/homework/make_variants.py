#!/usr/bin/env python3
"""Makes the renderers of variants.json: make_variants.py FOLDER [NAME...]

FOLDER/NAME holds the edited sources and an executable file "render": render SCENE.obj CAMERA.json FOLDER. So FOLDER may be
graded like the homework of a class. Needs a compiler for C++17 (the variable CXX, else c++).
"""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
KIT = HERE.parent.parent / "assets" / "homework"
SOLUTION = HERE / "solution"
COMPILE = [os.environ.get("CXX", "c++"), "-std=c++17", "-O1", "-ffp-contract=off"]


def sources():
    """The kit's files, with the solution's in place of those with gaps."""
    files = {file.name: file for file in sorted(KIT.iterdir()) if file.suffix in (".h", ".cpp")}
    files.update({file.name: file for file in sorted(SOLUTION.iterdir())})
    return files


def edited(text, variant):
    for old, new in variant["edits"]:
        if text.count(old) != 1:
            sys.exit("%s: '%s' is %d times in %s" % (variant["name"], old, text.count(old), variant["file"]))
        text = text.replace(old, new)
    return text


def compile_file(source, into, include):
    subprocess.run(COMPILE + ["-c", str(source), "-I", str(include), "-o", str(into)], check=True)
    return into


def make_cpp(variant, folder, objects):
    files = sources()
    for name, file in files.items():
        shutil.copy(file, folder / name)
    changed = folder / variant["file"]
    changed.write_text(edited(changed.read_text(encoding="utf-8"), variant), encoding="utf-8")
    own = dict(objects)
    own[changed.name] = compile_file(changed, folder / "changed.o", folder)
    subprocess.run(COMPILE + [str(o) for o in own.values()] + ["-o", str(folder / "homework")], check=True)
    (folder / "changed.o").unlink()
    return 'exec "$here/homework" "$1" "$2" "$3" %s' % variant["run"]


def make_python(variant, folder, _):
    source = HERE / "solution_python" / variant["file"]
    (folder / variant["file"]).write_text(edited(source.read_text(encoding="utf-8"), variant), encoding="utf-8")
    return 'exec python3 "$here/%s" "$1" "$2" "$3" %s' % (variant["file"], variant["run"])


def make(variant, folder, objects):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    command = {"cpp": make_cpp, "python": make_python}[variant["language"]](variant, folder, objects)
    script = folder / "render"
    script.write_text('#!/bin/sh\nhere=$(dirname "$0")\n%s\n' % command.rstrip(), encoding="utf-8")
    script.chmod(0o755)


def main(words):
    if not words:
        sys.exit("usage: make_variants.py FOLDER [NAME...]")
    variants = json.loads((HERE / "variants.json").read_text(encoding="utf-8"))["variants"]
    wanted = [v for v in variants if len(words) == 1 or v["name"] in words[1:]]
    top = pathlib.Path(words[0])
    shared = top / ".objects"
    shared.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = {}
        if any(v["language"] == "cpp" for v in wanted):
            jobs = {name: pool.submit(compile_file, file, shared / (name + ".o"), KIT)
                    for name, file in sources().items() if file.suffix == ".cpp"}
            objects = {name: job.result() for name, job in jobs.items()}
        for job in [pool.submit(make, v, top / v["name"], objects) for v in wanted]:
            job.result()
    shutil.rmtree(shared)


if __name__ == "__main__":
    main(sys.argv[1:])
