# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of checkpoints from which a run goes on: of a general model with contact, and of a ramp of a gear pair."""
import shutil
import struct
import zlib

from job import ROOT, Job
from mutation import change_bytes, pick

HEADER = struct.Struct("<16sQQQ")  # mark, version of the format, size, CRC-32 of what follows
STEPS = "Dynamics/maximum number of steps="
WORDS = [struct.pack("<Q", n) for n in (0, 1, 2**31, 2**32 - 1, 2**62, 2**64 - 1)] + [
    struct.pack("<d", x) for x in (float("nan"), float("inf"), -1.0, 1e300)]
QUIET = ["--set", "Output/report=no", "--set", "Output/verbosity=quiet", "--set", "Output/field output interval=10"]
SMALL = [f"--set={entry}" for entry in (
    "Model/Body flying/elements x=8", "Model/Body resting/elements x=8", "Dynamics/mass proportional damping=500",
    "Dynamics/end time=60 us", "Output/steps per sample=3")]
# A pair is small enough when its teeth are coarse and few steps are made.
PAIR = [f"--set={entry}" for entry in (
    "Dynamics/start=ramp", "Gear pair/Pinion/Mesh/elements along face width=2",
    "Gear pair/Gear/Mesh/elements along face width=2", "Gear pair/Pinion/Mesh/elements along profile=1",
    "Gear pair/Gear/Mesh/elements along profile=1", "Gear pair/Pinion/Mesh/elements through rim=1",
    "Gear pair/Gear/Mesh/elements through rim=1", "Gear pair/Gear/Body/body type=rim only", "Operation/mesh cycles=1", "Operation/ramp=0.5",
    "Contact/penalty=1071025", "Output/samples per mesh cycle=3")]  # no calibration, which takes seconds


class Seeds:
    def __init__(self, runner, folder):
        folder.mkdir()
        self.folder, self.cases = folder, {
            "bars": (str(ROOT / "prm/verification/two_bars.prm"), SMALL, 12, 20),
            "pair": (str(ROOT / "prm/spiral_bevel_quick.prm"), PAIR, 4, 6)}
        for name, (case, more, first, _) in self.cases.items():
            runner.run_good(folder, case, "-o", name, *more, *QUIET, "--set", f"{STEPS}{first}")

    @staticmethod
    def find_state(content):
        """Where the state begins: behind the first part, which has version, parameters and size of the log. A part is
        its name and its bytes, each with its size before it."""
        place = 0
        for _ in range(2):
            place += 8 + struct.unpack_from("<Q", content, place)[0]
        return place

    def mutate_content(self, rng, content):
        """What stands behind the header, to which a right checksum is made. Mostly values of the state: the texts before
        it are compared, and nothing is used before its size."""
        state = self.find_state(content)
        content = bytearray(content)
        notes = []
        if rng.random() < 0.75:
            for _ in range(pick(rng, [1, 1, 1, 2])):
                place = rng.randrange(state, len(content) - 8)
                if rng.random() < 0.5:  # small whole numbers are counts and indices
                    for offset in range(place, min(place + 20000, len(content) - 8)):
                        if 0 < struct.unpack_from("<Q", content, offset)[0] < 100000:
                            place = offset
                            break
                if rng.random() < 0.3:
                    content[place] ^= 1 << rng.randrange(8)
                    notes.append(f"a bit of byte {place}")
                else:
                    word = pick(rng, WORDS)[:pick(rng, [1, 4, 8, 8])]
                    content[place:place + len(word)] = word
                    notes.append(f"{word.hex()} at byte {place}")
            return "; ".join(notes), bytes(content)
        for _ in range(pick(rng, [1, 1, 2, 5])):
            if rng.random() < 0.5:
                note, changed = change_bytes(rng, content)
                content = bytearray(changed)
                notes.append(note)
                continue
            # Counts stand near the ends and between the fields.
            place = rng.randrange(max(len(content) - 8, 1))
            word = pick(rng, WORDS)
            content[place:place + 8] = word
            notes.append(f"{word.hex()} at byte {place}")
        return "; ".join(notes), bytes(content)

    def make(self, rng, folder):
        name = pick(rng, ["bars", "bars", "pair"])
        case, more, _, last = self.cases[name]
        out = folder / "out"
        out.mkdir()
        for path in (self.folder / name).iterdir():
            if path.is_file() and path.name not in ("checkpoint.bin", "checkpoint.previous.bin"):
                shutil.copyfile(path, out / path.name)
        if rng.random() < 0.9:
            shutil.copytree(self.folder / name / "fields", out / "fields")
        content = (self.folder / name / "checkpoint.bin").read_bytes()
        if rng.random() < 0.2:
            note, content = change_bytes(rng, content)
        else:
            mark, version, _, _ = HEADER.unpack_from(content)
            note, body = self.mutate_content(rng, content[HEADER.size:])
            content = HEADER.pack(mark, version, len(body), zlib.crc32(body)) + body
            note += " (right checksum)"
        (out / "checkpoint.bin").write_bytes(content)
        return Job(folder, [case, "--restart", "-o", "out", *more, *QUIET, "--set", f"{STEPS}{last}"], f"{name}: {note}")
