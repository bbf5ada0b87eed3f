# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files and tables in other spellings: each means the same, so the body and its answer must be the same."""
import meshes
from job import Job
from mutation import pick
from verdict import figures

CASE = """subsection Study
  set kind = linear static
  set output folder = out
end
subsection Model
  set bodies = a
  set constraints = foot
  set loads = top, end
  subsection Body a
    set mesh = file
    set file = {file}
  end
  subsection Constraint foot
    set kind = fixed
    set nodes = {fixed}
    set where = z < 1e-9
  end
  subsection Load top
    set kind = pressure
    set nodes = {top}
    set pressure = 10 MPa
  end
  subsection Load end
    set kind = force
    set nodes = {half}
    set force = 3, 5, 0 N
    set history = table.csv
  end
end
subsection Output
  set report = no
end
"""
TABLE = [(0.0, 0.75), (1e-3, 1.5), (2.5e-3, -2.0)]


def any_case(rng, word):
    return pick(rng, [str.lower, str.upper, str.title, lambda text: text])(word)


def number(rng, text):
    """A coordinate in another way of writing."""
    return pick(rng, [f"{float(text):.3e}", f"{float(text):.4E}".replace("E", "D"), f"{float(text):+.2f}", f"{float(text):.1f}d0"])


def change_ends(rng, text):
    return pick(rng, [text.replace("\n", "\r\n"), text.replace("\n", "\r"), "\ufeff" + text, text + "\n\n"])


# Of .inp: each takes and gives a list of blocks (keyword line, data lines).

def case_of_letters(rng, blocks):
    return [(any_case(rng, keyword), [any_case(rng, row) for row in rows]) for keyword, rows in blocks]


def blanks(rng, blocks):
    return [("  " * rng.randrange(2) + keyword.replace(",", pick(rng, [" ,", ", ", ","])),
             [row.replace(",", pick(rng, [" , ", ",", ",  "])) for row in rows]) for keyword, rows in blocks]


def comments(rng, blocks):
    return [(keyword, [line for row in rows for line in ([row, pick(rng, ["** 1, 2, 3", "", "**"])] if rng.random() < 0.2
                                                         else [row])]) for keyword, rows in blocks]


def continued(rng, blocks):
    return [(keyword.replace(", ", ",\n  ", 1) if rng.random() < 0.5 else keyword, rows) for keyword, rows in blocks]


def coordinates(rng, blocks):
    return [(keyword, [", ".join([cells[0], *(number(rng, cell) for cell in cells[1:])])
                       for cells in (row.split(", ") for row in rows)] if keyword.startswith("*NODE") else rows)
            for keyword, rows in blocks]


def two_lines(rng, blocks):
    def cut(row):
        cells = row.split(", ")
        place = rng.randrange(2, len(cells))
        return [", ".join(cells[:place]) + ",", ", ".join(cells[place:])]
    return [(keyword, [line for row in rows for line in cut(row)] if "C3D8" in keyword else rows) for keyword, rows in blocks]


def other_kind(rng, blocks):
    kind = pick(rng, ["C3D8R", "C3D8I", "C3D8H", "C3D8RH", "C3D8T", "C3D8RT", "C3D8P", "SC8R"])
    return [(keyword.replace("C3D8", kind), rows) for keyword, rows in blocks]


def set_of_sets(rng, blocks):
    """A set is made of two parts, the second of which names the first."""
    result = []
    for keyword, rows in blocks:
        what = "NSET" if keyword.startswith("*NSET") else "ELSET"
        members = ", ".join(rows).split(", ")
        if not keyword.startswith((f"*{what}",)) or len(members) < 3 or "GENERATE" in keyword:
            result.append((keyword, rows))
            continue
        cut = rng.randrange(1, len(members))
        result.append((f"*{what}, {what}=PART_OF_IT{len(result)}, INTERNAL", [", ".join(members[:cut])]))
        result.append((keyword, [", ".join(["part_of_it" + str(len(result) - 1), *members[cut:]])]))
    return result


def ranges(rng, blocks):
    """Sets of numbers in a row are generated."""
    result = []
    for keyword, rows in blocks:
        members = ", ".join(rows).split(", ")
        numbers = [int(member) for member in members if member.isdigit()]
        steps = {b - a for a, b in zip(numbers, numbers[1:])}
        if keyword.startswith(("*NSET", "*ELSET")) and len(numbers) == len(members) and len(steps) == 1 and min(steps) > 0:
            result.append((keyword + ", GENERATE", [f"{numbers[0]}, {numbers[-1]}, {min(steps)}"]))
        else:
            result.append((keyword, rows))
    return result


def other_numbers(rng, blocks):
    """Nodes get other numbers."""
    shift = rng.randrange(1, 1000)
    result = []
    for keyword, rows in blocks:
        if keyword.startswith("*NODE"):
            rows = [f"{int(row.split(', ')[0]) + shift}, {row.split(', ', 1)[1]}" for row in rows]
        elif keyword.startswith("*ELEMENT"):
            rows = [", ".join([row.split(", ")[0], *(str(int(n) + shift) for n in row.split(", ")[1:])]) for row in rows]
        elif keyword.startswith("*NSET"):
            rows = [", ".join(str(int(n) + shift) for n in row.split(", ")) for row in rows]
        result.append((keyword, rows))
    return result


