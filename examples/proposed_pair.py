# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
# %% [markdown]
# # A pair from basic data, varied in a loop
#
# A notebook as a script: editors and Jupyter (by jupytext) open its cells, and `python3 examples/proposed_pair.py` runs
# all. `import vfife` finds the package when it is installed, or with `PYTHONPATH=source/report`.

# %%
from pathlib import Path

import numpy as np

import vfife

cases = Path(__file__).resolve().parents[1] / "prm"

# %% [markdown]
# The program proposes blanks and machine settings from tooth numbers and module. A case is a parameter file; `run()`
# does what `Study/kind` says, here the unloaded tooth contact analysis, and `summary` has its figures with units. Without
# `Output/report` a run draws its report, which takes longer than the analysis.

# %%
pair = vfife.Case(cases / "gear/proposed_17_43.prm").set("Output/report", False)
result = pair.run(output="results/proposed")
for name in ("drive side, contact ratio", "drive side, peak to peak"):
    print(name, "=", result.summary[name])

# %% [markdown]
# Tables are columns as numpy arrays: the lag of the gear along the path of contact on the drive side.

# %%
path = result.table("path")
drive = path["side"] == "drive"
lag = path["lag"][drive]
print(f"lag from {lag.min():.2f} to {lag.max():.2f} {path.units['lag']} over {np.ptp(path['pitches'][drive]):.2f} pitches")

# %% [markdown]
# A sweep is a loop. `set()` returns another case, the base stays as it is. The larger the pressure angle, the shorter the
# path of contact.

# %%
ratios = []
for angle in (17.5, 20, 22.5, 25):
    variant = pair.set("Gear pair/Proposal/pressure angle", f"{angle} deg").run(output=f"results/pressure_angle_{angle}")
    ratios.append(variant.summary["drive side, contact ratio"].value)
    print(f"{angle} deg: contact ratio {ratios[-1]:.3f}")

# %% [markdown]
# What is misspelt is answered as on the command line, by an exception with the program's message.

# %%
try:
    pair.set("Gear pair/Proposal/modul", "4 mm").run(output="results/none")
except vfife.InputError as error:
    print(error)

# %% [markdown]
# Explicit dynamics of any model works alike. A bar at 2 m/s hits an equal one at rest: between them is the force
# A rho c v/2 until the wave comes back from the free end.

# %%
bars = vfife.Case(cases / "verification/two_bars.prm").set("Output/report", False)
print(*bars.check().text.splitlines()[:2], sep="\n")
history = bars.run(output="results/bars").history
in_contact = (history["time"] > 10e-6) & (history["time"] < 30e-6)
force = history["contact force total"][in_contact].mean()
wave_speed = np.sqrt(206000 / 7.85e-9)  # mm/s
expected = 25 * 7.85e-9 * wave_speed * 2000 / 2
print(f"force {force:.1f} N, closed form {expected:.1f} N")
