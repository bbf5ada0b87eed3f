# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of mesh files in all formats that are read: small blocks, those of meshes/, and exported gears."""
from itertools import product

from job import ROOT, Job
from mutation import NUMBERS, mutate_text, pick

CASE = """subsection Study
  set kind = linear static
end
subsection Model
  set bodies = a
  subsection Body a
    set mesh = file
    set file = {file}
  end
end
"""
COUNTS = (2, 2, 3)  # cells of the small block along x, y, z
ORDER = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
SMALL_GEAR = [f"--set={entry}" for entry in (
    "Gear pair/Pinion/Mesh/elements along face width=2", "Gear pair/Gear/Mesh/elements along face width=2",
    "Gear pair/Pinion/Mesh/elements along profile=1", "Gear pair/Gear/Mesh/elements along profile=1", "Gear pair/Pinion/Mesh/elements through rim=1",
    "Gear pair/Gear/Mesh/elements through rim=1", "Export/flank points lengthwise=3", "Export/flank points profile=3")]
WORDS = ["$Nodes", "$EndNodes", "$Elements", "$EndElements", "$Entities", "$EndEntities", "$MeshFormat", "$PhysicalNames",
         "$EndPhysicalNames", "4.1 0 8", "2.2 0 8", "4.1 1 8", "1 2 3 4", "8 5 8 1", "0 0 0 0", "*NODE", "*ELEMENT, TYPE=C3D8",
         "*ELEMENT, TYPE=C3D4", "*NSET, NSET=A, GENERATE", "1, 99999999999, 1", "1, 1000000000, 1", "*ELSET, ELSET=ALL",
         "*SURFACE, NAME=A", "1, S7", "1, S1", "*INCLUDE, INPUT=mesh.inp", "*", "**", "*,", "*NODE, =", "CELLS 3 27",
         "CELL_TYPES 3", "POINTS 36 float", "DATASET STRUCTURED_GRID", "ASCII", "BINARY", "CELL_DATA 12", "SCALARS a int 1",
         "LOOKUP_TABLE default", "hex", "tet", "quad", "12", "9", "POINT_DATA 36", "36 12 0 0 0", "*NODE, SYSTEM=C",
         "*SYSTEM", "*NGEN", "*ELGEN, ELSET=ALL", "1, 2, 3, 4, 5", "*ELCOPY, OLD SET=ALL, CHANGE NUMBER=100", "*PART, NAME=P",
         "*END PART", "*INSTANCE, NAME=I, PART=P", "*END INSTANCE", "*NSET, NSET=B, ELSET=ALL", "*SURFACE, NAME=B, TYPE=NODE",
         "ALL,", "*ELEMENT, TYPE=SC8R", "*SHELL SECTION, ELSET=SHELL", "*STEP", "*MATERIAL, NAME=M", "*TIE", "OFFSETS vtktypeint64",
         "CONNECTIVITY vtktypeint64", "METADATA", "FIELD FieldData 1", "mat_id 1 12 int", "LOOKUP_TABLE a 4", *NUMBERS]


def make_block():
    """Nodes and hexahedra (numbers from 1, VTK's order of corners), quadrilaterals of both ends."""
    nodes = [(1.5 * i, 2.0 * j, 1.0 * k) for k, j, i in product(*(range(n + 1) for n in reversed(COUNTS)))]

    def number(i, j, k):
        return 1 + i + (COUNTS[0] + 1) * (j + (COUNTS[1] + 1) * k)

    cells = [[number(i + a, j + b, k + c) for a, b, c in ORDER]
             for k, j, i in product(*(range(n) for n in reversed(COUNTS)))]
    faces = {side: [[number(i + a, j + b, k) for a, b, _ in ORDER[:4]] for j, i in product(range(COUNTS[1]), range(COUNTS[0]))]
             for side, k in (("bottom", 0), ("top", COUNTS[2]))}
    return nodes, cells, faces


def write_msh_2(nodes, cells, faces):
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "4", '0 1 "corner"', '2 1 "bottom"', '2 2 "top"',
             '3 1 "all"', "$EndPhysicalNames", "$Nodes", len(nodes)]
    lines += [f"{k} {x} {y} {z}" for k, (x, y, z) in enumerate(nodes, 1)]
    elements = ["15 2 1 1 1"] + [f"3 2 {k} {k} {' '.join(map(str, face))}" for k, side in enumerate(faces, 1)
                                 for face in faces[side]]
    elements += [f"5 2 1 1 {' '.join(map(str, cell))}" for cell in cells]
    lines += ["$EndNodes", "$Elements", len(elements), *(f"{k} {text}" for k, text in enumerate(elements, 1)), "$EndElements"]
    return lines