def moved_system(rng, blocks):
    """Coordinates about another origin, given by *SYSTEM."""
    x, y, z = (rng.randrange(-20, 20) for _ in range(3))
    result = []
    for keyword, rows in blocks:
        if keyword.startswith("*NODE"):
            result.append(("*SYSTEM", [f"{x}, {y}, {z}"]))
            rows = [f"{n}, {float(a) - x}, {float(b) - y}, {float(c) - z}" for n, a, b, c in (row.split(", ") for row in rows)]
        result.append((keyword, rows))
    return result


def instance(rng, blocks):
    """The file is a part, placed by an instance that undoes a motion of its nodes."""
    x, y, z = (rng.randrange(-20, 20) for _ in range(3))
    moved = []
    for keyword, rows in blocks:
        if keyword.startswith("*NODE"):  # turned by -90 degrees about z, then moved
            rows = [f"{n}, {float(b) - x}, {-float(a) - y}, {float(c) - z}" for n, a, b, c in (row.split(", ") for row in rows)]
        moved.append((keyword, rows))
    return [("*Heading", ["a part"]), ("*Part, name=P", []), *moved, ("*End Part", []), ("*Assembly, name=A", []),
            ("*Instance, name=I, part=p", [f"{x}, {y}, {z}", "0., 0., 0., 0., 0., 2., 90."]), ("*End Instance", []),
            ("*End Assembly", []), ("*Step", []), ("*Static", ["1., 1."]), ("*End Step", [])]


# In the order in which they are done: later ones write texts that earlier ones do not look for.
INP = (other_numbers, moved_system, other_kind, ranges, set_of_sets, instance, coordinates, two_lines, continued, comments,
       blanks, case_of_letters)


def inp_blocks(nodes, cells, faces):
    def row(numbers):
        return ", ".join(map(str, numbers))
    return [("*NODE, NSET=NALL", [row([k, *node]) for k, node in enumerate(nodes, 1)]),
            ("*ELEMENT, TYPE=C3D8, ELSET=EALL", [row([k, *cell]) for k, cell in enumerate(cells, 1)]),
            ("*NSET, NSET=FIX", [row(range(1, 10))]),
            ("*ELSET, ELSET=TOPMOST", [row(range(len(cells) - 3, len(cells) + 1))]),
            ("*NSET, NSET=HALF", [row(range(len(nodes) - 8, len(nodes) + 1, 2))]),
            ("*SURFACE, NAME=TOP, TYPE=ELEMENT", ["TOPMOST, S2"])]


def spell_inp(rng, blocks, n):
    chosen = {INP[rng.randrange(len(INP))] for _ in range(n)}
    if instance in chosen:
        chosen.discard(moved_system)  # both move the nodes
    order = [one for one in INP if one in chosen]
    for one in order:
        blocks = one(rng, blocks)
    return ", ".join(one.__name__ for one in order), "\n".join("\n".join([keyword, *rows]) for keyword, rows in blocks) + "\n"


def spell_vtk(rng, nodes, cells, faces):
    new = rng.random() < 0.5
    voxels = rng.random() < 0.3
    both = [[cell[i] for i in (0, 1, 3, 2, 4, 5, 7, 6)] for cell in cells] if voxels else list(cells)
    both = [[n - 1 for n in cell] for cell in both + faces["top"]]
    ids = ["1"] * len(cells) + ["2"] * len(faces["top"])
    lines = [any_case(rng, "# vtk DataFile Version ") + ("5.1" if new else "3.0"), pick(rng, ["", "a block", "ASCII", "BINARY"]),
             any_case(rng, "ASCII"), any_case(rng, "DATASET") + " UNSTRUCTURED_GRID"]
    if rng.random() < 0.3:
        lines += ["FIELD FieldData 1", "TIME 1 1 double", "0.5"]
    lines += [f"POINTS {len(nodes)} double", *(" ".join(number(rng, str(x)) for x in node) for node in nodes)]
    if new:
        ends = [0]
        for cell in both:
            ends.append(ends[-1] + len(cell))
        lines += ["METADATA", "INFORMATION 0", "", f"CELLS {len(ends)} {ends[-1]}", "OFFSETS vtktypeint64", " ".join(map(str, ends)),
                  "CONNECTIVITY vtktypeint64", *(" ".join(map(str, cell)) for cell in both)]
    else:
        lines += [f"CELLS {len(both)} {sum(len(cell) + 1 for cell in both)}",
                  *(f"{len(cell)} {' '.join(map(str, cell))}" for cell in both)]
    lines += [f"CELL_TYPES {len(both)}", *(["11"] if voxels else ["12"]) * len(cells), *["9"] * len(faces["top"])]
    if rng.random() < 0.3:
        lines += [f"POINT_DATA {len(nodes)}", "VECTORS u float", *["0 nan 1"] * len(nodes)]
    name = pick(rng, ["MaterialID", "material", "mat_id", "RegionId", "gmsh:physical", "CellEntityIds"])
    lines.append(f"CELL_DATA {len(both)}")
    if rng.random() < 0.5:
        lines += ["FIELD FieldData 2", f"other 1 {len(both)} double", " ".join(["0.25"] * len(both)),
                  f"{name} 1 {len(both)} {pick(rng, ['int', 'double', 'vtktypeint64'])}", " ".join(ids)]
    else:
        lines += [f"SCALARS {name} {pick(rng, ['int', 'int 1', 'double 1'])}", *pick(rng, [["LOOKUP_TABLE default"], []]), *ids]
    return f"version {'5.1' if new else '3.0'}, {'voxels, ' if voxels else ''}ids {name}", "\n".join(lines) + "\n"


