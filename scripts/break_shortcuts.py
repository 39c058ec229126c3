#!/usr/bin/env python3
"""Breaks each shortcut in turn and looks whether the contract test notices, and names it.

    scripts/break_shortcuts.py build/dev [NAME...]

The build folder holds a finished build of agreement_tests (Ninja, gcc or clang). Nothing in the source folder changes: the broken
file stands in a folder of its own that is searched first. Each shortcut costs one compilation of core/fast/kernels.cpp, about a
minute. Ends with status 1 if a broken shortcut was not noticed.
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

FAST = "core/fast/"
# shortcut: file below core/fast, what stands there, what stands there when it is broken
BREAKS = {
    "lanes": ("lanes/depth_test-inl.h", "hn::Set(F64(), x + 0.5)", "hn::Set(F64(), x + 0.75)"),
    "windows": ("windows/windows-inl.h", "i < windows; ++i", "i + 1 < windows; ++i"),
    "large-triangles": ("large_triangles/large_triangle-inl.h",
                        "(1u << (static_cast<unsigned>(right) / kSide))", "(2u << (static_cast<unsigned>(right) / kSide))"),
    "wide-tiles": ("lanes/half_space-inl.h", "wideHalfPlanesOf(triangle, left, top), left, top}",
                   "wideHalfPlanesOf(triangle, left, top), left + 1, top}"),
    "tile-planes": ("tile_planes/tile_plane-inl.h", "isCovered && visible.isWholeTile(here)", "visible.isWholeTile(here)"),
    "stacked-depths": ("lanes/shade-inl.h", "rankOf(std::max(*key, background))", "rankOf(*key + 0 * background)"),
    "shared-sides": ("shared_sides/shared_sides.h", "places[columns[1][t]]", "places[columns[0][t]]"),
    "patched-batches": ("visit/submitted-inl.h", "return patched ? patched->of(mesh) :",
                        "return patched ? (mesh.value == 0 ? patched->of(mesh) : stripe.scene.batchesOf(MeshId{0})) :"),
    "facing-cones": ("visit/submitted-inl.h", "&& backs.mayHold(place.batch.cone) && backs.hold(place.batch.cone, view(place.batch.bounds))",
                     "&& backs.mayHold(place.batch.cone)"),
    "patch-reach": ("visit/submitted-inl.h", "stripe.region()).patches()", "stripe.region()).patches() & ~PatchBits{1}"),
    "stored-tiles": ("large_triangles/large_triangle-inl.h", "hn::Load(f32, nearest.data() + i) < hn::LoadU(f32, stored + i)",
                     "hn::LoadU(f32, stored + i) < hn::Load(f32, nearest.data() + i)"),
    "two-level-pyramid": ("two_level_pyramid/wide_pyramid-inl.h", "if (!orElse(x + std::countr_zero(open), y)) return false;",
                          "if (!orElse(x + std::countr_zero(open), y)) return true;"),
    "hidden-squares": ("hidden_squares/hidden_squares-inl.h", "uppers > hn::Set(d, nearest)", "uppers < hn::Set(d, nearest)"),
    "node-balls": ("visit/front_to_back-inl.h", "node.radius * placed.view.longest()", "node.radius * 0.4 * placed.view.longest()"),
    "skipped-questions": ("visit/front_to_back-inl.h", "isAsked(placed, node, above))) return Verdict::Entered;",
                          "isAsked(placed, node, above))) return m_occlusion.asksNodes ? Verdict::Hidden : Verdict::Entered;"),
    "nearest-node": ("visit/front_to_back-inl.h", "if (!placed.tree.ownItems(node).empty()) drawItems(node, next.open);", ""),
    "whole-nodes": ("visit/front_to_back-inl.h", "isWhole ? placed.tree.allBatchesOf(node, mesh) :",
                    "isWhole ? placed.tree.batchesOf(node, mesh) :"),
    "nearest-triangle": ("visit/front_to_back-inl.h", "all.add(m_consume(m_scratch.triangles));",
                         "if (m_scratch.triangles.startsNearest) m_scratch.triangles.kind[0] |= TriangleList::kHidden;\n"
                         "            all.add(m_consume(m_scratch.triangles));"),
}


def run(command, folder, **more):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, **more)


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    build = pathlib.Path(sys.argv[1]).resolve()
    names = sys.argv[2:] or list(BREAKS)
    entry = next(e for e in json.loads((build / "compile_commands.json").read_text()) if e["file"].endswith("core/fast/kernels.cpp"))
    compile_command = shlex.split(entry["command"])
    link = run(["ninja", "-t", "commands", "agreement_tests"], build).stdout.strip().splitlines()[-1]
    link = next(part for part in link.split("&&") if " -o " in part)
    unnoticed = []
    for name in names:
        file, right, wrong = BREAKS[name]
        text = (root / FAST / file).read_text()
        if text.count(right) != 1:
            pattern = re.compile(r"\s+".join(re.escape(word) for word in right.split()))
            if len(pattern.findall(text)) != 1:
                sys.exit(f"{name}: {file} does not hold this once: {right}")
            broken = pattern.sub(lambda _: wrong, text)
        else:
            broken = text.replace(right, wrong)
        with tempfile.TemporaryDirectory() as folder:
            overlay = pathlib.Path(folder) / "overlay"
            target = overlay / FAST / file
            target.parent.mkdir(parents=True)
            target.write_text(broken)
            kernels = f"{folder}/kernels.o"
            command = [part for part in compile_command if part != "-Werror" and not part.endswith("ccache")]
            command[command.index("-o") + 1] = kernels
            command[1:1] = [f"-iquote{overlay}", f"-I{overlay}"]
            compiled = run(command, entry["directory"])
            if compiled.returncode:
                sys.exit(f"{name}: the broken text does not compile:\n{compiled.stderr[-2000:]}")
            parts = shlex.split(link)
            library = next(part for part in parts if part.endswith("libzscope_core.a"))
            copy = f"{folder}/libzscope_core.a"
            subprocess.run(["cp", str(build / library), copy], check=True)
            subprocess.run(["ar", "d", copy, "kernels.cpp.o"], check=True)
            subprocess.run(["ar", "r", copy, kernels], check=True, capture_output=True)
            parts = [copy if part == library else part for part in parts]
            parts[parts.index("-o") + 1] = f"{folder}/tests"
            linked = run(parts, build)
            if linked.returncode:
                sys.exit(f"{name}: cannot link:\n{linked.stderr[-2000:]}")
            found = ""
            for test in ("NoneAloneAndNoneLeftOutChangesABit", "NoSetOfShortcutsChangesABit"):
                out = run([f"{folder}/tests", f"--gtest_filter=ShortcutContract.{test}"], root).stdout
                said = re.search(r"[^\n]* with the shortcuts ([^\n]*)", out)
                if said:
                    found = said.group(0).strip()
                    break
            isNamed = name in found
            print(f"{name}: {'noticed' if found else 'NOT NOTICED'}{', and named' if isNamed else ''}: {found}", flush=True)
            if not found or not isNamed:
                unnoticed.append(name)
    print(f"{len(names) - len(unnoticed)} of {len(names)} broken shortcuts were noticed by name")
    return 1 if unnoticed else 0


sys.exit(main())
