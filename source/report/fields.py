# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of a run: reads the .vtu files as the program writes them, without VTK."""
import base64
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}


def read_array(element):
    """Numbers of a DataArray: text, or base64 of a zlib block behind four integers in base64."""
    kind = np.dtype(TYPES[element.attrib["type"]])
    text = (element.text or "").strip()
    if element.attrib["format"] == "ascii":
        values = np.array(text.split(), dtype=kind)
    else:
        n_blocks = np.frombuffer(base64.b64decode(text[:24]), "<u4", 1)[0]
        if n_blocks != 1:
            raise ValueError("compressed arrays of several blocks are not read")
        values = np.frombuffer(zlib.decompress(base64.b64decode(text[24:])), kind)
    components = int(element.attrib.get("NumberOfComponents", 1))
    return values.reshape(-1, components) if components > 1 else values


class Fields:
    """Hexahedra at one instant: `points` [mm], shape (cells, 8, 3) in VTK's order of vertices, and
    `data` by name, shape (cells, 8) or (cells, 8, 3)."""

    def __init__(self, pieces, time):
        self.time = time
        self.points = np.concatenate([points for points, _ in pieces])
        self.data = {name: np.concatenate([data[name] for _, data in pieces])
                     for name in pieces[0][1]}

    def __len__(self):
        return len(self.points)

    def __getitem__(self, name):
        return self.data[name]

    def take(self, rows):
        """The fields of some cells."""
        chosen = object.__new__(Fields)
        chosen.time, chosen.points = self.time, self.points[rows]
        chosen.data = {name: values[rows] for name, values in self.data.items()}
        return chosen

    def body(self, index):
        return self.take(self.data["body"][:, 0] == index)

    def bodies(self):
        return [int(b) for b in np.unique(self.data["body"])]


def read_piece(path):
    root = ElementTree.parse(path).getroot().find("UnstructuredGrid")
    piece = root.find("Piece")
    points = read_array(piece.find("Points/DataArray")).astype(float)
    cells = {a.attrib["Name"]: read_array(a) for a in piece.find("Cells")}
    if np.any(cells["types"] != 12):
        raise ValueError(f"{path} has cells that are no hexahedra")
    corners = cells["connectivity"].reshape(-1, 8)
    data = {a.attrib["Name"]: read_array(a).astype(float)[corners] for a in piece.find("PointData")}
    return points[corners], data


def read_last_fields(pvd):
    """Fields of the last instant that a .pvd names; None if it names none."""
    instants = ElementTree.parse(pvd).getroot().findall("Collection/DataSet")
    if not instants:
        return None
    last = max(instants, key=lambda instant: float(instant.attrib["timestep"]))
    path = pvd.parent / last.attrib["file"]
    paths = [path]
    if path.suffix == ".pvtu":
        grid = ElementTree.parse(path).getroot().find("PUnstructuredGrid")
        paths = [path.parent / piece.attrib["Source"] for piece in grid.findall("Piece")]
    pieces = [read_piece(piece) for piece in paths]
    pieces = [piece for piece in pieces if len(piece[0]) > 0]
    return Fields(pieces, float(last.attrib["timestep"])) if pieces else None