def spell_msh(rng, write, block):
    lines = [str(line) for line in write(*block)]
    if rng.random() < 0.5:
        place = lines.index("$Nodes")
        lines[place:place] = ["$Comments", "any text $Nodes", "$EndComments"]
    if write is meshes.write_msh_2 and rng.random() < 0.5:
        # Each element of a second group once more.
        begin = lines.index("$Elements")
        count = int(lines[begin + 1])
        more = [line.split() for line in lines[begin + 2:begin + 2 + count] if line.split()[1] == "5"][::2]
        lines[-1:-1] = [" ".join([str(count + k), "5", "2", "7", *words[4:]]) for k, words in enumerate(more, 1)]
        lines[begin + 1] = str(count + len(more))
    return write.__name__, "\n".join(lines) + "\n"


def spell_table(rng):
    unit, factor = pick(rng, [("s", 1), ("ms", 1e3), ("us", 1e6)])
    divider = pick(rng, [",", ";", "\t", " ", ", "])
    lines = [divider.join([f"{time * factor:.4e}".replace("e", pick(rng, ["e", "E", "D", "d"])), f"{value:+.2f}"]) for time, value in TABLE]
    if unit != "s" or rng.random() < 0.5:
        lines.insert(0, pick(rng, [f"time [{unit}]{divider}factor", f"# time [{unit}]{divider}factor", f"Time ({unit}){divider}factor [-]"]))
    if rng.random() < 0.3:
        lines.insert(0, pick(rng, ["measured by hand", "# a comment", ""]))
    return change_ends(rng, "\n".join(lines) + "\n") if rng.random() < 0.6 else "\n".join(lines) + "\n"


class Seeds:
    def __init__(self, runner, folder):
        folder.mkdir()
        self.block = meshes.make_block()
        # One answer for all formats: that of the plainest file.
        self.write(folder, "plain.inp", spell_inp(None, inp_blocks(*self.block), 0)[1], "".join(f"{t},{v}\n" for t, v in TABLE))
        self.figures = figures(runner.run_good(folder, "case.prm"))

    @staticmethod
    def write(folder, file, text, table):
        (folder / file).write_bytes(text.encode())
        (folder / "table.csv").write_bytes(table.encode())
        named = file.endswith(".inp") and not text.lstrip("\ufeff# \n")[:1].isdigit()
        names = {"fixed": "fix" if named else "all", "top": "TOP" if named else "top" if file.endswith(".msh") else "boundary 2",
                 "half": "half" if named else "all"}
        case = CASE.format(file=file, **names)
        # Without node sets the nodes of HALF are found by their places.
        if not named:
            case = case.replace("set force", "set where = z > 2.9 && (abs(x - 1.5) + abs(y - 2) < 0.1 || "
                                             "abs(abs(x - 1.5) - 1.5) + abs(abs(y - 2) - 2) < 0.1)\n    set force")
        (folder / "case.prm").write_text(case)

    def make(self, rng, folder):
        how = rng.randrange(6)
        if how < 3:
            file = "mesh.inp"
            note, text = spell_inp(rng, inp_blocks(*self.block), rng.randrange(1, 6))
        elif how == 3:
            file = "mesh.vtk"
            note, text = spell_vtk(rng, *self.block)
        elif how == 4:
            file, note = pick(rng, ["mesh.ucd", "mesh.inp"]), "ucd"
            text = "\n".join(map(str, meshes.write_ucd(self.block[0], [[c[i] for i in (0, 1, 5, 4, 3, 2, 6, 7)] for c in self.block[1]],
                                                       self.block[2]))) + "\n"
        else:
            file = "mesh.msh"
            note, text = spell_msh(rng, pick(rng, [meshes.write_msh_2, meshes.write_msh_4]), self.block)
        if rng.random() < 0.4:
            text = change_ends(rng, text)
        self.write(folder, file, text, spell_table(rng))
        return Job(folder, ["case.prm"], f"{file}: {note}", same=self.figures)
