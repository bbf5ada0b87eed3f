# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the program is, and how it is called."""
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from .errors import ProgramNotFound

HERE = Path(__file__).resolve().parent
# Of this folder: source/report in a tree, share/vfife/report in an installation, to which Python's folder links.
TREE, PREFIX = HERE.parents[2], HERE.parents[3]
# One rank a process: without threads in BLAS, and on machines that are busy, as the script ./run has it.
ENVIRONMENT = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "OMPI_MCA_btl_base_warn_component_unused": "0",
               "OMPI_MCA_btl_vader_single_copy_mechanism": "none", "OMPI_MCA_hwloc_base_binding_policy": "none",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1", "OMPI_MCA_orte_execute_quiet": "1",
               # of Open MPI 5
               "PRTE_MCA_hwloc_default_binding_policy": "none", "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe"}
AS_ROOT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def list_places():
    """(what, path) where a program may be, first the one that is meant most: named in the environment, built in the
    tree that this package lies in, installed with it, in PATH."""
    named = os.environ.get("VFIFE_PROGRAM")
    if named:
        yield "VFIFE_PROGRAM", Path(named)
    yield "built in the tree of this package", TREE / "build" / "release" / "vfife"
    yield "installed with this package", PREFIX / "bin" / "vfife"
    found = shutil.which("vfife")
    if found:
        yield "PATH", Path(found)


def is_program(path):
    return path.is_file() and os.access(path, os.X_OK)


def find_program(program=None):
    """Path of the program: the one given, else $VFIFE_PROGRAM, that of the build tree, of the installation, in PATH.
    One that is named and is none is an error; ProgramNotFound."""
    if program is not None:
        if not is_program(Path(program)):
            raise ProgramNotFound(f"{program} is no program that can be started")
        return Path(program)
    looked = []
    for what, path in list_places():
        if is_program(path):
            return path
        looked.append(f"{what}: {path}")
        if what == "VFIFE_PROGRAM":
            raise ProgramNotFound(f"VFIFE_PROGRAM names {path}, which is no program that can be started")
    places = "; ".join(looked + ["PATH"])
    raise ProgramNotFound(f"there is no vfife ({places}): build it, or name it by VFIFE_PROGRAM or Case(..., program=)")


def call(program, arguments, ranks=1, show=False):
    """Exit code, what it has printed (empty with `show`, where it goes to the screen), its message."""
    command = [str(program), *arguments]
    environment = {**ENVIRONMENT, **(AS_ROOT if os.geteuid() == 0 else {}), **os.environ}
    if ranks > 1:
        obstacle = find_start_obstacle(environment)
        if obstacle:
            return 2, "", obstacle
        command = ["mpirun", "-np", str(ranks), *command]
    if not show:
        environment["VFIFE_TERMINAL"] = "no"
    done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, stdout=None if show else subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    return done.returncode, done.stdout or "", find_message(done.stderr)


def find_start_obstacle(environment):
    """Why mpirun cannot start, which would report a page of its own; empty where nothing is in its way. The program says
    so by itself."""
    names = ("OMPI_MCA_orte_tmpdir_base", "TMPDIR", "TEMP", "TMP")
    folder = next((environment[name] for name in names if environment.get(name)), "/tmp")
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
        os.rmdir(tempfile.mkdtemp(prefix="vfife-", dir=folder))
    except OSError as error:
        return (f'MPI cannot write to the folder for temporary files "{folder}" ({error.strerror}). '
                "Set TMPDIR to another folder.")
    return ""


def find_message(text):
    """The program's message from its first line on, without what mpirun adds; all that was said where there is none."""
    _, mark, message = f"\n{text}".partition("\nvfife: ")
    message = message.partition("\n" + 40 * "-")[0]
    return (message if mark else text).strip()
