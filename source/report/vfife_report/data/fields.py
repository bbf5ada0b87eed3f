# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of a run at its last instant: .vtu files that its .pvd names, or an HDF5 file."""
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

import meshio
import numpy as np

from .files import DamagedFile


# Linear, quadratic and cubic ones in meshio's names; their corners come first.
HEXAHEDRA = {"hexahedron", "hexahedron27", "VTK_LAGRANGE_HEXAHEDRON"}


@dataclass
class Fields:
    """Hexahedra at one instant, corners in VTK's order of vertices."""
    points: np.ndarray  # (cells, 8, 3) [mm]
    data: dict  # by name, (cells, 8) or (cells, 8, 3)
    time: float  # [s]; None at rest

    def __len__(self):
        return len(self.points)

    def __getitem__(self, name):
        return self.data[name]

    def take(self, rows):
        """The fields of some cells."""
        return Fields(self.points[rows], {name: values[rows] for name, values in self.data.items()},
                      self.time)

    def body(self, index):
        return self.take(self.data["body"][:, 0] == index)

    def bodies(self):
        return [int(b) for b in np.unique(self.data["body"])]


def join_pieces(pieces, time):
    """The fields of pieces (points and data each), all with the same data."""
    return Fields(np.concatenate([points for points, _ in pieces]),
                  {name: np.concatenate([data[name] for _, data in pieces]) for name in pieces[0][1]},
                  time)


def has_cells(path):
    """Ranks without cells write pieces without points, which meshio does not read."""
    for _, element in ElementTree.iterparse(path, ["start"]):
        if element.tag == "Piece":
            return int(element.attrib["NumberOfCells"]) > 0
    return False


def read_piece(path, ignored=frozenset()):
    """Corners of the hexahedra of a .vtu file and data at them; those of a cell at all of its corners. Cells of `ignored`
    kinds may stand beside them."""
    try:
        grid = meshio.vtu.read(path)  # meshio.read() ends the program at a damaged file
    except Exception as error:  # of whatever kind: meshio trusts what it reads
        raise DamagedFile(f"{path} is damaged: no grid can be read from it") from error
    kinds = set(grid.cells_dict) - ignored
    if len(kinds) != 1 or not kinds <= HEXAHEDRA:
        raise DamagedFile(f"{path} has cells that are no hexahedra")
    kind = kinds.pop()
    return spread(path, grid.points, grid.cells_dict[kind][:, :8], grid.point_data,
                  {name: values[kind] for name, values in grid.cell_data_dict.items()})


def spread(path, points, corners, point_data, cell_data):
    """Places and data at the corners of hexahedra."""
    if corners.size and not (0 <= corners.min() and corners.max() < len(points)):
        raise DamagedFile(f"{path} is damaged: cells have corners that are not there")
    if not np.all(np.isfinite(points)):
        raise DamagedFile(f"{path} is damaged: coordinates are no numbers")
    # "von mises [MPa]"; versions before wrote names alone.
    data = {name.partition(" [")[0]: np.asarray(values, dtype=float)[corners] for name, values in point_data.items()}
    for name, values in cell_data.items():
        data[name] = np.repeat(np.asarray(values, dtype=float)[:, None], 8, axis=1)
    return np.asarray(points, dtype=float)[corners], data


def read_hdf5(path):
    """Fields of the last instant of an HDF5 file; None if it has none. ImportError without h5py."""
    try:
        import h5py  # noqa: PLC0415 - for those who have such files
    except ImportError as error:
        raise ImportError(f"{path} requires h5py (Debian: python3-h5py)") from error
    try:
        with h5py.File(path, "r") as file:
            last = max(file["instants"].values(), key=lambda instant: instant.attrs["time"], default=None)
            if last is None:
                return None
            data = {name: values[:] for name, values in last.items()}
            mesh = {name: values[:] for name, values in file["mesh"].items()}
            time = float(last.attrs["time"])
        return Fields(*spread(path, data.pop("points"), mesh.pop("cells"), data, mesh), time)
    except (IndexError, KeyError, OSError, RuntimeError, ValueError) as error:  # h5py trusts the file
        raise error if isinstance(error, DamagedFile) else DamagedFile(f"{path} is damaged") from error


def read_meshes(path):
    """Meshes of a file that the kind `mesh` writes; the faces of its surfaces are left out."""
    points, data = read_piece(path, {"quad"})
    return Fields(points, {"body": data["body"]}, None)


def read_fields_of_bodies(paths):
    """The fields of files of a body each that name no instants; None where one has no von Mises stress."""
    pieces = []
    for number, path in enumerate(paths):
        points, data = read_piece(path)
        if "von mises" not in data:
            return None
        pieces.append((points, {"von mises": data["von mises"], "body": np.full(points.shape[:2], float(number))}))
    return join_pieces(pieces, None) if pieces else None


def read_last_fields(pvd):
    """Fields of the last instant of fields.h5, or that a .pvd names; None if there is none or it is empty. DamagedFile
    for one that is damaged."""
    if pvd.suffix == ".h5":
        return read_hdf5(pvd)
    try:
        instants = ElementTree.parse(pvd).getroot().findall("Collection/DataSet")
        if not instants:
            return None
        last = max(instants, key=lambda instant: float(instant.attrib["timestep"]))
        path = pvd.parent / last.attrib["file"]
        paths = [path]
        if path.suffix == ".pvtu":
            grid = ElementTree.parse(path).getroot().find("PUnstructuredGrid")
            paths = [path.parent / piece.attrib["Source"] for piece in grid.findall("Piece")]
        pieces = [read_piece(piece) for piece in paths if has_cells(piece)]
    except (AttributeError, ElementTree.ParseError, KeyError, OSError) as error:
        raise DamagedFile(f"{pvd}, or the file that it names, is damaged") from error
    except ValueError as error:
        raise error if isinstance(error, DamagedFile) else DamagedFile(f"{pvd} is damaged") from error
    return join_pieces(pieces, float(last.attrib["timestep"])) if pieces else None