def write_msh_4(nodes, cells, faces):
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "4", '0 1 "corner"', '2 1 "bottom"', '2 2 "top"',
             '3 1 "all"', "$EndPhysicalNames", "$Entities", "1 0 2 1", "1 0 0 0 1 1", "1 0 0 0 3 4 0 1 1 0",
             "2 0 0 3 3 4 3 1 2 0", "1 0 0 0 3 4 3 1 1 2 1 2", "$EndEntities", "$Nodes", f"2 {len(nodes)} 1 {len(nodes)}",
             "0 1 0 1", "1", " ".join(map(str, nodes[0])), f"3 1 0 {len(nodes) - 1}"]
    lines += [*range(2, len(nodes) + 1), *(" ".join(map(str, node)) for node in nodes[1:]), "$EndNodes", "$Elements"]
    n_faces = len(faces["top"])
    lines += [f"4 {1 + 2 * n_faces + len(cells)} 1 {1 + 2 * n_faces + len(cells)}", "0 1 15 1", "1 1"]
    number = 1
    for k, side in enumerate(faces, 1):
        lines.append(f"2 {k} 3 {n_faces}")
        for face in faces[side]:
            number += 1
            lines.append(f"{number} {' '.join(map(str, face))}")
    lines.append(f"3 1 5 {len(cells)}")
    for cell in cells:
        number += 1
        lines.append(f"{number} {' '.join(map(str, cell))}")
    return lines + ["$EndElements"]


def write_inp(nodes, cells, faces):
    lines = ["** a block", "*NODE, NSET=NALL", *(f"{k}, {x}, {y}, {z}" for k, (x, y, z) in enumerate(nodes, 1)),
             "*ELEMENT, TYPE=C3D8, ELSET=ALL", *(f"{k}, {', '.join(map(str, cell))}" for k, cell in enumerate(cells, 1)),
             "*ELEMENT, TYPE=S4, ELSET=SHELL"]
    lines += [f"{100 + k}, {', '.join(map(str, face))}" for k, face in enumerate(faces["top"])]
    return lines + ["*NSET, NSET=LOW, GENERATE", "1, 9, 1", "*NSET, NSET=SOME", "1, 2, 3", "LOW", "*ELSET, ELSET=FIRST", "1, 2",
                    "*SURFACE, NAME=BELOW, TYPE=ELEMENT", "FIRST, S1", "3, S1", "*MATERIAL, NAME=STEEL", "*ELASTIC",
                    "206000, 0.29"]


def write_vtk(nodes, cells, faces):
    lines = ["# vtk DataFile Version 3.0", "a block", "ASCII", "DATASET UNSTRUCTURED_GRID", f"POINTS {len(nodes)} double"]
    lines += [" ".join(map(str, node)) for node in nodes]
    both = cells + faces["top"]
    lines += [f"CELLS {len(both)} {sum(len(cell) + 1 for cell in both)}"]
    lines += [f"{len(cell)} {' '.join(str(n - 1) for n in cell)}" for cell in both]
    lines += [f"CELL_TYPES {len(both)}", *[12] * len(cells), *[9] * len(faces["top"]), f"CELL_DATA {len(both)}",
              "SCALARS MaterialID int 1", "LOOKUP_TABLE default", *[1] * len(cells), *[2] * len(faces["top"])]
    return lines


def write_ucd(nodes, cells, faces):
    both = [f"1 hex {' '.join(map(str, cell))}" for cell in cells] + [f"2 quad {' '.join(map(str, f))}" for f in faces["top"]]
    return [f"{len(nodes)} {len(both)} 0 0 0", *(f"{k} {x} {y} {z}" for k, (x, y, z) in enumerate(nodes, 1)),
            *(f"{k} {text}" for k, text in enumerate(both, 1))]


class Seeds:
    def __init__(self, runner, folder):
        folder.mkdir()
        block = make_block()
        self.small = {}
        for name, write in (("two.msh", write_msh_2), ("four.msh", write_msh_4), ("block.inp", write_inp),
                            ("block.vtk", write_vtk), ("block.ucd", write_ucd)):
            self.small[name] = ("\n".join(map(str, write(*block))) + "\n").encode()
            # The blocks themselves must be good: a mutant of a bad file shows little.
            (folder / name).write_bytes(self.small[name])
            (folder / "case.prm").write_text(CASE.format(file=name))
            runner.run_good(folder, "case.prm", "--check")
        runner.run_good(folder, str(ROOT / "prm/spiral_bevel_mesh.prm"), "-o", "gears", *SMALL_GEAR)
        self.large = {path.name: path.read_bytes() for path in sorted((ROOT / "meshes").glob("*.msh"))}
        self.large.update({path.name: path.read_bytes() for path in sorted((folder / "gears").glob("pinion.*"))
                           if path.suffix in (".msh", ".inp")})

    def make(self, rng, folder):
        seeds = self.small if rng.random() < 0.85 else self.large
        name = pick(rng, sorted(seeds))
        note, content = mutate_text(rng, seeds[name], WORDS)
        file = "mesh" + name[name.index("."):]
        (folder / file).write_bytes(content)
        (folder / "case.prm").write_text(CASE.format(file=file))
        return Job(folder, ["case.prm", "--check"], f"{name}: {note}", names=(file,))
